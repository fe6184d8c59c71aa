// SPDX-License-Identifier: MIT
// Triangles of a mesh in one plane that hang together by edges: one polygon, named by its lowest triangle. Most meshes
// that cut have none of more than one triangle; these cost nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/disjoint_sets.h"

namespace firma {

class MeshPolygons {
public:
    /// Each triangle is a polygon of its own.
    void clear();
    /// @param sets  of the triangles
    void set(DisjointSets& sets, std::size_t triangles);

    /// Whether one has more than one triangle.
    bool any() const { return !of_.empty(); }
    std::uint32_t of(std::uint32_t triangle) const { return of_.empty() ? triangle : of_[triangle]; }
    bool is_one(std::uint32_t triangle, std::uint32_t other) const { return of(triangle) == of(other); }

    /// Calls `take` for each triangle of a polygon; for none where the number names no polygon.
    template <class Take>
    void for_each(std::uint32_t polygon, const Take& take) const {
        if (of_.empty()) return take(polygon);
        for (std::uint32_t k = first_[polygon]; k < first_[polygon + 1]; ++k) take(members_[k]);
    }
    std::uint32_t count(std::uint32_t polygon) const { return of_.empty() ? 1 : first_[polygon + 1] - first_[polygon]; }

private:
    std::vector<std::uint32_t> of_, first_, members_;  ///< empty while each is a polygon of its own
};

}  // namespace firma

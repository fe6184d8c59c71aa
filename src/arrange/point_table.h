// SPDX-License-Identifier: MIT
// All points where planes of what is arranged meet, each once, whichever of its planes named it.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/plane_table.h"
#include "base/flat_map.h"

namespace firma {

class PointTable {
public:
    explicit PointTable(const PlaneTable& planes) : planes_(planes) {}

    /// The point in which three planes meet, exact_turn() of which is not 0.
    /// @return its number; kNone when it lies outside the world
    std::uint32_t add(PlaneId a, PlaneId b, PlaneId c);
    static constexpr std::uint32_t kNone = ~0u;
    /// A point of the input grid.
    std::uint32_t add(const InputPoint& grid);

    const ExactPoint& point(std::uint32_t index) const { return points_[index].point; }
    /// Of one that is not on_grid().
    PlaneId plane(std::uint32_t index, int k) const { return points_[index].planes[k]; }
    std::size_t size() const { return points_.size(); }

    /// The side of a plane that a point lies on.
    int side(PlaneId plane, std::uint32_t index) const;

private:
    struct Entry {
        ExactPoint point;
        PlaneId planes[3];
    };

    std::uint32_t find_or_add(const Entry& entry);
    bool same(const Entry& a, const Entry& b) const;

    const PlaneTable& planes_;
    std::vector<Entry> points_;
    FlatMap of_planes_, of_place_;
};

}  // namespace firma

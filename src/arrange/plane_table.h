// SPDX-License-Identifier: MIT
// All planes of what is arranged, each once: equal planes have equal numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "base/flat_map.h"
#include "solid/solid_face.h"

namespace firma {

/// Twice the number of a plane; one more for the same plane seen from behind.
using PlaneId = std::uint32_t;

inline constexpr PlaneId kNoPlane = ~0u;

inline PlaneId from_behind(PlaneId plane) {
    return plane ^ 1;
}
/// Whichever way it is looked at.
inline bool same_plane(PlaneId a, PlaneId b) {
    return (a ^ b) <= 1;
}

class PlaneTable {
public:
    /// @param plane  valid()
    PlaneId add(const Plane& plane);

    const Plane& plane(PlaneId id) const { return planes_[id]->plane; }
    const Ref<const SolidPlane>& stored(PlaneId id) const { return planes_[id]; }
    std::size_t size() const { return planes_.size() / 2; }

private:
    std::vector<Ref<const SolidPlane>> planes_;
    FlatMap of_hash_;
};

}  // namespace firma

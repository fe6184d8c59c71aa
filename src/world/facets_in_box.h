// SPDX-License-Identifier: MIT
// Goes through the facets of a world that lie near a box.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/grid_box.h"
#include "index/traverse.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma {

/// A visitor of traverse().
template <class Visit>
struct FacetsInBox {
    const Vec3 low, high;  ///< metres
    const Visit& visit;
    bool ended = false;

    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (high[axis] < double(box.low[axis]) || low[axis] > double(box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (!visit(block, slot)) return ended = true;
        return false;
    }
};

/// @param roots  null ones have no facets
/// @param visit  (block, slot): is shown also facets that the box does not meet; false ends it
/// @return whether it went to the end
template <class Roots, class Visit>
bool facets_in_box(const Roots& roots, const GridBox& box, const Visit& visit) {
    FacetsInBox<Visit> show{to_metres(box.low), to_metres(box.high), visit};
    for (const Node* root : roots)
        if (root && !show.ended) traverse(*root, show);
    return !show.ended;
}

/// The solid's facets, and those that are castable only.
inline std::array<const Node*, 2> all_facets(const WorldData& data) {
    return {data.solid.data().faces.root.get(), data.castable.root.get()};
}

}  // namespace firma

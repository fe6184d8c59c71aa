// SPDX-License-Identifier: MIT
// Eight boxes side by side: what a node is read by. Each leads to items of the node, or to more boxes over some of
// them.
//
// Sides are floats, rounded outward once, when a node is made: every processor reads the same boxes.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/grid_box.h"
#include "index/box_f.h"

namespace firma {

/// All that casts read, in whole lines of a cache. What a lane leads to is kept alive by the Node that holds this one,
/// which also has its LaneItems.
struct WideNode {
    static constexpr std::uint32_t kLanes = 8;
    static constexpr std::uintptr_t kFacets = 1;  ///< where things begin, this bit is free

    /// Box k holds the points from side[0][axis][k] to side[1][axis][k], metres. Those beyond the ones in use hold
    /// none.
    float side[2][3][kLanes];
    /// Where what a lane leads to begins. Of facets the first FaceLanes, null over what has none, and kFacets; of a
    /// node its first wide node; else a wide node of the same Node. Of lanes beyond 0.
    std::uintptr_t below[kLanes];

    BoxF box(std::uint32_t lane) const {
        return {{side[0][0][lane], side[0][1][lane], side[0][2][lane]},
                {side[1][0][lane], side[1][1][lane], side[1][2][lane]}};
    }

    bool leads_to_facets(std::uint32_t lane) const { return (below[lane] & kFacets) != 0; }
    const void* facets(std::uint32_t lane) const { return reinterpret_cast<const void*>(below[lane] - kFacets); }
    const WideNode* wide(std::uint32_t lane) const { return reinterpret_cast<const WideNode*>(below[lane]); }

    void lead_to_facets(std::uint32_t lane, const void* first) {
        below[lane] = reinterpret_cast<std::uintptr_t>(first) + kFacets;
    }
    void lead_to(std::uint32_t lane, const WideNode* node) { below[lane] = reinterpret_cast<std::uintptr_t>(node); }
};

static_assert(sizeof(void*) != 8 || sizeof(WideNode) == 256);

/// Which items of a Node the lanes of one of its wide nodes lead to: from first[lane] to first[lane + 1]. Apart, as
/// casts do not ask for it.
struct LaneItems {
    std::uint8_t first[WideNode::kLanes + 1] = {};  ///< rising; the last stands after the lanes in use
    std::uint8_t count = 0;                         ///< lanes in use, from the first on

    std::uint32_t items(std::uint32_t lane) const { return std::uint32_t(first[lane + 1]) - first[lane]; }
};

/// Puts boxes around the given ones into a node; lanes beyond are empty. None leads anywhere.
/// @param boxes  1 to 8
void set_boxes(WideNode& node, std::span<const GridBox* const> boxes);

/// A bit for each lane whose box meets this one, exactly.
unsigned lanes_meeting(const WideNode& node, const GridBox& box);
/// A bit for each lane whose box holds this one, exactly.
unsigned lanes_around(const WideNode& node, const GridBox& box);

}  // namespace firma

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

/// What a lane leads to is kept alive by the Node that holds this one. Its items are those of the Node from
/// first[lane] to first[lane + 1].
struct WideNode {
    static constexpr std::uint32_t kLanes = 8;

    /// Box k holds the points from side[0][axis][k] to side[1][axis][k], metres. Those beyond the ones in use hold
    /// none.
    float side[2][3][kLanes];
    /// Of facets the first FaceLanes, null where Firma is compiled without; of a node its first wide node; else a wide
    /// node of the same Node.
    const void* child[kLanes];
    std::uint16_t facets[kLanes];    ///< of facets how many FaceLanes in a row, 1 without; else 0
    std::uint8_t first[kLanes + 1];  ///< rising; the last stands after the lanes in use
    std::uint8_t count = 0;          ///< lanes in use, from the first on
    std::uint8_t unused[sizeof(void*) == 8 ? 38 : 6] = {};  // so that nodes fill lines of a cache

    BoxF box(std::uint32_t lane) const {
        return {{side[0][0][lane], side[0][1][lane], side[0][2][lane]},
                {side[1][0][lane], side[1][1][lane], side[1][2][lane]}};
    }

    bool leads_to_facets(std::uint32_t lane) const { return facets[lane] > 0; }
    /// Over nodes: whether a lane leads to one of them, not to more boxes.
    bool leads_to_node(std::uint32_t lane) const { return facets[lane] == 0 && items(lane) == 1; }
    std::uint32_t items(std::uint32_t lane) const { return std::uint32_t(first[lane + 1]) - first[lane]; }
};

static_assert(sizeof(WideNode) % 64 == 0);

/// Puts boxes around the given ones into a node; lanes beyond are empty. All else is left to the caller.
/// @param boxes  1 to 8
void set_boxes(WideNode& node, std::span<const GridBox* const> boxes);

/// A bit for each lane whose box meets this one, exactly.
unsigned lanes_meeting(const WideNode& node, const GridBox& box);
/// A bit for each lane whose box holds this one, exactly.
unsigned lanes_around(const WideNode& node, const GridBox& box);

}  // namespace firma

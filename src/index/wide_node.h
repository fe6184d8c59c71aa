// SPDX-License-Identifier: MIT
// Eight boxes side by side, as casts read an index: the bins of a node, several levels of them at once.
//
// Coordinates are whole steps of a power of two from a corner, so that a float product has no rounding and every
// processor reads the same boxes.
#pragma once

#include <cstdint>
#include <span>

#include "index/bin.h"

namespace firma {

/// What a child leads to is kept alive by the Node that holds this one.
struct WideNode {
    static constexpr std::uint32_t kLanes = 8;

    /// Box k holds the points from base + scale * side[0][axis][k] to base + scale * side[1][axis][k].
    std::uint8_t side[2][3][kLanes];
    float base[4], scale[4];       ///< the fourth is not used
    std::uint32_t count = 0;       ///< lanes in use, from the first on
    std::uint16_t facets[kLanes];  ///< 0: the child is a wide node; else so many FaceLanes in a row
    const void* child[kLanes];

    /// A side as every reader computes it.
    float at(int which, int axis, std::uint32_t lane) const {
        return base[axis] + scale[axis] * float(side[which][axis][lane]);
    }
};

/// Puts boxes around the given ones into a node; lanes beyond are empty. Children are left to the caller.
/// @param boxes  1 to 8
void set_boxes(WideNode& node, std::span<const BoxF> boxes);

}  // namespace firma

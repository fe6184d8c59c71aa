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

/// A child is another wide node of the same Node, by number, or an item: whatever its maker says.
struct WideNode {
    static constexpr std::uint32_t kLanes = 8;
    static constexpr std::uint32_t kItem = 1u << 31;  ///< bit of `child`

    /// Box k holds the points from base + scale * side[0][axis][k] to base + scale * side[1][axis][k].
    std::uint8_t side[2][3][kLanes];
    float base[3], scale[3];
    std::uint32_t child[kLanes];
    std::uint32_t count = 0;

    /// A side as every reader computes it.
    float at(int which, int axis, std::uint32_t lane) const {
        return base[axis] + scale[axis] * float(side[which][axis][lane]);
    }
};

/// Puts boxes around the given ones into a node; lanes beyond are empty. Children are left open.
/// @param boxes  1 to 8
void set_boxes(WideNode& node, std::span<const BoxF> boxes);

}  // namespace firma

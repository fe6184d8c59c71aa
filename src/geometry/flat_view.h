// SPDX-License-Identifier: MIT
// An axis that a plane is seen along.
#pragma once

namespace firma {

/// Where a plane is seen from: what is counter-clockwise about the axis, or about its negative when flipped, comes out
/// counter-clockwise.
struct FlatView {
    int axis = 2;
    bool flip = false;

    /// The axes that become u and v.
    int u() const { return (axis + (flip ? 2 : 1)) % 3; }
    int v() const { return (axis + (flip ? 1 : 2)) % 3; }
};

}  // namespace firma

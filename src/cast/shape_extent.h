// SPDX-License-Identifier: MIT
// A simple body around a shape that moves: what lanes leave faces out by.
#pragma once

#include <array>

#include "firma/vec.h"

namespace firma {

/// All points within a radius of middle + x axis[0] + y axis[1] + z axis[2], with x, y and z from -1 to 1: a ball, a
/// capsule or a box grown by a radius. It holds the shape; where rounding put the shape's corners is in the radius.
struct ShapeExtent {
    Vec3 middle;  ///< from where the sweep starts, metres
    std::array<Vec3, 3> axis;
    int axes = 0;  ///< how many count: 0, 1 or 3
    double radius = 0;
};

}  // namespace firma

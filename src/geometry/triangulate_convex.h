// SPDX-License-Identifier: MIT
// Triangles of a convex polygon, none of them without area, though corners may lie along its sides.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"

namespace firma {

/// @param corners    convex, counter-clockwise, with area [3 <= count]
/// @param triangles  gets count - 2 triangles as indices of corners, counter-clockwise; none where all corners are in
///                   line. What was there stays
void triangulate_convex(std::span<const GridPoint> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace firma

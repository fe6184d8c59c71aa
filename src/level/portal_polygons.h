// SPDX-License-Identifier: MIT
// Makes polygons of the triangles that a portal was drawn by.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "firma/grid.h"

namespace firma {

/// Triangles that share sides and a plane, exactly, become their outline where that is convex and has at most 64
/// corners, else triangles on it.
///
/// @param triangles  snapped to the input grid; those without area are left out
/// @return polygons in order of their first triangle's plane
std::vector<std::vector<GridPoint>> portal_polygons(std::span<const std::array<GridPoint, 3>> triangles);

}  // namespace firma

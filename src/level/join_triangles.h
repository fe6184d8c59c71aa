// SPDX-License-Identifier: MIT
// Joins the triangles of one flat surface back into the polygons that they were made from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"

namespace firma {

/// Compilers of levels divide flat surfaces into triangles, with folded slivers among them where corners were moved to
/// a grid; what the triangles cover, each point counted by the way they face, is what their outline does.
///
/// @param triangles  three corners each, indices into `points`; all of one surface that is flat but for rounding
/// @return the surface in fewer polygons, corner lists one after the other. An island of triangles becomes its outline;
/// but its
///         triangles stay when it has holes, more than kMaxOutlineCorners, or a corner inside that is off the exact
///         plane of the outline. Corners along an outline stay: no T-joint is made.
std::vector<std::vector<std::uint32_t>> join_triangles(std::span<const std::uint32_t> triangles,
                                                       std::span<const GridPoint> points);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Whether a point in a polygon's plane lies in the polygon, or so near to its rim that rounding may hide that it does:
// of points of three planes, by their rounded ones.
#pragma once

#include <cstdint>
#include <span>

#include "firma/grid.h"
#include "geometry/exact_plane.h"

namespace firma {

/// @param points  rounded corners of all loops in a row, `ends` where each ends
/// @param plane   of the polygon, for its dominant axis
/// @param p       rounded, within a step of the plane
/// @return true inside, counted by crossings, and within two steps of a side as seen along the axis
bool touches_polygon(std::span<const GridPoint> points, std::span<const std::uint32_t> ends, const Plane& plane,
                     const GridPoint& p);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Planes through points of the surface grid, which is finer than the one that planes of solids come from: for polygons
// that are castable only, whose corners may lie there.
#pragma once

#include <span>

#include "geometry/exact_plane.h"

namespace firma {

/// The plane of a polygon that is exactly planar, seen from its front: counter-clockwise. Not valid() where its numbers
/// would be larger than those of planes are: never so of a polygon of at most 16 m along each axis.
Plane surface_plane(std::span<const GridPoint> corners);

/// As edge_plane().
/// @param face  a plane that holds both points
Plane surface_edge_plane(const GridPoint& a, const GridPoint& b, const Plane& face);

/// Where an axis has one surface coordinate.
Plane surface_axis_plane(int axis, std::int32_t at);

/// A plane parallel to one and at most 2^-16 input steps away from it.
/// @param way  1: in front of it, -1: behind
Plane plane_beside(const Plane& plane, int way);

}  // namespace firma

// SPDX-License-Identifier: MIT
// How far a surface is from the nearest of a set of spheres, at most.
#pragma once

#include <span>
#include <vector>

#include "body/surface_points.h"
#include "firma/polygon.h"

namespace firma {

struct CoverError {
    double at_most = 0;  ///< metres: proven for every point of the surface
    /// Points that are farther than asked for, at most one in each triangle and none near another, farthest first.
    std::vector<Vec3> too_far;
};

/// Triangles are halved where they may hold the farthest point, until it is known within `tolerance`.
/// @param triangles  some
/// @param spheres    some
/// @param allowed    metres: what is nearer than this is near enough
/// @param tolerance  metres, > 0: at_most is no more than this above the true value, unless that would take very long
CoverError cover_error(std::span<const SurfaceTriangle> triangles, std::span<const Sphere> spheres, double allowed,
                       double tolerance);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Points spread over the surface of a solid, and its triangles.
#pragma once

#include <array>
#include <vector>

#include "firma/solid.h"
#include "firma/vec.h"

namespace firma {

/// Metres, counter-clockwise seen from outside.
using SurfaceTriangle = std::array<Vec3, 3>;

/// A point of the surface, with the unit normal that looks out.
struct SurfacePoint {
    Vec3 at, normal;
};

/// Of facets with an area, fan by fan.
std::vector<SurfaceTriangle> triangles_of(const Solid& solid);

double area_of(const SurfaceTriangle& triangle);

/// Each once.
std::vector<Vec3> corners_of(const std::vector<SurfaceTriangle>& triangles);

/// Points about `spacing` apart along the sides of triangles, each side once.
std::vector<Vec3> side_points(const std::vector<SurfaceTriangle>& triangles, double spacing);

/// Points about `spacing` apart, in rows along the longest side of each triangle; at least one in each.
std::vector<SurfacePoint> surface_points(const std::vector<SurfaceTriangle>& triangles, double spacing);

}  // namespace firma

// SPDX-License-Identifier: MIT
// The largest ball inside a solid that touches its surface at a point.
#pragma once

#include <optional>

#include "body/point_cloud.h"
#include "body/surface_points.h"
#include "firma/polygon.h"
#include "firma/solid.h"

namespace firma {

/// Its radius is rounded down: no point of the ball is nearer to a facet than rounding reaches.
/// @param samples  points of the surface: the more, the fewer searches for facets
/// @param at       a point of the surface
/// @param reach    metres: no ball of the solid is larger
/// @return nothing where there is no room, in corners
/// Source: J. Ma, S. W. Bae, S. Choi, 3D medial axis point approximation using nearest neighbors and the normal field,
/// 2012.
std::optional<Sphere> inner_ball(const Solid& solid, const PointCloud& samples, const SurfacePoint& at, double reach);

/// A ball inside that is about as large as any with a centre near this one's: where its centre moves, step by step, as
/// long as it grows.
Sphere grown_ball(const Solid& solid, const PointCloud& samples, double reach, Sphere ball);

}  // namespace firma

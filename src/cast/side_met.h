// SPDX-License-Identifier: MIT
// Rays that tell where a point lies: which ways they go, and which side of a polygon they met.
#pragma once

#include "cast/contact.h"
#include "cast/sweep.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// Ways that hardly graze anything, to be tried in turn.
inline constexpr Vec3 kRayWays[] = {{0.36, 0.48, 0.80},   {-0.48, 0.64, -0.60}, {0.60, -0.64, 0.48},
                                    {-0.28, -0.96, 0.02}, {0.96, 0.03, -0.28},  {0.02, 0.28, 0.96},
                                    {-0.8, -0.36, -0.48}, {0.64, 0.6, -0.48}};

/// A ray that meets a polygon at a smaller sine than this grazes it.
inline constexpr double kGrazingSine = 0.01;

/// The side of a polygon that a ray met: 1 its front, -1 its back. 0 where the ray says little: it grazes the polygon,
/// or passes so near to its rim that rounding decides which of two neighbours is met first; of a surface that a ray
/// only grazes, either may be.
/// @param rim  metres
int side_met(const Sweep& ray, const PolygonShape& polygon, const Contact& contact, double rim);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Whether a sweep reaches a portal.
#pragma once

#include "cast/sweep.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// Whether the moving sphere may touch a polygon, and when at the earliest. Never says no of one that it touches, by
/// any contact the narrow phase computes: what it looks at is the polygon grown to a prism, by `grown` on all sides, so
/// it may say yes a little beyond the corners.
///
/// @param grown    grown_radius() of the sweep
/// @param latest   in the sweep's parameter
/// @param nearest  set to a lower bound for the touch
bool reaches_portal(const Sweep& sweep, const PolygonShape& polygon, double grown, double latest, double& nearest);

}  // namespace firma

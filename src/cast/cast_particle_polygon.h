// SPDX-License-Identifier: MIT
// A particle against a polygon: whether it meets it is decided exactly, only the fraction is rounded.
#pragma once

#include "cast/contact.h"
#include "cast/sweep.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// Whether the line of the sweep passes through the closed polygon, exactly, for a path that leads through its plane.
///
/// @param facing  sign of direction . normal, not 0
bool line_meets_polygon(const Sweep& sweep, const PolygonShape& polygon, int facing);

/// The centre of the sweep as a particle, whatever its radius. `facing` as above, or 0 for a path along the plane,
/// which meets the polygon's rim when it runs in the plane itself.
Contact cast_particle_polygon(const Sweep& sweep, const PolygonShape& polygon, int facing);

}  // namespace firma

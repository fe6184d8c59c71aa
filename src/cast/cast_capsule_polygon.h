// SPDX-License-Identifier: MIT
// A moving capsule against a polygon: the earliest of its ends, as spheres, and of its side.
#pragma once

#include "cast/capsule_shape.h"
#include "cast/contact.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// The first touch of a capsule with a polygon that has area. Of a capsule whose ends are one: the sphere's.
///
/// @param around  of the ball around it
/// @param latest  in the sweep's parameter: a touch after it need not be found
/// @param counts  may be null; `precise` is added to
Contact cast_capsule_polygon(const Sweep& around, const CapsuleShape& capsule, const PolygonShape& polygon, Sides sides,
                             double latest, CastCounts* counts = nullptr);

/// The touch dressed up.
PolygonHit make_capsule_hit(const Sweep& around, const CapsuleShape& capsule, const PolygonShape& polygon,
                            const Contact& contact);

}  // namespace firma

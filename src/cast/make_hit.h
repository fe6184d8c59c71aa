// SPDX-License-Identifier: MIT
// A contact dressed up: centre, point and normals, computed once for the touch that counts.
#pragma once

#include "cast/contact.h"
#include "cast/sweep.h"
#include "geometry/polygon_shape.h"

namespace firma {

PolygonHit make_hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact);

/// How far to go so that `contact_offset` is kept along the contact normal: fraction - contact offset / -(normal .
/// path), within 0..fraction.
double safe_fraction(const Sweep& sweep, const PolygonHit& hit, double contact_offset);

}  // namespace firma

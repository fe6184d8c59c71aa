// SPDX-License-Identifier: MIT
// A hull's contact dressed up: where it touches, and along which normal.
#pragma once

#include "cast/cast_hull_polygon.h"

namespace firma {

/// @param found  a touch of this hull with this polygon on this sweep
PolygonHit make_hull_hit(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon,
                         const HullContact& found);

/// Where the hull of this hit touches this polygon: see contact_points().
ContactPoints points_of_contact(const HullShape& hull, const PolygonHit& hit, const PolygonShape& polygon);

}  // namespace firma

// SPDX-License-Identifier: MIT
// A hull's contact dressed up: where it touches, and along which normal.
#pragma once

#include "cast/cast_hull_polygon.h"
#include "cast/way_out.h"

namespace firma {

/// @param found  a touch of this hull with this polygon on this sweep
PolygonHit make_hull_hit(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon,
                         const HullContact& found);

/// Where the hull of this hit touches this polygon: see contact_points().
/// Of a hull that shares a point with the polygon where it starts. Its closest point is one where it still touches when
/// it is out, at distance 0.
/// @param along_normal  the only way is along the polygon's normal; else the shortest is taken
WayOut way_out_of_hull(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon, bool along_normal);

ContactPoints points_of_contact(const HullShape& hull, const PolygonHit& hit, const PolygonShape& polygon);

}  // namespace firma

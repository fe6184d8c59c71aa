// SPDX-License-Identifier: MIT
// How a capsule's segment lies to a polygon: where on it the nearest point is, what the capsule has to do with the
// polygon before it moves, and how it gets out of it.
#pragma once

#include "cast/capsule_shape.h"
#include "cast/start_contact.h"
#include "cast/way_out.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// Points of the segment as A + part s.
struct NearestOnAxis {
    double distance = 0;
    double part = 0;  ///< in 0..1; the middle of all nearest, to rounding
    /// The first of the nearest pairs: an end and the polygon, the inside and a corner, or the insides of the segment
    /// and a side.
    enum Kind : unsigned char { kEndA, kEndB, kCorner, kSide } kind = kEndA;
    std::uint32_t index = 0;  ///< of the corner or side
};

/// In double, of the segment from a to a + s.
/// @param a  less the polygon's first corner
NearestOnAxis nearest_on_axis(const Vec3& a, const Vec3& s, const PolygonShape& polygon);

struct CapsuleStart : StartContact {
    /// The segment shares a point with the polygon: `out` is the nearest way out of all facets of the sum of polygon
    /// and turned segment that the path leads against.
    bool pierces = false;
    Vec3 out;           ///< unit, of kInitialOverlap
    bool plane = true;  ///< `out` is along the polygon's normal; else across the side contact.index
};

/// @param facing  sign of direction . normal
CapsuleStart capsule_start(const CapsuleSweep& capsule, const PolygonShape& polygon, int facing);

/// Whether a capsule that is not a sphere shares a point with the polygon, as starts are decided.
bool capsule_meets(const CapsuleSweep& capsule, const PolygonShape& polygon);

/// Of one that does.
/// @param along_normal  the only way is along the polygon's normal; else the shortest is taken
WayOut way_out_of_capsule(const CapsuleSweep& capsule, const PolygonShape& polygon, bool along_normal);

}  // namespace firma

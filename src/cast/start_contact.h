// SPDX-License-Identifier: MIT
// What a sphere has to do with a polygon before it moves.
#pragma once

#include "cast/contact.h"
#include "cast/sweep.h"
#include "geometry/polygon_shape.h"

namespace firma {

struct StartContact {
    enum Kind : unsigned char {
        kApart,           ///< farther than the radius
        kInitialOverlap,  ///< at most the radius away, and coming closer
        kIgnored,         ///< at most the radius away, and never coming closer: the distance is convex along the path
    };
    Kind kind = kApart;
    Contact contact;  ///< of kInitialOverlap
};

/// @param facing  sign of direction . normal
/// The distance is compared with the radius, and its change with zero, in double-double where double leaves them open.
StartContact start_contact(const Sweep& sweep, const PolygonShape& polygon, int facing);

}  // namespace firma

// SPDX-License-Identifier: MIT
// The first touch of a shape with one face of a part that turns.
//
// Let n be a direction along which the shape is apart from the face. g_i(t) = n . y_i(t) - max n . f, of the shape's
// corners y_i and the face's f, are then lower bounds of the distance whose least one is the distance now, and each
// bends by at most b = max |y''|:
//     g_i(t + h) >= g_i(t) + g_i'(t) h - b h^2 / 2
// So up to the least h at which one of these parabolas falls to a level, the distance is above that level. From there
// the nearest points are looked for anew, until the distance, as far as the nearest points are apart, is within
// touch_of(). Levels are half of that: so nothing is passed, and each step but the last gains on a level by as much.
// Without a turn b is 0, and parabolas are lines.
// Source: B. Mirtich, Timewarp Rigid Body Simulation, 2000, and E. Catto, Continuous Collision, GDC 2013 (advancing by
// separating directions); with the bound on bending no root needs to be searched for.
#pragma once

#include <cstdint>

#include "firma/moving_parts.h"
#include "geometry/polygon_shape.h"
#include "moving/turning_shape.h"

namespace firma {

/// Metres: so near is in touch, and so early a touch may be.
inline double touch_of(const TurningShape& shape) {
    return shape.angle > 0 ? kPartTouch : kTurnedHullTouch;
}

/// In the part's frame.
struct TurningTouch {
    bool found = false;
    double time = 0;
    Vec3 normal;       ///< unit, from the face toward the shape
    Vec3 point;        ///< of the shape's core (its corners' hull), nearest to the face
    double speed = 0;  ///< along the normal, of what touches: metres from fraction 0 to 1, below 0: it comes nearer
};

/// @param two_sided  met from behind as well
/// @param bend       TurningShape::bend(from, to)
/// @param steps      that may be made, made less by those that were: when none is left, it counts as met
/// @return the first touch between two times, both included; what is in touch at `from` counts as left alone before
TurningTouch touch_turning(const TurningShape& shape, const PolygonShape& face, bool two_sided, double from, double to,
                           double bend, std::int64_t& steps);

}  // namespace firma

// SPDX-License-Identifier: MIT
// What a sphere has to do with a polygon before it moves.
#include "cast/start_contact.h"

#include "cast/nearness.h"
#include "geometry/rounding.h"

namespace firma {

StartContact start_contact(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const Vec3 w = sweep.start - polygon.corners[0];
    const Closest closest = closest_to(w, polygon);
    const double error = rounding(64) * (length(w) + length(closest.offset));
    if (closest.distance - error > sweep.radius) return {};
    const Nearness near = nearness(sweep.start, sweep.radius, sweep.direction, facing, polygon, closest);
    if (!near.within) return {};
    const bool closer = near.on_it ? facing != 0 : near.change < 0;
    if (!closer) return {StartContact::kIgnored, {}};
    return {StartContact::kInitialOverlap, {Status::kInitialOverlap, closest.feature, closest.index, 0}};
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// A contact dressed up.
#include "cast/make_hit.h"

#include "geometry/closest_point.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// The face's normal on the side the mover comes from; along the plane, the side it is on.
Vec3 normal_toward_mover(const Sweep& sweep, const PolygonShape& polygon, const Vec3& unit_normal) {
    int away = exact_facing(sweep.direction, polygon);
    if (away == 0) away = -exact_plane_side(sweep.start, polygon);
    return away > 0 ? -unit_normal : unit_normal;
}

}  // namespace

// The time says when; where, is the point nearest to the centre then. Features that are met at the same time, to
// rounding, need not be the same place: past an edge's end the times of edge and vertex differ by the square of the
// distance between them only.
PolygonHit make_hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) {
    const Vec3 centre = (sweep.start - polygon.corners[0]) + sweep.direction * contact.t;  // from the first corner
    // A particle that crosses the plane is known to cross it within the polygon, however near to an edge.
    const bool along_the_plane = contact.feature == Feature::kEdge;
    const Closest closest = sweep.radius > 0  ? closest_to(centre, polygon)
                            : along_the_plane ? closest_on_rim(centre, polygon)
                                              : foot_on_plane(centre, polygon);

    PolygonHit hit;
    hit.status = contact.status;
    hit.fraction = sweep.fraction(contact.t);
    hit.centre = sweep.at(contact.t);
    hit.point = polygon.corners[0] + closest.offset;
    hit.face_normal = polygon.unit_normal();
    hit.normal = normal_toward_mover(sweep, polygon, hit.face_normal);
    hit.feature = contact.feature;
    hit.feature_index = contact.index;
    if (sweep.radius == 0) return hit;
    hit.feature = closest.feature;
    hit.feature_index = closest.index;
    const double noise = rounding(64) * (length(centre) + length(closest.offset));
    if (closest.distance <= noise) return hit;
    if (closest.feature != Feature::kFace)
        hit.normal = closest.away * (1 / closest.distance);
    else  // from the point toward the centre, whichever way it goes
        hit.normal = dot(closest.away, hit.face_normal) < 0 ? -hit.face_normal : hit.face_normal;
    return hit;
}

double safe_fraction(const Sweep& sweep, const PolygonHit& hit, double contact_offset) {
    const double closing = -dot(hit.normal, sweep.direction) * sweep.end;
    if (!(closing > 0)) return contact_offset > 0 ? 0 : hit.fraction;
    const double safe = hit.fraction - contact_offset / closing;
    return safe > 0 ? safe : 0;
}

}  // namespace firma

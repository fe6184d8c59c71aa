// SPDX-License-Identifier: MIT
// A contact dressed up.
#include "cast/make_hit.h"

#include "geometry/exact_predicates.h"

namespace firma {
namespace {

/// The face's normal on the side the mover comes from; along the plane, the side it is on.
Vec3 normal_toward_mover(const Sweep& sweep, const PolygonShape& polygon, const Vec3& unit_normal) {
    int away = exact_facing(sweep.direction, polygon);
    if (away == 0) away = -exact_plane_side(sweep.start, polygon);
    return away > 0 ? -unit_normal : unit_normal;
}

}  // namespace

PolygonHit make_hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) {
    PolygonHit hit;
    hit.status = contact.status;
    hit.feature = contact.feature;
    hit.feature_index = contact.index;
    hit.fraction = sweep.fraction(contact.t);
    hit.centre = sweep.at(contact.t);
    hit.face_normal = polygon.unit_normal();
    hit.normal = normal_toward_mover(sweep, polygon, hit.face_normal);

    // Relative to a corner first, so that nothing is lost far from the origin.
    const Vec3 corner = polygon.corners[contact.index];
    const Vec3 centre = (sweep.start - corner) + sweep.direction * contact.t;
    Vec3 away;
    if (contact.feature == Feature::kFace) {
        const double height = dot(centre, polygon.normal) / polygon.normal_length;
        hit.point = corner + (centre - hit.face_normal * height);
        return hit;
    }
    if (contact.feature == Feature::kEdge) {
        const Vec3 edge = polygon.corners[polygon.next(contact.index)] - corner;
        double along = dot(centre, edge) / dot(edge, edge);
        along = along < 0 ? 0 : along > 1 ? 1 : along;
        hit.point = corner + edge * along;
        away = centre - edge * along;
    } else {
        hit.point = corner;
        away = centre;
    }
    const double distance = length(away);
    if (sweep.radius > 0 && distance > 0) hit.normal = away * (1 / distance);
    return hit;
}

double safe_fraction(const Sweep& sweep, const PolygonHit& hit, double skin) {
    const double closing = -dot(hit.normal, sweep.direction) * sweep.end;
    if (!(closing > 0)) return skin > 0 ? 0 : hit.fraction;
    const double safe = hit.fraction - skin / closing;
    return safe > 0 ? safe : 0;
}

}  // namespace firma

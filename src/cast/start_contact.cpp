// SPDX-License-Identifier: MIT
// What a sphere has to do with a polygon before it moves.
#include "cast/start_contact.h"

#include "cast/cast_sphere_face.h"
#include "cast/vector_of.h"
#include "firma/polygon.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

using Real = DoubleDouble;

int sign(const Real& value) {
    return value.high > 0 ? 1 : value.high < 0 ? -1 : 0;
}

/// How a feature lies to the start: the distance against the radius, and whether the path brings it nearer.
struct Nearness {
    bool within = false;  ///< distance <= radius
    bool on_it = false;   ///< distance 0
    int change = 0;       ///< sign of the distance's derivative
};

/// square <= limit, equal to the last digit counting as equal.
bool at_most(const Real& square, const Real& limit) {
    return sign(square - limit - limit * Real(8 * kDoubleDoubleRoundoff)) <= 0;
}

Nearness near_vertex(const Sweep& sweep, const Vec3& vertex) {
    const VectorOf<Real> w = difference<Real>(sweep.start, vertex);
    const Real square = dot(w, w), r = sweep.radius;
    return {at_most(square, r * r), sign(square) == 0, sign(dot(w, exactly<Real>(sweep.direction)))};
}

Nearness near_edge(const Sweep& sweep, const Vec3& a, const Vec3& b) {
    const VectorOf<Real> w = difference<Real>(sweep.start, a), e = difference<Real>(b, a);
    const VectorOf<Real> m = cross(w, e), n = cross(exactly<Real>(sweep.direction), e);
    const Real square = dot(m, m), r = sweep.radius;
    return {at_most(square, r * r * dot(e, e)), sign(square) == 0, sign(dot(m, n))};
}

Nearness near_face(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const VectorOf<Real> n = precise_normal(polygon);
    const Real height = dot(difference<Real>(sweep.start, polygon.corners[0]), n), r = sweep.radius;
    const int side = exact_plane_side(sweep.start, polygon);
    return {at_most(height * height, r * r * dot(n, n)), side == 0, side * facing};
}

Nearness nearness(const Sweep& sweep, const PolygonShape& polygon, int facing, const ClosestPoint& closest) {
    const std::size_t k = closest.feature_index;
    if (closest.feature == Feature::kVertex) return near_vertex(sweep, polygon.corners[k]);
    if (closest.feature == Feature::kEdge)
        return near_edge(sweep, polygon.corners[k], polygon.corners[polygon.next(k)]);
    return near_face(sweep, polygon, facing);
}

}  // namespace

StartContact start_contact(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const ClosestPoint closest = closest_point(sweep.start, polygon.corners);
    const double error =
        rounding(64) * (length(sweep.start - polygon.corners[0]) + length(polygon.corners[1] - polygon.corners[0]));
    if (closest.distance - error > sweep.radius) return {};
    const Nearness near = nearness(sweep, polygon, facing, closest);
    if (!near.within) return {};
    const bool closer = near.on_it ? facing != 0 : near.change < 0;
    if (!closer) return {StartContact::kIgnored, {}};
    return {StartContact::kTouching, {Status::kTouching, closest.feature, closest.feature_index, 0}};
}

}  // namespace firma

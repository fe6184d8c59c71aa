// SPDX-License-Identifier: MIT
// How near a point is to a polygon.
#include "cast/nearness.h"

#include "cast/cast_sphere_face.h"
#include "cast/vector_of.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

using Real = DoubleDouble;

int sign(const Real& value) {
    return value.high > 0 ? 1 : value.high < 0 ? -1 : 0;
}

/// square <= limit, equal to the last digit counting as equal.
bool at_most(const Real& square, const Real& limit) {
    return sign(square - limit - limit * Real(8 * kDoubleDoubleRoundoff)) <= 0;
}

Nearness near_vertex(const Vec3& point, double radius, const Vec3& direction, const Vec3& vertex) {
    const VectorOf<Real> w = difference<Real>(point, vertex);
    const Real square = dot(w, w), r = radius;
    return {at_most(square, r * r), sign(square) == 0, sign(dot(w, exactly<Real>(direction)))};
}

Nearness near_edge(const Vec3& point, double radius, const Vec3& direction, const Vec3& a, const Vec3& b) {
    return near_line(difference<Real>(point, a), difference<Real>(b, a), exactly<Real>(direction), radius);
}

Nearness near_face(const Vec3& point, double radius, int facing, const PolygonShape& polygon) {
    const VectorOf<Real> n = precise_normal(polygon);
    const Real height = dot(difference<Real>(point, polygon.corners[0]), n), r = radius;
    const int side = exact_plane_side(point, polygon);
    return {at_most(height * height, r * r * dot(n, n)), side == 0, side * facing};
}

}  // namespace

Nearness near_line(const VectorOf<Real>& w, const VectorOf<Real>& e, const VectorOf<Real>& direction, double radius) {
    const VectorOf<Real> m = cross(w, e), n = cross(direction, e);
    const Real square = dot(m, m), r = radius;
    return {at_most(square, r * r * dot(e, e)), sign(square) == 0, sign(dot(m, n))};
}

Nearness near_plane(const Real& height, const Real& change, const Real& square_length, double radius) {
    const Real r = radius;
    return {at_most(height * height, r * r * square_length), sign(height) == 0, sign(height) * sign(change)};
}

Nearness nearness(const Vec3& point, double radius, const Vec3& direction, int facing, const PolygonShape& polygon,
                  const Closest& closest) {
    const std::size_t k = closest.index;
    if (closest.feature == Feature::kVertex) return near_vertex(point, radius, direction, polygon.corners[k]);
    if (closest.feature == Feature::kEdge)
        return near_edge(point, radius, direction, polygon.corners[k], polygon.corners[polygon.next(k)]);
    return near_face(point, radius, facing, polygon);
}

bool ball_meets(const Vec3& centre, double radius, const PolygonShape& polygon, const Closest& closest) {
    const double size = length(centre - polygon.corners[0]) + length(closest.offset);
    const double error = rounding(64) * size;
    if (closest.distance + error < radius) return true;
    if (closest.distance - error > radius) return false;
    return nearness(centre, radius, {}, 0, polygon, closest).within;
}

}  // namespace firma

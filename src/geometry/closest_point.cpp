// SPDX-License-Identifier: MIT
// The point of a polygon nearest to a point.
// Source: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.
#include <cmath>

#include "firma/polygon.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

bool foot_inside(const Vec3& w, const PolygonShape& polygon) {
    const Vec3& origin = polygon.corners[0];
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 a = polygon.corners[k] - origin, edge = polygon.corners[polygon.next(k)] - polygon.corners[k];
        if (dot(cross(edge, w - a), polygon.normal) < 0) return false;
    }
    return true;
}

/// The nearest point of the side from corner k to the next one.
ClosestPoint closest_on_side(const Vec3& point, const PolygonShape& polygon, std::size_t k) {
    const std::size_t next = polygon.next(k);
    const Vec3 &a = polygon.corners[k], &b = polygon.corners[next];
    const Vec3 w = point - a, edge = b - a;
    const double along = dot(w, edge), square = dot(edge, edge);
    if (along <= 0) return {a, length(w), Feature::kVertex, std::uint32_t(k)};
    if (along >= square) return {b, length(point - b), Feature::kVertex, std::uint32_t(next)};
    const Vec3 offset = edge * (along / square);
    return {a + offset, length(w - offset), Feature::kEdge, std::uint32_t(k)};
}

}  // namespace

ClosestPoint closest_point(const Vec3& point, std::span<const Vec3> corners) {
    const PolygonShape polygon = make_shape(corners);
    const Vec3 w = point - corners[0];
    if (foot_inside(w, polygon)) {
        const Vec3 normal = polygon.unit_normal();
        const double height = dot(w, polygon.normal) / polygon.normal_length;
        return {point - normal * height, std::fabs(height), Feature::kFace, 0};
    }
    ClosestPoint best = closest_on_side(point, polygon, 0);
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const ClosestPoint other = closest_on_side(point, polygon, k);
        if (other.distance < best.distance) best = other;
    }
    return best;
}

}  // namespace firma

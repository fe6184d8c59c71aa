// SPDX-License-Identifier: MIT
// The point of a polygon nearest to a point.
// Source: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.
#include "geometry/closest_point.h"

#include <cmath>

#include "geometry/rounding.h"

namespace firma {
namespace {

/// The nearest point of the side from corner k to the next one.
Closest closest_on_side(const Vec3& w, const PolygonShape& polygon, std::size_t k) {
    const std::size_t next = polygon.next(k);
    const Vec3 a = polygon.corners[k] - polygon.corners[0], b = polygon.corners[next] - polygon.corners[0];
    const Vec3 from_a = w - a, edge = b - a;
    const double along = dot(from_a, edge), square = dot(edge, edge);
    if (along <= 0) return {a, from_a, length(from_a), Feature::kVertex, std::uint32_t(k)};
    if (along >= square) return {b, w - b, length(w - b), Feature::kVertex, std::uint32_t(next)};
    const Vec3 offset = edge * (along / square);
    return {a + offset, from_a - offset, length(from_a - offset), Feature::kEdge, std::uint32_t(k)};
}

/// Distance of the foot on a side to the nearer end of that side; 0 at a corner.
double foot_from_end(const Closest& at, const PolygonShape& polygon) {
    if (at.feature != Feature::kEdge) return 0;
    const Vec3& origin = polygon.corners[0];
    const double one = length(at.offset - (polygon.corners[at.index] - origin));
    const double two = length(at.offset - (polygon.corners[polygon.next(at.index)] - origin));
    return one < two ? one : two;
}

/// Feet within this share of all distances involved stand at one corner: their distances may differ by rounding alone,
/// which hides offsets up to its square root.
constexpr double kTogether = 0x1p-16;

/// Whether `other` is nearer than `best`. Just beside a corner, its sides and the corner itself are as far to rounding;
/// of feet that lie together there the one farther along its side is the nearer.
bool nearer(const Closest& other, const Closest& best, double size, const PolygonShape& polygon) {
    const bool together = max_abs(other.offset - best.offset) < kTogether * size;
    if (!together || std::fabs(other.distance - best.distance) > rounding(16) * size)
        return other.distance < best.distance;
    return foot_from_end(other, polygon) > foot_from_end(best, polygon);
}

}  // namespace

bool foot_inside(const Vec3& w, const PolygonShape& polygon) {
    const Vec3& origin = polygon.corners[0];
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 a = polygon.corners[k] - origin, edge = polygon.corners[polygon.next(k)] - polygon.corners[k];
        if (dot(cross(edge, w - a), polygon.normal) < 0) return false;
    }
    return true;
}

Closest closest_on_rim(const Vec3& w, const PolygonShape& polygon) {
    Closest best = closest_on_side(w, polygon, 0);
    const double size = best.distance + max_abs(w);
    for (std::size_t k = 1; k < polygon.corners.size(); ++k) {
        const Closest other = closest_on_side(w, polygon, k);
        if (nearer(other, best, size, polygon)) best = other;
    }
    return best;
}

Closest foot_on_plane(const Vec3& w, const PolygonShape& polygon) {
    const double height = dot(w, polygon.normal) / polygon.normal_length;
    const Vec3 away = polygon.unit_normal() * height;
    return {w - away, away, std::fabs(height), Feature::kFace, 0};
}

Closest closest_to(const Vec3& w, const PolygonShape& polygon) {
    return foot_inside(w, polygon) ? foot_on_plane(w, polygon) : closest_on_rim(w, polygon);
}

ClosestPoint closest_point(const Vec3& point, std::span<const Vec3> corners) {
    if (!usable_corners(corners)) return {point, INFINITY, Feature::kFace, 0};
    const PolygonShape polygon = make_shape(corners);
    const Closest closest = closest_to(point - corners[0], polygon);
    return {corners[0] + closest.offset, closest.distance, closest.feature, closest.index};
}

}  // namespace firma

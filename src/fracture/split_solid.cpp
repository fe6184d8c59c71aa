// SPDX-License-Identifier: MIT
// A solid in two: what is left of it without the one half of space, and without the other. Both cutters have the same
// triangle in the plane, so both cuts have the same plane, and new vertices are the same three planes in both halves.
#include "fracture/split_solid.h"

#include <cmath>

#include "firma/grid.h"

namespace firma {
namespace {

/// Radii of the ball: where the ball ends, at two of its radii above the plane, a pyramid is still two radii wide.
constexpr double kPyramid = 6;

/// Of unit length, across a unit direction.
Vec3 any_across(const Vec3& normal) {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::fabs(normal[other]) < std::fabs(normal[axis])) axis = other;
    Vec3 along;
    along[axis] = 1;
    const Vec3 across = cross(normal, along);
    return across * (1 / length(across));
}

bool put_on_grid(const Vec3& at, Vec3& snapped) {
    const std::optional<GridPoint> point = snap(at);
    if (point) snapped = to_metres(*point);
    return point.has_value();
}

Result<Cutter> pyramid(const CrackPlane& plane, const Vec3& tip) {
    const Vec3 vertices[] = {plane.corners[0], plane.corners[1], plane.corners[2], tip};
    const CutterTriangle triangles[] = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
    return make_cutter(vertices, triangles, "crack");
}

SolidResult without(const Solid& solid, const CrackPlane& plane, const Vec3& tip, std::uint32_t material) {
    const Result<Cutter> half = pyramid(plane, tip);
    SolidResult result;
    if (half) {
        SolidCutOptions options;
        options.material = material;
        result = subtract(solid, half.value(), {}, options);
    } else {
        result.error = half.error();
    }
    return result;
}

}  // namespace

std::optional<CrackPlane> crack_plane(const Vec3& point, const Vec3& normal, const Vec3& centre, double radius) {
    constexpr double kHalfRootOf3 = 0.86602540378443864676;
    const double size = kPyramid * radius;
    const Vec3 middle = centre - normal * dot(normal, centre - point);
    const Vec3 u = any_across(normal) * size, v = cross(normal, u);
    CrackPlane plane;
    const bool inside = put_on_grid(middle + u, plane.corners[0]) &&
                        put_on_grid(middle - u * 0.5 + v * kHalfRootOf3, plane.corners[1]) &&
                        put_on_grid(middle - u * 0.5 - v * kHalfRootOf3, plane.corners[2]) &&
                        put_on_grid(middle + normal * size, plane.front) &&
                        put_on_grid(middle - normal * size, plane.back);
    if (!inside) return std::nullopt;
    return plane;
}

SolidHalves split_solid(const Solid& solid, const CrackPlane& plane, std::uint32_t material) {
    SolidHalves halves;
    SolidResult front = without(solid, plane, plane.back, material);
    if (front.status == CarveStatus::kRefused) return halves.error = std::move(front.error), halves;
    if (front.status == CarveStatus::kNothing || front.solid.face_count() == 0) {
        halves.outcome = SolidHalves::Outcome::kMissed;
        return halves;
    }
    SolidResult back = without(solid, plane, plane.front, material);
    if (back.status == CarveStatus::kRefused) return halves.error = std::move(back.error), halves;
    if (back.status == CarveStatus::kNothing || back.solid.face_count() == 0) {
        halves.outcome = SolidHalves::Outcome::kMissed;
        return halves;
    }
    halves.outcome = SolidHalves::Outcome::kSplit;
    halves.front = std::move(front.solid);
    halves.back = std::move(back.solid);
    return halves;
}

}  // namespace firma

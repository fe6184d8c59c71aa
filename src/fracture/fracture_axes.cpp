// SPDX-License-Identifier: MIT
// The axes of a slab, a beam or a wall, by the areas of its flat sides: what craters left of its surface is in many
// directions, a little in each.
#include <cmath>
#include <vector>

#include "base/sort.h"
#include "body/surface_points.h"
#include "firma/fracture.h"

namespace firma {
namespace {

/// A direction up to its sign, and how much area lies across it.
struct FlatSide {
    Vec3 normal;
    double area = 0;
};

/// Steps of a coordinate of a direction: what is in one step is one direction.
constexpr double kDirectionSteps = 256;
/// Cosine of about 45 degrees: what is farther from a direction is across it.
constexpr double kAcross = 0.7;

int sign_of(const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis)
        if (v[axis] != 0) return v[axis] < 0 ? -1 : 1;
    return 1;
}

Vec3 in_steps(const Vec3& direction) {
    Vec3 rounded{std::floor(direction.x * kDirectionSteps + 0.5), std::floor(direction.y * kDirectionSteps + 0.5),
                 std::floor(direction.z * kDirectionSteps + 0.5)};
    return rounded * sign_of(rounded);
}

bool is_lower(const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Directions of all triangles, those in one step together, the largest area first.
std::vector<FlatSide> flat_sides(const std::vector<SurfaceTriangle>& triangles) {
    struct Facing {
        Vec3 step, twice;
    };
    std::vector<Facing> parts;
    for (const SurfaceTriangle& triangle : triangles) {
        const Vec3 twice = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
        const Vec3 direction = twice * (1 / length(twice)), step = in_steps(direction);
        parts.push_back({step, twice * (dot(step, direction) < 0 ? -1.0 : 1.0)});
    }
    sort_range(parts, [](const Facing& a, const Facing& b) {
        return a.step == b.step ? is_lower(a.twice, b.twice) : is_lower(a.step, b.step);
    });
    std::vector<FlatSide> sides;
    for (std::size_t k = 0; k < parts.size();) {
        const Vec3 step = parts[k].step;
        Vec3 sum;
        for (; k < parts.size() && parts[k].step == step; ++k) sum += parts[k].twice;
        const double size = length(sum);
        if (size > 0) sides.push_back({sum * (1 / size), size / 2});
    }
    sort_range(sides, [](const FlatSide& a, const FlatSide& b) {
        return a.area != b.area ? a.area > b.area : is_lower(a.normal, b.normal);
    });
    return sides;
}

Vec3 without_part_along(const Vec3& v, const Vec3& axis) {
    const Vec3 rest = v - axis * dot(v, axis);
    return rest * (1 / length(rest));
}

/// The largest side across an axis; where there is none, any direction across it.
Vec3 side_across(const std::vector<FlatSide>& sides, const Vec3& axis) {
    for (const FlatSide& side : sides)
        if (std::fabs(dot(side.normal, axis)) < kAcross) return without_part_along(side.normal, axis);
    return without_part_along(std::fabs(axis.x) < kAcross ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, axis);
}

}  // namespace

Quaternion fracture_axes(const Solid& solid, CrackStyle style) {
    const std::vector<FlatSide> sides = flat_sides(triangles_of(solid));
    if (sides.empty()) return {0, 0, 0, 1};
    const Vec3 thin = sides[0].normal, side = side_across(sides, thin), along = cross(side, thin);
    if (style != CrackStyle::kBricks) return turn_of_axes(along, side, thin);
    // Up is whichever of the three is nearest to the frame's z; of the other two `thin` has more area, then `side`.
    const Vec3 all[] = {thin, side, along};
    int up = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(all[k].z) > std::fabs(all[up].z)) up = k;
    const Vec3 z = all[up].z < 0 ? -all[up] : all[up], y = all[up == 0];
    return turn_of_axes(cross(y, z), y, z);
}

}  // namespace firma

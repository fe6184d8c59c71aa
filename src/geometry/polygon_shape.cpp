// SPDX-License-Identifier: MIT
// A polygon made ready for casts.
#include "geometry/polygon_shape.h"

#include <cmath>

namespace firma {
namespace {

__extension__ using Wide = __int128;

struct WideVec {
    Wide x = 0, y = 0, z = 0;
};

/// Twice the area, in square surface steps: at most 67 bits, as coordinates differ by at most 33.
WideVec wide_normal(std::span<const Vec3> corners) {
    struct FromFirst {
        std::int64_t x, y, z;
    };
    const auto steps_from_first = [&](const Vec3& corner) -> FromFirst {
        const Vec3 d = corner - corners[0];
        return {std::int64_t(d.x * kSurfaceSteps), std::int64_t(d.y * kSurfaceSteps),
                std::int64_t(d.z * kSurfaceSteps)};
    };
    WideVec sum;
    FromFirst a = steps_from_first(corners[1]);
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const FromFirst b = steps_from_first(corners[k]);
        sum.x += Wide(a.y) * b.z - Wide(a.z) * b.y;
        sum.y += Wide(a.z) * b.x - Wide(a.x) * b.z;
        sum.z += Wide(a.x) * b.y - Wide(a.y) * b.x;
        a = b;
    }
    return sum;
}

bool on_input_grid(std::span<const Vec3> corners) {
    for (const Vec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = corner[axis] * kInputSteps;
            if (steps != double(std::int32_t(steps))) return false;
        }
    return true;
}

/// Every difference has at most 26 bits, every product 52, and no sum outgrows twice the square of the world: all
/// exact.
Vec3 normal_in_doubles(std::span<const Vec3> corners) {
    Vec3 sum;
    Vec3 a = corners[1] - corners[0];
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const Vec3 b = corners[k] - corners[0];
        sum = sum + cross(a, b);
        a = b;
    }
    return sum;
}

constexpr double kSquareStep = 1 / (kSurfaceSteps * kSurfaceSteps);

}  // namespace

bool usable_corners(std::span<const Vec3> corners) {
    if (corners.size() < 3) return false;
    for (const Vec3& corner : corners)
        if (!is_finite(corner) || max_abs(corner) > kWorldRim) return false;
    return true;
}

ExactNormal exact_normal(std::span<const Vec3> corners) {
    const WideVec wide = wide_normal(corners);
    const auto in_two = [](Wide value) -> std::array<double, 2> {
        const double high = double(value);
        return {high * kSquareStep, double(value - Wide(high)) * kSquareStep};
    };
    return {{in_two(wide.x), in_two(wide.y), in_two(wide.z)}};
}

PolygonShape make_shape(std::span<const Vec3> corners) {
    PolygonShape shape;
    shape.corners = corners;
    if (on_input_grid(corners)) {
        shape.normal = normal_in_doubles(corners);
    } else {
        const WideVec wide = wide_normal(corners);
        shape.normal = Vec3{double(wide.x), double(wide.y), double(wide.z)} * kSquareStep;
    }
    shape.normal_length = length(shape.normal);
    return shape;
}

}  // namespace firma

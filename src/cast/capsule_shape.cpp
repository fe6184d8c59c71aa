// SPDX-License-Identifier: MIT
// A capsule made ready for casts.
#include "cast/capsule_shape.h"

#include <cmath>

#include "geometry/rounding.h"

namespace firma {
namespace {

Vec3 end_without_dust(Vec3 v) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::fabs(v[axis]) < kSmallestNumber) v[axis] = 0;
    return v;
}

bool usable_end(const Vec3& v) {
    return is_finite(v) && max_abs(v) <= kLargestNumber / 2;
}

}  // namespace

CapsuleShape shape_of_capsule(const Capsule& capsule) {
    return {end_without_dust(capsule.from), end_without_dust(capsule.to),
            capsule.radius < kSmallestNumber ? 0 : capsule.radius};
}

ShapeExtent extent_of(const CapsuleShape& capsule) {
    ShapeExtent extent{{}, {}, 0, capsule.radius};
    if (capsule.is_sphere()) return extent;
    const double size = max_abs(capsule.from) + max_abs(capsule.to);
    extent.axes = 1;
    extent.axis[0] = (capsule.to - capsule.from) * 0.5;
    extent.radius += rounding(16) * size + kSmallestNumber;
    return extent;
}

Sphere ball_around(const Capsule& capsule) {
    if (capsule.from == capsule.to) return {capsule.from, capsule.radius};
    const Vec3 middle = capsule.from * 0.5 + capsule.to * 0.5;
    if (!usable_end(capsule.from) || !usable_end(capsule.to) || !(capsule.radius >= 0)) return {middle, -1};
    const double one = length(capsule.from - middle), other = length(capsule.to - middle);
    const double farther = one > other ? one : other;
    return {middle, (capsule.radius + farther) * (1 + rounding(16)) + kSmallestNumber};
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// Planes through points of the input grid, as integers.
#include "geometry/exact_plane.h"

#include <cmath>
#include <numeric>

#include "base/assert.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

std::uint64_t magnitude(std::int64_t value) {
    return std::uint64_t(value < 0 ? -value : value);
}

[[maybe_unused]] bool in_world(const InputPoint& p) {
    bool in = true;
    for (int axis = 0; axis < 3; ++axis) in = in && p[axis] >= -kRimSteps && p[axis] < kRimSteps;
    return in;
}

/// The doubles that go with the integers.
Plane with_doubles(Plane plane) {
    std::int64_t size = 0;
    for (int axis = 0; axis < 3; ++axis) size += std::int64_t(magnitude(plane.normal[axis]));
    plane.d = double(plane.offset());
    // At most 3 * 2^52: rounded up to an even number, it is a double.
    plane.size = double(size > std::int64_t(1) << 53 ? size + (size & 1) : size);
    return plane;
}

/// The plane with a normal along `normal` that holds a grid point; not valid for a zero one. What divides the normal
/// divides normal . point as well, so the offset has no part in the common divisor.
Plane plane_at(const std::int64_t (&normal)[3], const InputPoint& point) {
    std::uint64_t divisor = std::gcd(magnitude(normal[0]), magnitude(normal[1]));
    if (divisor != 1) divisor = std::gcd(divisor, magnitude(normal[2]));
    Plane plane;
    if (divisor == 0) return plane;
    Int128 offset = 0;
    for (int axis = 0; axis < 3; ++axis) {
        plane.normal[axis] = divisor == 1 ? normal[axis] : normal[axis] / std::int64_t(divisor);
        offset -= Int128(plane.normal[axis]) * point[axis];
    }
    plane.set_offset(offset);
    return with_doubles(plane);
}

}  // namespace

// Twice the area of a triangle within a square of side 2^26, as seen along an axis, is at most 2^52: so is each
// component.
Plane plane_through(const InputPoint& a, const InputPoint& b, const InputPoint& c) {
    FIRMA_ASSERT(in_world(a) && in_world(b) && in_world(c), "points of the input grid have 26 bits: snap them first");
    std::int64_t u[3], v[3];
    for (int axis = 0; axis < 3; ++axis) {
        u[axis] = std::int64_t(b[axis]) - a[axis];
        v[axis] = std::int64_t(c[axis]) - a[axis];
    }
    return plane_at({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}, a);
}

Plane plane_of_numbers(const std::int64_t (&normal)[3], Int128 offset) {
    constexpr std::uint64_t kMost = std::uint64_t(1) << 52;
    Int128 size = 0;
    std::uint64_t divisor = 0;
    for (const std::int64_t n : normal) {
        const std::uint64_t magnitude_of_n = n < 0 ? -std::uint64_t(n) : std::uint64_t(n);
        if (magnitude_of_n > kMost) return {};
        size += Int128(magnitude_of_n);
        divisor = std::gcd(divisor, magnitude_of_n);
    }
    if (divisor != 1 || offset > size * kRimSteps || offset < -size * kRimSteps) return {};
    Plane plane;
    for (int axis = 0; axis < 3; ++axis) plane.normal[axis] = normal[axis];
    plane.set_offset(offset);
    return with_doubles(plane);
}

Plane flipped(const Plane& plane) {
    Plane back;
    for (int axis = 0; axis < 3; ++axis) back.normal[axis] = -plane.normal[axis];
    back.set_offset(-plane.offset());
    return with_doubles(back);
}

// As plane_through(a, b, a + one step), but that step may lead out of the world.
Plane edge_plane(const InputPoint& a, const InputPoint& b, const Plane& face) {
    FIRMA_ASSERT(in_world(a) && in_world(b), "points of the input grid have 26 bits: snap them first");
    FIRMA_ASSERT(a != b && face.valid(), "an edge has two ends, and its face a plane");
    const int axis = face.dominant_axis(), next = (axis + 1) % 3, last = (axis + 2) % 3;
    std::int64_t normal[3] = {0, 0, 0};
    normal[next] = std::int64_t(b[last]) - a[last];
    normal[last] = std::int64_t(a[next]) - b[next];
    return plane_at(normal, a);
}

Plane axis_plane(int axis, std::int32_t step) {
    Plane plane;
    plane.normal[axis] = 1;
    plane.set_offset(-Int128(step));
    return with_doubles(plane);
}

Plane fine_plane(int axis, double at) {
    constexpr double kScale = 1 << 16;
    Plane plane = axis_plane(axis, 0);
    const double rounded = std::floor(at * kScale + 0.5);
    plane.normal[axis] = std::int64_t(kScale);
    plane.set_offset(-Int128(std::int64_t(rounded)));
    plane.d = -rounded;
    plane.size = kScale;
    return plane;
}

bool exact_parallel(const Plane& a, const Plane& b) {
    return normal_minor(a, b, 0, 1) == 0 && normal_minor(a, b, 1, 2) == 0 && normal_minor(a, b, 2, 0) == 0;
}

int exact_turn(const Plane& a, const Plane& b, const Plane& c) {
    const double estimate = dot(a.direction(), cross(b.direction(), c.direction()));
    // Each of the six terms passes through at most five roundings, and their magnitudes are six of the 27 terms of the
    // product of the sizes; three more roundings for the bound itself.
    if (std::fabs(estimate) > rounding(8) * (a.size * b.size * c.size)) return estimate > 0 ? 1 : -1;

    return (product(normal_minor(b, c, 1, 2), a.normal[0]) + product(normal_minor(b, c, 2, 0), a.normal[1]) +
            product(normal_minor(b, c, 0, 1), a.normal[2]))
        .sign();
}

}  // namespace firma

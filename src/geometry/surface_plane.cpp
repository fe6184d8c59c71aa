// SPDX-License-Identifier: MIT
// Planes through points of the surface grid.
#include "geometry/surface_plane.h"

#include <cstdint>
#include <numeric>
#include <utility>

namespace firma {
namespace {

Int128 magnitude_of(Int128 value) {
    return value < 0 ? -value : value;
}

/// Of numbers that are not negative, by shifts and differences until they have 64 bits: what the module links has no
/// remainder of 128 bits. Source: J. Stein, Computational Problems Associated with Racah Algebra, 1967.
Int128 common_divisor(Int128 a, Int128 b) {
    if (a == 0 || b == 0) return a + b;
    int twos = 0;
    for (; ((a | b) & 1) == 0; ++twos) {
        a >>= 1;
        b >>= 1;
    }
    while ((a & 1) == 0) a >>= 1;
    while (b != 0 && ((a | b) >> 64) != 0) {
        while ((b & 1) == 0) b >>= 1;
        if (a > b) std::swap(a, b);
        b -= a;
    }
    if (b != 0) a = std::gcd(std::uint64_t(a), std::uint64_t(b));
    return a << twos;
}

/// normal . p + offset = 0, p in surface steps: divided by what divides all four.
Plane plane_of_surface(const Int128 (&normal)[3], Int128 offset) {
    Int128 divisor = magnitude_of(offset), most = 0;
    Int128 scaled[3];
    for (int axis = 0; axis < 3; ++axis) {
        scaled[axis] = normal[axis] * kSurfacePerInput;
        divisor = common_divisor(divisor, magnitude_of(scaled[axis]));
    }
    Plane plane;
    if (divisor == 0) return plane;
    std::int64_t size = 0;
    for (Int128& component : scaled) {
        if (divisor > 1) component /= divisor;
        if (magnitude_of(component) > most) most = magnitude_of(component);
    }
    if (most > Int128(1) << 52) return plane;
    for (int axis = 0; axis < 3; ++axis) {
        plane.normal[axis] = std::int64_t(scaled[axis]);
        size += std::int64_t(magnitude_of(scaled[axis]));
    }
    plane.set_offset(divisor > 1 ? offset / divisor : offset);
    plane.d = double(plane.offset());
    plane.size = double(size > std::int64_t(1) << 53 ? size + (size & 1) : size);
    return plane;
}

Int128 offset_at(const Int128 (&normal)[3], const GridPoint& p) {
    return -(normal[0] * p.x + normal[1] * p.y + normal[2] * p.z);
}

}  // namespace

Plane surface_plane(std::span<const GridPoint> corners) {
    Int128 normal[3] = {0, 0, 0};
    for (std::size_t k = 2; k < corners.size(); ++k) {  // the first ones may lie on a line
        Int128 u[3], v[3];
        for (int axis = 0; axis < 3; ++axis) {
            u[axis] = Int128(corners[k - 1][axis]) - corners[0][axis];
            v[axis] = Int128(corners[k][axis]) - corners[0][axis];
        }
        for (int k3 = 0, i = 1, j = 2; k3 < 3; i = j, j = k3, ++k3) normal[k3] = u[i] * v[j] - u[j] * v[i];
        if (normal[0] != 0 || normal[1] != 0 || normal[2] != 0) break;
    }
    return plane_of_surface(normal, offset_at(normal, corners[0]));
}

Plane surface_edge_plane(const GridPoint& a, const GridPoint& b, const Plane& face) {
    const int axis = face.dominant_axis(), next = (axis + 1) % 3, last = (axis + 2) % 3;
    Int128 normal[3] = {0, 0, 0};
    normal[next] = Int128(b[last]) - a[last];
    normal[last] = Int128(a[next]) - b[next];
    return plane_of_surface(normal, offset_at(normal, a));
}

Plane surface_axis_plane(int axis, std::int32_t at) {
    // 64 p - at = 0, p in input steps: divided by as many twos as both numbers have.
    static_assert((kSurfacePerInput & (kSurfacePerInput - 1)) == 0);
    const std::int32_t both = at | kSurfacePerInput;
    const std::int32_t divisor = both & -both;
    Plane plane;
    plane.normal[axis] = kSurfacePerInput / divisor;
    plane.set_offset(-Int128(at / divisor));
    plane.d = double(-(std::int64_t(at) / divisor));
    plane.size = double(plane.normal[axis]);
    return plane;
}

Plane plane_beside(const Plane& plane, int way) {
    Plane beside = plane;
    std::int64_t scale = 1;
    while (scale < 1 << 16 && plane.size * double(2 * scale) < 0x1p51) scale *= 2;
    for (std::int64_t& component : beside.normal) component *= scale;
    beside.set_offset(plane.offset() * scale - way);
    beside.d = double(beside.offset());
    beside.size = plane.size * double(scale);
    return beside;
}

}  // namespace firma

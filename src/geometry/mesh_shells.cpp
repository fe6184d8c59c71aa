// SPDX-License-Identifier: MIT
// Volumes and passages of a ray, in integers of 128 bits.
#include "geometry/mesh_shells.h"

namespace firma {

Int128 six_times_cone(std::span<const GridPoint> corners, const GridPoint& apex) {
    const auto arm = [&](std::size_t k, int axis) { return std::int64_t(corners[k][axis]) - apex[axis]; };
    Int128 sum = 0;
    for (std::size_t k = 2; k < corners.size(); ++k)
        for (int x = 0, y = 1, z = 2; x < 3; y = z, z = x, ++x)
            sum += arm(0, x) * (Int128(arm(k - 1, y)) * arm(k, z) - Int128(arm(k - 1, z)) * arm(k, y));
    return sum;
}

GridBox EdgeRay::box() const {
    const auto steps = [](std::int64_t half_steps) { return std::int32_t(half_steps * (kSurfacePerInput / 2)); };
    return {{steps(x_), steps(y_), steps(z_)}, {INT32_MAX, steps(y_), steps(z_)}};
}

/// Sign of the turn from a to b to the ray, seen against it; the ray stands a shade beside itself, by an infinitesimal
/// in y and the square of it in z, so that it meets no edge that has any length in this view.
int EdgeRay::turn(const InputPoint& a, const InputPoint& b) const {
    const std::int64_t uy = b.y - a.y, uz = b.z - a.z, vy = y_ - 2 * std::int64_t(a.y), vz = z_ - 2 * std::int64_t(a.z);
    const std::int64_t area = uy * vz - uz * vy;
    const std::int64_t decisive = area != 0 ? area : uz != 0 ? -uz : uy;
    return decisive > 0 ? 1 : decisive < 0 ? -1 : 0;
}

int EdgeRay::passage(std::span<const InputPoint> points, const MeshPolygon& polygon) const {
    const AreaVector& n = polygon.normal;
    if (n.x == 0) return 0;
    const int facing = n.x > 0 ? 1 : -1;
    std::uint32_t last = polygon.corners.back();
    for (const std::uint32_t next : polygon.corners) {
        if (turn(points[last], points[next]) != facing) return 0;
        last = next;
    }
    const InputPoint& a = points[last];
    const Int128 above = Int128(n.x) * (x_ - 2 * std::int64_t(a.x)) + Int128(n.y) * (y_ - 2 * std::int64_t(a.y)) +
                         Int128(n.z) * (z_ - 2 * std::int64_t(a.z));
    return (above < 0) == (facing > 0) ? facing : 0;
}

}  // namespace firma

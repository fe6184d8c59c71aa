// SPDX-License-Identifier: MIT
// Whether a point in a polygon's plane lies in the polygon.
#include "carve/touch_polygon.h"

#include "geometry/flat_loop.h"

namespace firma {
namespace {

/// Whether the side a b passes within two steps of p. Rounding of the products is far below a step.
bool passes_near(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
    const double au = double(a.u - p.u), av = double(a.v - p.v);
    const double du = double(b.u - a.u), dv = double(b.v - a.v), square = du * du + dv * dv;
    double t = square > 0 ? -(au * du + av * dv) / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    const double u = au + t * du, v = av + t * dv;
    return u * u + v * v <= 4;
}

}  // namespace

bool touches_polygon(std::span<const GridPoint> points, std::span<const std::uint32_t> ends, const Plane& plane,
                     const GridPoint& p) {
    const FlatView view = plane.front_view();
    const FlatPoint here = project(p, view);
    bool inside = false;
    std::size_t first = 0;
    for (const std::uint32_t end : ends) {
        for (std::size_t k = first; k < end; ++k) {
            const FlatPoint a = project(points[k], view), b = project(points[k + 1 < end ? k + 1 : first], view);
            if (passes_near(a, b, here)) return true;
            inside ^= crosses_ray(a, b, here);
        }
        first = end;
    }
    return inside;
}

}  // namespace firma

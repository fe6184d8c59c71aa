// SPDX-License-Identifier: MIT
// Whether a point in a polygon's plane lies in the polygon.
#include "carve/touch_polygon.h"

namespace firma {
namespace {

struct Flat {
    double u, v;  ///< from the point asked about, in surface steps: exact
};

/// Whether the side a b passes within two steps of the origin. Rounding of the products is far below a step.
bool passes_near(const Flat& a, const Flat& b) {
    const double du = b.u - a.u, dv = b.v - a.v, square = du * du + dv * dv;
    double t = square > 0 ? -(a.u * du + a.v * dv) / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    const double u = a.u + t * du, v = a.v + t * dv;
    return u * u + v * v <= 4;
}

/// Whether the side crosses the ray from the origin along u; a corner on it counts as above.
bool crosses_ray(const Flat& a, const Flat& b) {
    if ((a.v < 0) == (b.v < 0)) return false;
    const double turn = a.u * b.v - a.v * b.u;  // far from zero, as no side passes near
    return (turn > 0) == (b.v > a.v);
}

}  // namespace

bool touches_polygon(std::span<const GridPoint> points, std::span<const std::uint32_t> ends, const Plane& plane,
                     const GridPoint& p) {
    const int axis = plane.dominant_axis(), u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto flat = [&](std::size_t k) {
        return Flat{double(points[k][u]) - double(p[u]), double(points[k][v]) - double(p[v])};
    };
    bool inside = false;
    std::size_t first = 0;
    for (const std::uint32_t end : ends) {
        for (std::size_t k = first; k < end; ++k) {
            const Flat a = flat(k), b = flat(k + 1 < end ? k + 1 : first);
            if (passes_near(a, b)) return true;
            inside ^= crosses_ray(a, b);
        }
        first = end;
    }
    return inside;
}

}  // namespace firma

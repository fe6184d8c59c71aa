// SPDX-License-Identifier: MIT
// A rigorous "stays clear" by separating directions.
#include "tests/reference/surely_apart.h"

#include <algorithm>

namespace firma::reference {

Hull::Hull(std::span<const Vec3> points) : corners(points.begin(), points.end()) {
    for (const Vec3& p : corners) {
        box.add(p);
        middle = middle + p * (1.0 / double(corners.size()));
    }
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        normal = normal + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    normal = normal * (1 / length(normal));
}

namespace {

struct Sweep {
    Vec3 start, finish;
    double radius;
    double rounding;  // of a coordinate in any sum or product below, with plenty to spare

    bool clear_along(const Hull& hull, const Vec3& w) const {
        double low = INFINITY, high = -INFINITY;
        for (const Vec3& v : hull.corners) {
            const double shadow = dot(w, v);
            low = std::min(low, shadow);
            high = std::max(high, shadow);
        }
        const double a = dot(w, start), b = dot(w, finish);
        const double reach =
            radius * length(w) * (1 + 0x1p-40) + rounding * (std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z));
        return low - std::max(a, b) > reach || std::min(a, b) - high > reach;
    }
};

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
    const Vec3 along = b - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
    return a + along * t;
}

// A guess.
Vec3 nearest_on_polygon(const Hull& hull, const Vec3& p) {
    bool inside = true;
    Vec3 best;
    double least = INFINITY;
    for (std::size_t k = 0; k < hull.corners.size(); ++k) {
        const Vec3 &a = hull.corners[k], &b = hull.corners[(k + 1) % hull.corners.size()];
        inside = inside && dot(p - a, cross(b - a, hull.normal)) <= 0;
        const Vec3 near = nearest_on_segment(a, b, p);
        const double square = dot(p - near, p - near);
        if (square < least) {
            least = square;
            best = near;
        }
    }
    return inside ? p - hull.normal * dot(p - hull.corners[0], hull.normal) : best;
}

}  // namespace

bool surely_apart(const Hull& hull, const Vec3& start, const Vec3& path, double end, double radius) {
    const double size = max_abs(start) + max_abs(path) + 8192;
    const Sweep sweep{start, start + path * end, radius, size * 0x1p-46};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = std::min(sweep.start[axis], sweep.finish[axis]);
        const double high = std::max(sweep.start[axis], sweep.finish[axis]);
        const double reach = radius * (1 + 0x1p-40) + sweep.rounding;
        if (hull.box.low[axis] - high > reach || low - hull.box.high[axis] > reach) return true;
    }
    if (sweep.clear_along(hull, hull.normal)) return true;
    Vec3 on_path = nearest_on_segment(sweep.start, sweep.finish, hull.middle);
    for (int round = 0; round < 6; ++round) {
        const Vec3 on_polygon = nearest_on_polygon(hull, on_path);
        const Vec3 between = on_path - on_polygon;
        const double size_of = max_abs(between);
        if (size_of > 0 && size_of < 1e100 && sweep.clear_along(hull, between * (1 / size_of))) return true;
        on_path = nearest_on_segment(sweep.start, sweep.finish, on_polygon);
    }
    return false;
}

}  // namespace firma::reference

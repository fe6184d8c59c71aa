// SPDX-License-Identifier: MIT
// Judges, in integers, whether corners make a polygon that can be cast against.
#include <cmath>
#include <cstdint>

#include "firma/grid.h"
#include "firma/polygon.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

__extension__ using Wide = __int128;

struct Steps {
    std::int64_t axis[3];
};

bool on_surface_grid(const Vec3& corner) {
    for (int axis = 0; axis < 3; ++axis) {
        const double steps = corner[axis] * kSurfaceSteps;
        if (!(steps >= INT32_MIN && steps <= INT32_MAX) || steps != std::floor(steps)) return false;
    }
    return true;
}

Steps difference(const Vec3& a, const Vec3& b) {
    Steps steps;
    for (int axis = 0; axis < 3; ++axis)
        steps.axis[axis] = std::int64_t(a[axis] * kSurfaceSteps) - std::int64_t(b[axis] * kSurfaceSteps);
    return steps;
}

struct WideNormal {
    Wide axis[3] = {0, 0, 0};

    int dominant() const {
        Wide size[3];
        for (int k = 0; k < 3; ++k) size[k] = axis[k] < 0 ? -axis[k] : axis[k];
        return size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    }
};

WideNormal normal_of(std::span<const Vec3> corners) {
    WideNormal normal;
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const Steps a = difference(corners[k - 1], corners[0]), b = difference(corners[k], corners[0]);
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal.axis[axis] += Wide(a.axis[u]) * b.axis[v] - Wide(a.axis[v]) * b.axis[u];
        }
    }
    return normal;
}

bool planar(std::span<const Vec3> corners, const WideNormal& normal) {
    for (const Vec3& corner : corners) {
        const Steps d = difference(corner, corners[0]);
        Wide height = 0;
        for (int axis = 0; axis < 3; ++axis) height += normal.axis[axis] * d.axis[axis];
        if (height != 0) return false;
    }
    return true;
}

/// Every turn to the left or none, never back, and once around: seen along the normal's dominant axis.
bool convex(std::span<const Vec3> corners, const WideNormal& normal) {
    const int k = normal.dominant(), u = (k + 1) % 3, v = (k + 2) % 3;
    const int left = normal.axis[k] > 0 ? 1 : -1;
    const auto forward = [&](const Steps& e) { return e.axis[u] > 0 || (e.axis[u] == 0 && e.axis[v] > 0); };
    int reversals = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()], &c = corners[(i + 2) % corners.size()];
        const Steps e = difference(b, a), f = difference(c, b);
        if (e.axis[u] == 0 && e.axis[v] == 0) return false;
        const Wide turn = (Wide(e.axis[u]) * f.axis[v] - Wide(e.axis[v]) * f.axis[u]) * left;
        if (turn < 0) return false;
        if (turn == 0 && Wide(e.axis[u]) * f.axis[u] + Wide(e.axis[v]) * f.axis[v] < 0) return false;
        reversals += forward(e) != forward(f);
    }
    return reversals == 2;
}

}  // namespace

PolygonFault check_polygon(std::span<const Vec3> corners) {
    if (corners.size() < 3) return PolygonFault::kTooFewCorners;
    for (const Vec3& corner : corners)
        if (!on_surface_grid(corner)) return PolygonFault::kOffGrid;
    const WideNormal normal = normal_of(corners);
    if (normal.axis[0] == 0 && normal.axis[1] == 0 && normal.axis[2] == 0) return PolygonFault::kNoArea;
    if (!planar(corners, normal)) return PolygonFault::kNotPlanar;
    return convex(corners, normal) ? PolygonFault::kNone : PolygonFault::kNotConvex;
}

}  // namespace firma

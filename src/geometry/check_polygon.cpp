// SPDX-License-Identifier: MIT
// Judges, in integers, whether corners make a polygon that can be cast against.
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "firma/polygon.h"
#include "geometry/exact_integer.h"
#include "geometry/judge_outline.h"

namespace firma {
namespace {

bool on_surface_grid(const Vec3& corner) {
    for (int axis = 0; axis < 3; ++axis) {
        const double steps = corner[axis] * kSurfaceSteps;
        if (!(steps >= INT32_MIN && steps <= INT32_MAX) || steps != std::floor(steps)) return false;
    }
    return true;
}

}  // namespace

PolygonFault check_polygon(std::span<const Vec3> corners) {
    if (corners.size() < 3) return PolygonFault::kTooFewCorners;
    std::vector<GridPoint> points;
    points.reserve(corners.size());
    for (const Vec3& corner : corners) {
        if (!on_surface_grid(corner)) return PolygonFault::kOffGrid;
        const Vec3 steps = corner * kSurfaceSteps;
        points.push_back({std::int32_t(steps.x), std::int32_t(steps.y), std::int32_t(steps.z)});
    }
    const OutlineJudge<std::int64_t, Int128, std::span<const GridPoint>> judge(points);
    if (!judge.has_normal()) return PolygonFault::kNoArea;
    const OutlineForm form = judge.form();
    if (form == OutlineForm::kNotPlanar) return PolygonFault::kNotPlanar;
    return form == OutlineForm::kConvex ? PolygonFault::kNone : PolygonFault::kNotConvex;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// What lanes are told of a sweep before the first look.
#include <cmath>

#include "world/sweep_lanes.h"

namespace firma {
namespace {

constexpr double kFarthest = 0x1p+20;

bool near_enough(const Sweep& sweep) {
    return max_abs(sweep.start) < kFarthest && sweep.end < kFarthest && sweep.radius < kFarthest;
}

/// Of doubles on the way, metres.
double rounding_error_of(const Sweep& sweep) {
    return 0x1p-44 * (max_abs(sweep.start) + 2 * sweep.end + sweep.radius + kWorldRim);
}

/// Floats of boxes' sides are exact; their distance from the start is off by a roundoff of its own, and by those of the
/// start.
double side_rounding(double rounding_error, double whole) {
    return rounding_error + 0x1p-20 + LaneSweep::kFartherRounding * whole;
}

}  // namespace

LaneSweep::LaneSweep(const Sweep& sweep) : path(&sweep), start(sweep.start) {
    if (!lanes_in_use() || !near_enough(sweep)) return;
    usable = true;
    particle = sweep.radius == 0;
    const double rounding_error = rounding_error_of(sweep);
    radius = size = float(sweep.radius);
    margin = float(rounding_error) + size * 0x1p-22f;
    const double all = sweep.radius + side_rounding(rounding_error, sweep.radius);
    reach = {all, all, all};
}

LaneSweep::LaneSweep(const Sweep& sweep, const ShapeExtent& shape)
    : axes(shape.axes), path(&sweep), start(sweep.start + shape.middle) {
    if (!lanes_in_use() || !near_enough(sweep)) return;
    usable = true;
    particle = false;
    const double rounding_error = rounding_error_of(sweep);
    double whole = shape.radius;
    Vec3 sides{shape.radius, shape.radius, shape.radius};
    for (int k = 0; k < axes; ++k) {
        const Vec3& a = shape.axis[std::size_t(k)];
        whole += length(a);
        for (int coordinate = 0; coordinate < 3; ++coordinate) axis[k][coordinate] = float(a[coordinate]);
        sides += Vec3{std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)};
    }
    radius = float(shape.radius);
    size = float(whole);
    margin = float(rounding_error) + size * 0x1p-22f;
    const double more = side_rounding(rounding_error, whole);
    reach = sides + Vec3{more, more, more};
    for (int coordinate = 0; coordinate < 3; ++coordinate) extent[coordinate] = float(sides[coordinate]);
}

}  // namespace firma

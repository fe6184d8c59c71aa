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
double grown_by(double reach, double whole, double middle, double rounding_error) {
    return reach + (rounding_error + 0x1p-20 + 0x1p-21 * (std::fabs(middle) + whole));
}

}  // namespace

LaneSweep::LaneSweep(const Sweep& sweep) {
    if (!lanes_in_use() || !near_enough(sweep)) return;
    usable = true;
    particle = sweep.radius == 0;
    const double rounding_error = rounding_error_of(sweep);
    radius = size = float(sweep.radius);
    margin = float(rounding_error) + size * 0x1p-22f;
    set_path(sweep, sweep.start);
    const auto grow = [&](double middle) { return grown_by(sweep.radius, sweep.radius, middle, rounding_error); };
    put({grow(sweep.start.x), grow(sweep.start.y), grow(sweep.start.z)}, grown);
}

LaneSweep::LaneSweep(const Sweep& sweep, const ShapeExtent& shape) {
    if (!lanes_in_use() || !near_enough(sweep)) return;
    usable = true;
    particle = false;
    const double rounding_error = rounding_error_of(sweep);
    axes = shape.axes;
    double whole = shape.radius;
    Vec3 reach{shape.radius, shape.radius, shape.radius};
    for (int k = 0; k < axes; ++k) {
        const Vec3& a = shape.axis[std::size_t(k)];
        whole += length(a);
        for (int coordinate = 0; coordinate < 3; ++coordinate) axis[k][coordinate] = float(a[coordinate]);
        reach += Vec3{std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)};
    }
    radius = float(shape.radius);
    size = float(whole);
    margin = float(rounding_error) + size * 0x1p-22f;
    const Vec3 middle = sweep.start + shape.middle;
    set_path(sweep, middle);
    const auto grow = [&](double by, double at) { return grown_by(by, whole, at, rounding_error); };
    put({grow(reach.x, middle.x), grow(reach.y, middle.y), grow(reach.z, middle.z)}, grown);
    for (int coordinate = 0; coordinate < 3; ++coordinate) extent[coordinate] = float(reach[coordinate]);
}

void LaneSweep::put(const Vec3& values, double (&into)[4]) {
    into[0] = values.x;
    into[1] = values.y;
    into[2] = values.z;
    into[3] = 0;
}

void LaneSweep::set_path(const Sweep& sweep, const Vec3& middle) {
    put(middle, start);
    put(sweep.direction, direction);
    longest = sweep.axis_k;
    aside[0] = sweep.axis_u;
    aside[1] = sweep.axis_v;
    shear[0] = float(sweep.shear_u);
    shear[1] = float(sweep.shear_v);
}
}  // namespace firma

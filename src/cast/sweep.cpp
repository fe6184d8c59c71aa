// SPDX-License-Identifier: MIT
// A cast made ready.
#include "cast/sweep.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/rounding.h"

namespace firma {
namespace {

/// The power of two at or below a positive normal number.
double power_of_two_below(double value) {
    constexpr std::uint64_t kExponentBits = 0x7ff0000000000000ull;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & kExponentBits);
}

/// Parts too small to matter become zero, so that exact products never underflow.
double without_dust(double part) {
    return std::fabs(part) < kSmallestNumber ? 0 : part;
}
Vec3 without_dust(const Vec3& v) {
    return {without_dust(v.x), without_dust(v.y), without_dust(v.z)};
}

/// Nor is any that is no number.
bool usable(const Vec3& v) {
    return std::fabs(v.x) <= kLargestNumber && std::fabs(v.y) <= kLargestNumber && std::fabs(v.z) <= kLargestNumber;
}

void set_projection(Sweep& sweep) {
    const Vec3& d = sweep.direction;
    const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    sweep.axis_k = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    sweep.axis_u = sweep.axis_k == 2 ? 0 : sweep.axis_k + 1;
    sweep.axis_v = sweep.axis_u == 2 ? 0 : sweep.axis_u + 1;
    if (d[sweep.axis_k] < 0) {  // keeps front faces counter-clockwise in the projection
        const int swap = sweep.axis_u;
        sweep.axis_u = sweep.axis_v;
        sweep.axis_v = swap;
    }
    sweep.shear_u = d[sweep.axis_u] / d[sweep.axis_k];
    sweep.shear_v = d[sweep.axis_v] / d[sweep.axis_k];
}

}  // namespace

Status make_sweep(const Sphere& sphere, const Vec3& path, Sweep& sweep) {
    if (!usable(sphere.centre) || !usable(path)) return Status::kInvalid;
    if (!(sphere.radius >= 0 && sphere.radius <= kLargestNumber)) return Status::kInvalid;
    const double size = max_abs(path);
    if (size < kShortestPath) return Status::kMiss;

    sweep.start = without_dust(sphere.centre);
    sweep.radius = sphere.radius < kSmallestNumber ? 0 : sphere.radius;
    sweep.end = power_of_two_below(size);
    sweep.direction = without_dust(path * (1 / sweep.end));
    sweep.direction_square = dot(sweep.direction, sweep.direction);
    sweep.direction_length = std::sqrt(sweep.direction_square);
    set_projection(sweep);
    return Status::kHit;
}

}  // namespace firma

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

/// Of a power of two that is neither the smallest nor the largest.
double inverse_of_power(double power) {
    constexpr std::uint64_t kTwiceTheBias = std::uint64_t(2 * 1023) << 52;
    return std::bit_cast<double>(kTwiceTheBias - std::bit_cast<std::uint64_t>(power));
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
double size_of(const Vec3& v) {
    return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}
bool usable(const Vec3& a, const Vec3& b) {
    return size_of(a) + size_of(b) <= kLargestNumber || (usable(a) && usable(b));  // at once, mostly
}

/// Without branches: which axis is the longest cannot be foreseen.
void set_projection(Sweep& sweep) {
    const double d[3] = {sweep.direction.x, sweep.direction.y, sweep.direction.z};
    const double x = std::fabs(d[0]), y = std::fabs(d[1]), z = std::fabs(d[2]);
    const int x_first = int(x >= y) & int(x >= z);
    const int k = (1 - x_first) * (2 - int(y >= z));
    static constexpr std::uint8_t kNext[] = {1, 2, 0, 1, 2};
    const int swap = d[k] < 0;  // keeps front faces counter-clockwise in the projection
    sweep.axis_k = k;
    sweep.axis_u = kNext[k + swap];
    sweep.axis_v = kNext[k + 1 - swap];
    sweep.shear_u = d[sweep.axis_u] / d[k];
    sweep.shear_v = d[sweep.axis_v] / d[k];
}

}  // namespace

Status make_sweep(const Sphere& sphere, const Vec3& path, Sweep& sweep) {
    if (!usable(sphere.centre, path)) return Status::kInvalid;
    if (!(sphere.radius >= 0 && sphere.radius <= kLargestNumber)) return Status::kInvalid;
    const double size = max_abs(path);
    if (size < kShortestPath) return Status::kMiss;

    sweep.start = without_dust(sphere.centre);
    sweep.radius = sphere.radius < kSmallestNumber ? 0 : sphere.radius;
    sweep.end = power_of_two_below(size);
    sweep.direction = without_dust(path * inverse_of_power(sweep.end));
    sweep.direction_square = dot(sweep.direction, sweep.direction);
    sweep.direction_length = std::sqrt(sweep.direction_square);
    set_projection(sweep);
    return Status::kHit;
}

}  // namespace firma

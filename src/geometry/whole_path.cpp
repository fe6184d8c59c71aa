// SPDX-License-Identifier: MIT
// A path in whole numbers.
#include "geometry/whole_path.h"

#include <bit>
#include <cmath>

namespace firma {
namespace {

constexpr int kGridBits = 12;  ///< of the grid's steps, beyond the binary point of 2^-30 m
constexpr double kStartSteps = kSurfaceSteps * (1 << kGridBits), kDirectionSteps = 0x1p+40, kFarthest = 0x1p+14;
static_assert(kStartSteps == 0x1p+30);

struct Whole {
    std::int64_t x, y, z;
    double rest;  ///< 0 where all of it is whole

    Whole(const Vec3& v, double steps) {
        const Vec3 scaled = v * steps;
        x = std::int64_t(scaled.x);
        y = std::int64_t(scaled.y);
        z = std::int64_t(scaled.z);
        rest = std::fabs(scaled.x - double(x)) + std::fabs(scaled.y - double(y)) + std::fabs(scaled.z - double(z));
    }

    /// How often all of it can be halved, at most `most` times.
    int common_bits(int most) const { return std::countr_zero(std::uint64_t(x | y | z) | std::uint64_t(1) << most); }
};

std::uint64_t bits_of(std::int64_t number) {
    return std::uint64_t(number ^ (number >> 63));
}

}  // namespace

WholePath::WholePath(const Vec3& start, const Vec3& direction) {
    if (!(max_abs(start) <= kFarthest)) return;
    const Whole s(start, kStartSteps), d(direction, kDirectionSteps);
    known_ = s.rest + d.rest == 0;
    const int shorter = s.common_bits(kGridBits), narrower = d.common_bits(40);
    grid_bits_ = kGridBits - shorter;
    start_[0] = s.x >> shorter;
    start_[1] = s.y >> shorter;
    start_[2] = s.z >> shorter;
    direction_[0] = d.x >> narrower;
    direction_[1] = d.y >> narrower;
    direction_[2] = d.z >> narrower;
    const std::uint64_t longest = bits_of(direction_[0]) | bits_of(direction_[1]) | bits_of(direction_[2]);
    short_ = std::int64_t(1) << (60 - std::bit_width(longest));
}

}  // namespace firma

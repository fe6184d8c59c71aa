// SPDX-License-Identifier: MIT
// A path in whole numbers.
//
// With e = b - a and w the corner a or b as seen from the start, direction . ((a - start) x (b - start)) is
// e . (direction x w). A start within 2^14 m has 44 bits in steps of 2^-30 m, w 45, the direction 41, their moment 87;
// e, in steps of the grid, has 33, and the sum of three products 122. Steps are made as long as start and direction
// allow: then moments mostly have 63 bits.
#include "geometry/whole_path.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/exact_integer.h"
#include "geometry/exact_predicates.h"

namespace firma {
namespace {

constexpr int kGridBits = 12;  ///< of the grid's steps, beyond the binary point of 2^-30 m
constexpr double kStartSteps = kSurfaceSteps * (1 << kGridBits), kDirectionSteps = 0x1p+40, kFarthest = 0x1p+14;
static_assert(kStartSteps == 0x1p+30);

/// @return whether it is whole
bool to_whole(const Vec3& v, double steps, std::int64_t (&whole)[3]) {
    bool is_whole = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double scaled = v[axis] * steps;
        whole[axis] = std::int64_t(scaled);
        is_whole &= double(whole[axis]) == scaled;
    }
    return is_whole;
}

/// Divides by a power of two that all have in common.
/// @return its exponent, at most `most`
int shorten(std::int64_t (&numbers)[3], int most) {
    const int bits = std::min(
        std::countr_zero(std::uint64_t(numbers[0] | numbers[1] | numbers[2]) | std::uint64_t(1) << most), most);
    for (std::int64_t& number : numbers) number >>= bits;
    return bits;
}

}  // namespace

WholePath::WholePath(const Vec3& start, const Vec3& direction) {
    if (!(max_abs(start) <= kFarthest)) return;
    known_ = to_whole(start, kStartSteps, start_) & to_whole(direction, kDirectionSteps, direction_);
    if (!known_) return;
    grid_bits_ = kGridBits - shorten(start_, kGridBits);
    shorten(direction_, 40);
    std::uint64_t longest = 0;
    for (const std::int64_t d : direction_) longest |= std::uint64_t(d < 0 ? -d : d);
    short_ = std::int64_t(1) << (61 - std::bit_width(longest));
}

WholePath::Seen WholePath::see(const GridPoint& corner) const {
    Seen seen;
    std::uint64_t far = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t w = (std::int64_t(corner[axis]) << grid_bits_) - start_[axis];
        far |= std::uint64_t(w ^ (w >> 63));
        seen.at[axis] = w;
    }
    seen.near = far < std::uint64_t(short_);
    return seen;
}

/// Of the line about a corner: direction x w.
template <class Number>
struct WholePath::Moment {
    Number x, y, z;

    Moment(const std::int64_t (&d)[3], const std::int64_t (&w)[3])
        : x(Number(d[1]) * w[2] - Number(d[2]) * w[1]),
          y(Number(d[2]) * w[0] - Number(d[0]) * w[2]),
          z(Number(d[0]) * w[1] - Number(d[1]) * w[0]) {}

    bool is_zero() const { return (x | y | z) == 0; }
    /// Of an edge at that corner, as a bit of EdgeSigns.
    unsigned side_of(const GridPoint& from, const GridPoint& to) const {
        const Int128 sum = Int128(x) * (std::int64_t(to.x) - from.x) + Int128(y) * (std::int64_t(to.y) - from.y) +
                           Int128(z) * (std::int64_t(to.z) - from.z);
        return sum > 0 ? unsigned(kSomePositive) : sum < 0 ? unsigned(kSomeNegative) : 0u;
    }
};

constexpr std::uint8_t kNextCorner[] = {1, 2, 0, 1};

/// @param at    the corner that two open edges share, or that the only one begins at
/// @param seen  that corner
template <class Number>
unsigned WholePath::sides_by(const GridPoint (&corners)[3], unsigned open, unsigned at, const Seen& seen) const {
    const Moment<Number> moment(direction_, seen.at);
    const unsigned next = kNextCorner[at], last = kNextCorner[at + 1];
    if (moment.is_zero() && open != 7) return 0;  // through the corner
    unsigned signs = moment.side_of(corners[at], corners[next]);
    if (open >> last & 1) signs |= moment.side_of(corners[last], corners[at]);
    if (open == 7) signs |= Moment<Int128>(direction_, see(corners[next]).at).side_of(corners[next], corners[last]);
    return signs;
}

unsigned WholePath::triangle_sides(const GridPoint (&corners)[3], unsigned open) const {
    static constexpr std::uint8_t kShared[] = {0, 0, 1, 1, 2, 0, 2, 0};
    const unsigned at = kShared[open];
    const Seen seen = see(corners[at]);
    return seen.near ? sides_by<std::int64_t>(corners, open, at, seen) : sides_by<Int128>(corners, open, at, seen);
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// Signs that must never be wrong.
#include "geometry/exact_predicates.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/seldom.h"
#include "geometry/exact_integer.h"
#include "geometry/expansion.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Sum over the axes of (a[axis][0] + a[axis][1] + ...) * (n[axis][0] + n[axis][1]), exactly.
template <int parts>
int exact_dot_sign(const double (&a)[3][parts], const ExactNormal& n) {
    Expansion<3 * parts * 4> sum;
    for (int axis = 0; axis < 3; ++axis)
        for (const double x : a[axis])
            for (const double y : n.axis[axis]) sum.add_product(x, y);
    return sum.sign();
}

double sum_of_magnitudes(const Vec3& a, const Vec3& b) {
    return std::fabs(a.x * b.x) + std::fabs(a.y * b.y) + std::fabs(a.z * b.z);
}

/// a * b * c added exactly, for numbers held as two doubles each (a as one).
template <class Sum>
void add_triple(Sum& sum, double a, const DoubleDouble& b, const DoubleDouble& c) {
    for (const double x : {b.high, b.low})
        for (const double y : {c.high, c.low}) {
            if (x == 0 || y == 0) continue;
            const DoubleDouble xy = two_product(x, y);
            sum.add_product(a, xy.low);
            sum.add_product(a, xy.high);
        }
}

FIRMA_SELDOM int edge_side_in_parts(const Vec3& start, const Vec3& direction, const Vec3& a, const Vec3& b) {
    DoubleDouble wa[3], wb[3];
    for (int axis = 0; axis < 3; ++axis) {
        wa[axis] = two_difference(a[axis], start[axis]);
        wb[axis] = two_difference(b[axis], start[axis]);
    }
    Expansion<6 * 16> sum;  // six triple products of at most 4 x 2 x 2 parts
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        add_triple(sum, direction[k], wa[u], wb[v]);
        add_triple(sum, -direction[k], wa[v], wb[u]);
    }
    return sum.sign();
}

struct WholeVec {
    std::int64_t x, y, z;
};

WholeVec operator-(const WholeVec& a, const WholeVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// The power of two that takes numbers of at most a size to 60 bits.
/// @param size  at most 2^202
double whole_scale(double size) {
    constexpr std::uint64_t kExponentBits = 0x7ff0000000000000ull, kBias = 1023;
    const auto bits = std::bit_cast<std::uint64_t>(std::max(size, kSmallestNumber));
    return std::bit_cast<double>(((2 * kBias + 59) << 52) - (bits & kExponentBits));
}

/// @param scale  |v| * scale is at most 2^60
/// @return what is left of v * scale: 0 where that is whole
FIRMA_SELDOM double to_whole(const Vec3& v, double scale, WholeVec& whole) {
    const Vec3 scaled = v * scale;
    whole = {std::int64_t(scaled.x), std::int64_t(scaled.y), std::int64_t(scaled.z)};
    return std::fabs(scaled.x - double(whole.x)) + std::fabs(scaled.y - double(whole.y)) +
           std::fabs(scaled.z - double(whole.z));
}

/// A line's moment about a corner: w = corner - start, of 61 bits, and the direction, of 60, make 122.
struct Moment {
    Int128 x, y, z;

    FIRMA_SELDOM Moment(const WholeVec& direction, const WholeVec& w)
        : x(Int128(direction.y) * w.z - Int128(direction.z) * w.y),
          y(Int128(direction.z) * w.x - Int128(direction.x) * w.z),
          z(Int128(direction.x) * w.y - Int128(direction.y) * w.x) {}

    /// Sign of edge . moment, for an edge of 61 bits. Of moment = high * 2^64 + low, 0 <= low < 2^64, the sum of the
    /// highs' products has 58 + 61 + 2 bits, that of the lows' 64 + 61 + 2.
    FIRMA_SELDOM int sign_along(const WholeVec& edge) const {
        const Int128 low =
            Int128(edge.x) * std::uint64_t(x) + Int128(edge.y) * std::uint64_t(y) + Int128(edge.z) * std::uint64_t(z);
        const Int128 high = Int128(edge.x) * std::int64_t(x >> 64) + Int128(edge.y) * std::int64_t(y >> 64) +
                            Int128(edge.z) * std::int64_t(z >> 64) + (low >> 64);
        return high < 0 ? -1 : (high | std::uint64_t(low)) != 0;
    }
};

}  // namespace

// Each term is off by at most: the normal's rounding, the product's, two additions'; one more where a difference is
// rounded first.
int exact_facing(const Vec3& direction, const PolygonShape& polygon) {
    const double estimate = dot(direction, polygon.normal);
    if (std::fabs(estimate) > rounding(8) * sum_of_magnitudes(direction, polygon.normal)) return sign(estimate);
    const double parts[3][1] = {{direction.x}, {direction.y}, {direction.z}};
    return exact_dot_sign(parts, exact_normal(polygon.corners));
}

int exact_plane_side(const Vec3& point, const PolygonShape& polygon) {
    const Vec3 w = point - polygon.corners[0];
    const double estimate = dot(w, polygon.normal);
    if (std::fabs(estimate) > rounding(8) * sum_of_magnitudes(w, polygon.normal)) return sign(estimate);
    double parts[3][2];
    for (int axis = 0; axis < 3; ++axis) {
        const DoubleDouble d = two_difference(point[axis], polygon.corners[0][axis]);
        parts[axis][0] = d.high;
        parts[axis][1] = d.low;
    }
    return exact_dot_sign(parts, exact_normal(polygon.corners));
}

int exact_plane_side(const Vec3& point, const Vec3& offset, const PolygonShape& polygon) {
    const Vec3 first = point - polygon.corners[0];
    const Vec3 w = first + offset;
    const Vec3 sizes{std::fabs(first.x) + std::fabs(offset.x), std::fabs(first.y) + std::fabs(offset.y),
                     std::fabs(first.z) + std::fabs(offset.z)};
    const double estimate = dot(w, polygon.normal);
    if (std::fabs(estimate) > rounding(10) * sum_of_magnitudes(sizes, polygon.normal)) return sign(estimate);
    double parts[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        const DoubleDouble d = two_difference(point[axis], polygon.corners[0][axis]);
        parts[axis][0] = d.high;
        parts[axis][1] = d.low;
        parts[axis][2] = offset[axis];
    }
    return exact_dot_sign(parts, exact_normal(polygon.corners));
}

// With e = b - a and w the corner a or b as seen from the start, direction . ((a - start) x (b - start)) is
// e . (direction x w). Start and corners times one power of two, and the direction times another, mostly are whole
// numbers of 60 bits: of floats those where none but 0 is below 2^-34 of the largest, of doubles 2^-5. Then all of it
// is whole, and exact.
FIRMA_SELDOM int exact_edge_side(const Vec3& start, const Vec3& direction, const Vec3& a, const Vec3& b) {
    const double scale = whole_scale(std::max({max_abs(start), max_abs(a), max_abs(b)}));
    WholeVec s, d, p, q;
    const double left = to_whole(start, scale, s) + to_whole(direction, whole_scale(max_abs(direction)), d) +
                        to_whole(a, scale, p) + to_whole(b, scale, q);
    if (left == 0) return Moment(d, p - s).sign_along(q - p);
    return edge_side_in_parts(start, direction, a, b);
}

}  // namespace firma

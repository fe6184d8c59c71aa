// SPDX-License-Identifier: MIT
// What tests of exact arithmetic share: numbers without end to compare with, and points and planes that are hard on it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "geometry/exact_plane.h"
#include "scenes/rng.h"

namespace firma {

using Big = boost::multiprecision::cpp_int;

inline int sign_of(const Big& value) {
    return value < 0 ? -1 : value > 0 ? 1 : 0;
}

inline Big big(Int128 value) {
    return Big(std::int64_t(value >> 64)) * (Big(1) << 64) + Big(std::uint64_t(value));
}

inline Big big(const Int256& value) {
    Big sum = std::int64_t(value.word[3]);
    for (int k = 2; k >= 0; --k) sum = sum * (Big(1) << 64) + Big(value.word[k]);
    return sum;
}

/// A double that is a whole number.
inline Big big(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);  // value = fraction * 2^exponent
    const Big digits = std::int64_t(fraction * 0x1p53);
    return exponent >= 53 ? Big(digits * (Big(1) << (exponent - 53))) : Big(digits / (Big(1) << (53 - exponent)));
}

/// Whether a double is the nearest to a whole number, halves to even. It says so by looking at its neighbours.
inline bool is_nearest(double value, const Big& exact) {
    const auto distance = [&](double other) -> Big { return abs(big(other) - exact); };
    if (std::fabs(value) < 0x1p53) return distance(value) == 0;
    const double below = std::nextafter(value, -INFINITY), above = std::nextafter(value, INFINITY);
    const Big here = distance(value);
    if (here > distance(below) || here > distance(above)) return false;
    if (here < distance(below) && here < distance(above)) return true;
    int exponent = 0;
    return std::int64_t(std::frexp(value, &exponent) * 0x1p53) % 2 == 0;
}

/// A plane as its definition has it, nothing divided: normal . p + offset.
struct BigPlane {
    Big normal[3], offset;
};

inline BigPlane big_plane(const InputPoint& a, const InputPoint& b, const InputPoint& c) {
    BigPlane plane;
    for (int axis = 0; axis < 3; ++axis) {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        plane.normal[axis] = (Big(b[i]) - a[i]) * (Big(c[j]) - a[j]) - (Big(b[j]) - a[j]) * (Big(c[i]) - a[i]);
        plane.offset -= plane.normal[axis] * a[axis];
    }
    return plane;
}

inline BigPlane big_plane(const Plane& plane) {
    return {{big(Int128(plane.normal[0])), big(Int128(plane.normal[1])), big(Int128(plane.normal[2]))},
            big(plane.offset())};
}

inline Big determinant(const Big (&a)[3], const Big (&b)[3], const Big (&c)[3]) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// x[axis] / w, w > 0.
struct BigPoint {
    Big x[3], w = 1;
};

inline BigPoint big_point(const InputPoint& p) {
    return {{p.x, p.y, p.z}, 1};
}

/// Cramer's rule, a column at a time. w = 0 where the planes do not meet in one point.
inline BigPoint big_meet(const BigPlane& a, const BigPlane& b, const BigPlane& c) {
    BigPoint point;
    point.w = determinant(a.normal, b.normal, c.normal);
    for (int axis = 0; axis < 3; ++axis) {
        Big rows[3][3];
        const BigPlane* planes[3] = {&a, &b, &c};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                rows[row][column] = column == axis ? Big(-planes[row]->offset) : planes[row]->normal[column];
        point.x[axis] = determinant(rows[0], rows[1], rows[2]);
    }
    if (point.w < 0) {
        for (Big& x : point.x) x = -x;
        point.w = -point.w;
    }
    return point;
}

inline int side(const BigPlane& plane, const BigPoint& point) {
    return sign_of(plane.normal[0] * point.x[0] + plane.normal[1] * point.x[1] + plane.normal[2] * point.x[2] +
                   plane.offset * point.w);
}

/// What a world of 26 bits holds.
inline bool in_world(const BigPoint& point) {
    bool in = point.w > 0;
    for (const Big& x : point.x) in = in && x >= -(point.w << 25) && x < (point.w << 25);
    return in;
}

/// Points of the input grid: anywhere within `span` of a centre, held to the world, whose rim they often reach.
class Points {
public:
    Points(std::uint64_t seed, std::int32_t span) : rng_(seed), span_(span) { move(); }

    /// A new centre: anywhere, or at one of the world's corners.
    void move() {
        const bool corner = rng_.chance(0.3);
        for (int axis = 0; axis < 3; ++axis) {
            const auto anywhere = std::int32_t(std::int64_t(rng_.below(1u << 26)) - kRimSteps);
            center_[axis] = !corner ? anywhere : anywhere < 0 ? -kRimSteps : kRimSteps - 1;
        }
    }
    InputPoint next() { return near(center_, span_); }
    InputPoint near(const InputPoint& center, std::int32_t span) {
        InputPoint p;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t moved = std::int64_t(center[axis]) - span + rng_.below(2 * std::uint32_t(span) + 1);
            p[axis] = std::int32_t(moved < -kRimSteps ? -kRimSteps : moved >= kRimSteps ? kRimSteps - 1 : moved);
        }
        return p;
    }
    scenes::Rng& rng() { return rng_; }

private:
    scenes::Rng rng_;
    std::int32_t span_;
    InputPoint center_;
};

}  // namespace firma

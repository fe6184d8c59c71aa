// SPDX-License-Identifier: MIT
// An axis that a plane is seen along, and corners projected along it: exact turns and areas in whole numbers.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "geometry/exact_integer.h"

namespace firma {

/// Where a plane is seen from: what is counter-clockwise about the axis, or about its negative when flipped, comes out
/// counter-clockwise.
struct FlatView {
    int axis = 2;
    bool flip = false;

    /// The axes that become u and v.
    int u() const { return (axis + (flip ? 2 : 1)) % 3; }
    int v() const { return (axis + (flip ? 1 : 2)) % 3; }
};

/// Surface steps; 64 bits wide so that differences (33 bits) never overflow.
struct FlatPoint {
    std::int64_t u = 0, v = 0;

    friend bool operator==(const FlatPoint&, const FlatPoint&) = default;
    friend bool operator<(const FlatPoint& a, const FlatPoint& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; }
};

inline FlatPoint project(const GridPoint& point, FlatView view) {
    return {point[view.u()], point[view.v()]};
}

/// Twice the area of a triangle (67 bits): positive when it runs counter-clockwise, when c lies left of a -> b.
inline Int128 turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
    return Int128(b.u - a.u) * (c.v - a.v) - Int128(b.v - a.v) * (c.u - a.u);
}

/// Whether two closed segments share a point. Their boxes do: that settles the case of one common line.
inline bool segments_meet(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c, const FlatPoint& d) {
    const auto apart = [](Int128 x, Int128 y) { return (x > 0 && y > 0) || (x < 0 && y < 0); };
    return !apart(turn(a, b, c), turn(a, b, d)) && !apart(turn(c, d, a), turn(c, d, b));
}

/// Square of the distance in space, rounded: for choosing only.
inline double square_distance(const GridPoint& a, const GridPoint& b) {
    const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
    return x * x + y * y + z * z;
}

/// Whether four points lie in one plane, exactly.
inline bool coplanar(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
    std::int64_t m[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        m[0][axis] = std::int64_t(b[axis]) - a[axis];
        m[1][axis] = std::int64_t(c[axis]) - a[axis];
        m[2][axis] = std::int64_t(d[axis]) - a[axis];
    }
    // A determinant whose last 64 bits are not all zero is not zero: this settles nearly every slanted case.
    using Low = std::uint64_t;
    Low low = 0;
    for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k)
        low += Low(m[2][k]) * (Low(m[0][i]) * Low(m[1][j]) - Low(m[0][j]) * Low(m[1][i]));
    if (low != 0) return false;
    Int128 whole = 0;  // 102 bits
    for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k)
        whole += m[2][k] * (Int128(m[0][i]) * m[1][j] - Int128(m[0][j]) * m[1][i]);
    return whole == 0;
}

}  // namespace firma

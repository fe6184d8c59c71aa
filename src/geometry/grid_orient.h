// SPDX-License-Identifier: MIT
// Signs of triangles of the input grid, for meshes that might cross themselves. Differences have 27 bits with sign,
// minors 55, determinants 83.
#pragma once

#include <cstdint>

#include "geometry/exact_plane.h"

namespace firma {

/// Twice the area vector of a triangle, counter-clockwise; components have 55 bits.
struct AreaVector {
    std::int64_t x = 0, y = 0, z = 0;
};

inline AreaVector area_vector(const InputPoint& a, const InputPoint& b, const InputPoint& c) {
    const std::int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const std::int64_t vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

inline bool on_one_line(const InputPoint& a, const InputPoint& b, const InputPoint& c) {
    const AreaVector normal = area_vector(a, b, c);
    return normal.x == 0 && normal.y == 0 && normal.z == 0;
}

/// normal . (p - a)
inline Int128 height(const InputPoint& a, const AreaVector& normal, const InputPoint& p) {
    return Int128(normal.x) * (p.x - a.x) + Int128(normal.y) * (p.y - a.y) + Int128(normal.z) * (p.z - a.z);
}

/// The side of the plane through a that p lies on.
inline int side_of_plane(const InputPoint& a, const AreaVector& normal, const InputPoint& p) {
    const Int128 above = height(a, normal, p);
    return above > 0 ? 1 : above < 0 ? -1 : 0;
}

/// The side of the plane through a, b, c that p lies on: positive where they run counter-clockwise seen from p.
inline int orient(const InputPoint& a, const InputPoint& b, const InputPoint& c, const InputPoint& p) {
    return side_of_plane(a, area_vector(a, b, c), p);
}

/// The two axes left when a plane is seen along the largest component of its normal. The view may be a mirrored one:
/// signs are only compared with each other.
struct GridView {
    int u = 0, v = 1;

    explicit GridView(const AreaVector& normal) {
        const auto size = [](std::int64_t n) { return n < 0 ? -n : n; };
        const std::int64_t x = size(normal.x), y = size(normal.y), z = size(normal.z);
        if (x >= y && x >= z) {
            u = 1;
            v = 2;
        } else if (y >= z) {
            u = 2;
            v = 0;
        }
    }
    int turn(const InputPoint& a, const InputPoint& b, const InputPoint& p) const {
        const std::int64_t bu = b[u] - a[u], bv = b[v] - a[v], pu = p[u] - a[u], pv = p[v] - a[v];
        const std::int64_t area = bu * pv - bv * pu;
        return area > 0 ? 1 : area < 0 ? -1 : 0;
    }
    /// Whether p, on the line a b, lies between the two, or at one.
    bool between(const InputPoint& a, const InputPoint& b, const InputPoint& p) const {
        const int axis = a[u] != b[u] ? u : v;
        return a[axis] < b[axis] ? a[axis] <= p[axis] && p[axis] <= b[axis] : b[axis] <= p[axis] && p[axis] <= a[axis];
    }
    bool segments_meet(const InputPoint& a, const InputPoint& b, const InputPoint& p, const InputPoint& q) const {
        const int sp = turn(a, b, p), sq = turn(a, b, q), sa = turn(p, q, a), sb = turn(p, q, b);
        if (sp * sq < 0 && sa * sb < 0) return true;
        return (sp == 0 && between(a, b, p)) || (sq == 0 && between(a, b, q)) || (sa == 0 && between(p, q, a)) ||
               (sb == 0 && between(p, q, b));
    }
};

}  // namespace firma

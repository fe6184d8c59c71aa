// SPDX-License-Identifier: MIT
// Signs that must never be wrong.
#include "geometry/exact_predicates.h"

#include <cmath>

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

int exact_edge_side(const Vec3& start, const Vec3& direction, const Vec3& a, const Vec3& b) {
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

}  // namespace firma

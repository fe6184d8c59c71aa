// SPDX-License-Identifier: MIT
// The exact sign of a triple product of vectors that are sums of doubles.
// Source: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997.
#pragma once

#include "firma/vec.h"
#include "geometry/expansion.h"

namespace firma {

/// A vector whose coordinates are sums of doubles, taken exactly.
template <int parts>
struct SumVec {
    double at[3][parts];
};

inline SumVec<1> as_sum(const Vec3& v) {
    return {{{v.x}, {v.y}, {v.z}}};
}

/// a - b.
inline SumVec<2> difference_as_sum(const Vec3& a, const Vec3& b) {
    SumVec<2> sum;
    for (int axis = 0; axis < 3; ++axis) {
        const DoubleDouble d = two_difference(a[axis], b[axis]);
        sum.at[axis][0] = d.high;
        sum.at[axis][1] = d.low;
    }
    return sum;
}

/// Sign of a . b. Numbers as in exact_predicates.h.
template <int parts_a, int parts_b>
int exact_dot_sign(const SumVec<parts_a>& a, const SumVec<parts_b>& b) {
    Expansion<3 * parts_a * parts_b * 2> sum;
    for (int axis = 0; axis < 3; ++axis)
        for (const double x : a.at[axis])
            for (const double y : b.at[axis]) sum.add_product(x, y);
    return sum.sign();
}

/// Sign of a . (b x c). Numbers as in exact_predicates.h.
template <int parts_a, int parts_b, int parts_c>
int exact_triple_sign(const SumVec<parts_a>& a, const SumVec<parts_b>& b, const SumVec<parts_c>& c) {
    Expansion<6 * parts_a * parts_b * parts_c * 4> sum;
    const auto add = [&](const double(&first)[parts_b], const double(&second)[parts_c], const double(&third)[parts_a],
                         double turn) {
        for (const double x : first)
            for (const double y : second) {
                if (x == 0 || y == 0) continue;
                const DoubleDouble xy = two_product(x, y);
                for (const double z : third) {
                    sum.add_product(turn * z, xy.low);
                    sum.add_product(turn * z, xy.high);
                }
            }
    };
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        add(b.at[u], c.at[v], a.at[k], 1);
        add(b.at[v], c.at[u], a.at[k], -1);
    }
    return sum.sign();
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// Vectors over double or DoubleDouble, so that each equation of a contact is written once and solved in either.
#pragma once

#include "cast/entry.h"
#include "cast/sweep.h"
#include "geometry/double_double.h"
#include "geometry/rounding.h"

namespace firma {

template <class Real>
struct VectorOf {
    Real x, y, z;
};

template <class Real>
VectorOf<Real> operator+(const VectorOf<Real>& a, const VectorOf<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
VectorOf<Real> operator*(const VectorOf<Real>& a, const Real& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class Real>
Real dot(const VectorOf<Real>& a, const VectorOf<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
VectorOf<Real> cross(const VectorOf<Real>& a, const VectorOf<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Exact for what fits.
template <class Real>
VectorOf<Real> exactly(const Vec3& v) {
    return {Real(v.x), Real(v.y), Real(v.z)};
}

/// a - b: rounded in double, exact in DoubleDouble.
template <class Real>
VectorOf<Real> difference(const Vec3& a, const Vec3& b);

template <>
inline VectorOf<double> difference<double>(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <>
inline VectorOf<DoubleDouble> difference<DoubleDouble>(const Vec3& a, const Vec3& b) {
    return {two_difference(a.x, b.x), two_difference(a.y, b.y), two_difference(a.z, b.z)};
}

/// A precise time of touch as an answer: one at the end of the path to the last digit counts, one before the start is
/// at the start.
inline Entry counted(const Sweep& sweep, const DoubleDouble& t) {
    const DoubleDouble end = DoubleDouble(sweep.end, sweep.end * 8 * kDoubleDoubleRoundoff);
    if (end < t) return {};
    const double rounded_t = rounded(t);
    return {Entry::kFound, rounded_t < 0 ? 0 : rounded_t > sweep.end ? sweep.end : rounded_t};
}

}  // namespace firma

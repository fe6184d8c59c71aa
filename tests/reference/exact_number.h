// SPDX-License-Identifier: MIT
// Whole numbers of any size, ratios of them, and roots of quadratics: what the oracle decides with. No rounding
// anywhere.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <string>

namespace firma::reference {

/// Any whole number; up to 512 bits it needs no memory of its own.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      512, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                      std::allocator<boost::multiprecision::limb_type>>,
                                  boost::multiprecision::et_off>;

inline int sign(const Integer& x) {
    return x.sign();
}
inline Integer square(const Integer& x) {
    return x * x;
}

struct IntegerVec {
    Integer x, y, z;
};

inline IntegerVec operator+(const IntegerVec& a, const IntegerVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline IntegerVec operator-(const IntegerVec& a, const IntegerVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline IntegerVec operator*(const IntegerVec& a, const Integer& s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Integer dot(const IntegerVec& a, const IntegerVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline IntegerVec cross(const IntegerVec& a, const IntegerVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// top / bottom, bottom > 0, not reduced.
struct Ratio {
    Integer top = 0, bottom = 1;
};

/// -1, 0, 1 as a is below, at or above b.
int compare(const Ratio& a, const Ratio& b);

/// The largest whole number whose square is at most x; x >= 0.
Integer floor_root(const Integer& x);

/// A number of a quadratic's making: (p - sqrt(s)) / q with s >= 0, q > 0.
struct Root {
    Integer p = 0, s = 0, q = 1;

    /// floor(value * scale); scale >= 0
    Integer floor_times(const Integer& scale) const;
    bool is_zero() const;
};

/// -1, 0, 1 as a is below, at or above b: by squaring, so that no root is ever taken.
int compare(const Root& a, const Root& b);

/// x = mantissa * 2^exponent; x finite, mantissa odd or 0.
struct Dyadic {
    long long mantissa = 0;
    int exponent = 0;
};
Dyadic dyadic(double x);

/// x in units of 2^-unit, which must divide it.
Integer in_units(double x, int unit);

/// Within two units in the last place of a * 2^exponent; infinite or 0 beyond the range of double.
double nearest(const Ratio& a, int exponent = 0);

/// (sqrt(square) - minus) * 2^exponent, without cancellation: the error is a few units in the last place of the result,
/// or 2^(exponent - 120), whichever is larger.
double root_minus(const Ratio& square, const Integer& minus, int exponent);

/// x >= 0 in decimals.
std::string decimals(const Root& x, int digits);

}  // namespace firma::reference

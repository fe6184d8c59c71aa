// SPDX-License-Identifier: MIT
// Numbers of twice the digits: an unevaluated sum of two doubles, for what double leaves open.
// Source: T. J. Dekker, A Floating-Point Technique for Extending the Available Precision, 1971; D. Knuth, TAOCP vol.
// 2, 4.2.2.
#pragma once

#include <cmath>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error \
    "Firma's own files must be compiled without -ffast-math and -ffinite-math-only; programs that use it need not be."
#endif

namespace firma {

/// high + low, |low| at most half an ulp of high.
struct DoubleDouble {
    double high = 0, low = 0;

    DoubleDouble() = default;
    DoubleDouble(double value) : high(value) {}
    DoubleDouble(double h, double l) : high(h), low(l) {}
};

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
    const double sum = a + b;
    const double back = sum - a;
    return {sum, (a - (sum - back)) + (b - back)};
}

/// a + b exactly, when |a| >= |b| or a is 0.
inline DoubleDouble quick_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

inline DoubleDouble two_difference(double a, double b) {
    return two_sum(a, -b);
}

/// a in two halves of 26 bits.
inline DoubleDouble halves(double a) {
    constexpr double kSplitter = 0x1p27 + 1;
    const double big = kSplitter * a;
    const double high = big - (big - a);
    return {high, a - high};
}

/// a * b exactly, barring overflow and underflow. No fused multiply-add: it would differ between machines where used by
/// halves.
inline DoubleDouble two_product(double a, double b) {
    const double product = a * b;
    const DoubleDouble x = halves(a), y = halves(b);
    const double error = ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
    return {product, error};
}

inline DoubleDouble operator-(const DoubleDouble& a) {
    return {-a.high, -a.low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    DoubleDouble s = two_sum(a.high, b.high);
    const DoubleDouble t = two_sum(a.low, b.low);
    s = quick_two_sum(s.high, s.low + t.high);
    return quick_two_sum(s.high, s.low + t.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + (-b);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble p = two_product(a.high, b.high);
    return quick_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high / b.high;
    const DoubleDouble rest2 = rest - b * DoubleDouble(second);
    return quick_two_sum(first, second) + DoubleDouble(rest2.high / b.high);
}

inline DoubleDouble square_root(const DoubleDouble& a) {
    if (a.high <= 0) return {};
    const double first = std::sqrt(a.high);
    const DoubleDouble rest = a - two_product(first, first);
    return quick_two_sum(first, rest.high / (2 * first));
}

inline double square_root(double a) {
    return std::sqrt(a);
}
inline double rounded(const DoubleDouble& a) {
    return a.high + a.low;
}
inline double rounded(double a) {
    return a;
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}

}  // namespace firma

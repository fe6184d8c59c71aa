// SPDX-License-Identifier: MIT
// Points and directions in double: the numbers that motion is made of. Everything here costs a few operations.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

/// For a function with floating-point numbers that is defined in a public header. The linker keeps one copy of an
/// inline function that was not inlined, maybe that of a program built with -ffast-math, where NaN passes for finite.
/// What is always inlined has no such copy: the library runs what was compiled for the library.
#define FIRMA_INLINE [[gnu::always_inline]] inline

namespace firma {

/// A point or a direction. Metres, right-handed, no built-in up.
struct Vec3 {
    double x = 0, y = 0, z = 0;

    FIRMA_INLINE double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    FIRMA_INLINE double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    FIRMA_INLINE friend bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

FIRMA_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
FIRMA_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
FIRMA_INLINE Vec3 operator-(const Vec3& a) {
    return {-a.x, -a.y, -a.z};
}
FIRMA_INLINE Vec3 operator*(const Vec3& a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
FIRMA_INLINE Vec3 operator*(double s, const Vec3& a) {
    return a * s;
}

FIRMA_INLINE Vec3& operator+=(Vec3& a, const Vec3& b) {
    return a = a + b;
}
FIRMA_INLINE Vec3& operator-=(Vec3& a, const Vec3& b) {
    return a = a - b;
}
FIRMA_INLINE Vec3& operator*=(Vec3& a, double s) {
    return a = a * s;
}

FIRMA_INLINE double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
FIRMA_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
FIRMA_INLINE double length(const Vec3& a) {
    return std::sqrt(dot(a, a));
}

/// The largest absolute coordinate.
FIRMA_INLINE double max_abs(const Vec3& a) {
    const double x = std::fabs(a.x), y = std::fabs(a.y), z = std::fabs(a.z);
    const double xy = x < y ? y : x;
    return xy < z ? z : xy;
}
/// Its name in version 0.1; the next version has it no more.
[[deprecated("max_abs()")]] FIRMA_INLINE double largest(const Vec3& a) {
    return max_abs(a);
}

/// By the bits, so that no option for floating point decides. (A program built with -ffast-math promises that it has
/// no such numbers; what this tells there of its own results, its compiler may decide. The library asks again.)
FIRMA_INLINE bool is_finite(const double& a) {
    constexpr std::uint64_t kExponent = 0x7ff0'0000'0000'0000;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &a, sizeof bits);
    return (bits & kExponent) != kExponent;
}
FIRMA_INLINE bool is_finite(const Vec3& a) {
    return is_finite(a.x) && is_finite(a.y) && is_finite(a.z);
}

/// An axis-aligned box, closed. Empty when a `low` exceeds its `high`.
struct Box {
    Vec3 low{INFINITY, INFINITY, INFINITY};
    Vec3 high{-INFINITY, -INFINITY, -INFINITY};

    FIRMA_INLINE bool empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
    FIRMA_INLINE void add(const Vec3& p) {
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < low[axis]) low[axis] = p[axis];
            if (p[axis] > high[axis]) high[axis] = p[axis];
        }
    }
    FIRMA_INLINE void add(const Box& b) {
        if (b.empty()) return;
        add(b.low);
        add(b.high);
    }
    FIRMA_INLINE friend bool operator==(const Box& a, const Box& b) { return a.low == b.low && a.high == b.high; }
};

}  // namespace firma

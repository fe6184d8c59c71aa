// SPDX-License-Identifier: MIT
// A signed integer of 256 bits, for determinants of planes: just what the exact predicates need.
#pragma once

#include <cstdint>

namespace firma {

__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

/// Two's complement, least significant word first. Results are exact when they fit 256 bits; callers count bits.
struct Int256 {
    std::uint64_t word[4] = {0, 0, 0, 0};

    Int256() = default;
    Int256(Int128 value) : Int256(Unsigned128(value >> 127), Unsigned128(value)) {}
    Int256(Unsigned128 high, Unsigned128 low)
        : word{std::uint64_t(low), std::uint64_t(low >> 64), std::uint64_t(high), std::uint64_t(high >> 64)} {}

    Unsigned128 low() const { return Unsigned128(word[1]) << 64 | word[0]; }
    Unsigned128 high() const { return Unsigned128(word[3]) << 64 | word[2]; }

    friend Int256 operator+(const Int256& a, const Int256& b);
    friend Int256 operator-(const Int256& a, const Int256& b);
    friend Int256 operator-(const Int256& a);
    friend Int256 operator*(const Int256& a, std::int64_t b);
    friend Int256 operator*(const Int256& a, Int128 b);
    friend bool operator==(const Int256& a, const Int256& b) = default;

    /// -1, 0 or 1.
    int sign() const {
        if (word[3] >> 63) return -1;
        return (word[0] | word[1] | word[2] | word[3]) != 0;
    }
    /// Nearest double, halves to even.
    double to_double() const;
};

// All of these count modulo 2^256, so only the last result of a sum has to fit.

inline Int256 operator+(const Int256& a, const Int256& b) {
    const Unsigned128 low = a.low() + b.low();
    return {a.high() + b.high() + (low < a.low()), low};
}

inline Int256 operator-(const Int256& a, const Int256& b) {
    return {a.high() - b.high() - (a.low() < b.low()), a.low() - b.low()};
}

inline Int256 operator-(const Int256& a) {
    return Int256() - a;
}

// A negative factor, read as unsigned, is 2^64 (or 2^128) too great: that many times the other one is taken off again.
inline Int256 operator*(const Int256& a, std::int64_t b) {
    const auto factor = std::uint64_t(b);
    const Unsigned128 p0 = Unsigned128(a.word[0]) * factor;
    const Unsigned128 p1 = Unsigned128(a.word[1]) * factor + (p0 >> 64);
    const Unsigned128 p2 = Unsigned128(a.word[2]) * factor;
    const std::uint64_t p3 = a.word[3] * factor;
    const Unsigned128 low = p1 << 64 | std::uint64_t(p0);
    const Unsigned128 high = p2 + (p1 >> 64) + (Unsigned128(p3) << 64);
    const auto mask = Unsigned128(Int128(b >> 63));
    const Int256 excess((a.high() << 64 | a.word[1]) & mask, Unsigned128(a.word[0]) << 64 & mask);
    return Int256(high, low) - excess;
}

/// The product of two integers of 128 bits, exactly.
inline Int256 product(Int128 a, Int128 b) {
    const auto a0 = std::uint64_t(a), a1 = std::uint64_t(a >> 64);
    const auto b0 = std::uint64_t(b), b1 = std::uint64_t(b >> 64);
    const Unsigned128 p00 = Unsigned128(a0) * b0, p01 = Unsigned128(a0) * b1;
    const Unsigned128 p10 = Unsigned128(a1) * b0, p11 = Unsigned128(a1) * b1;
    const Unsigned128 middle = (p00 >> 64) + std::uint64_t(p01) + std::uint64_t(p10);
    const Unsigned128 excess = (Unsigned128(b) & Unsigned128(a >> 127)) + (Unsigned128(a) & Unsigned128(b >> 127));
    return {p11 + (p01 >> 64) + (p10 >> 64) + (middle >> 64) - excess, middle << 64 | std::uint64_t(p00)};
}

inline Int256 operator*(const Int256& a, Int128 b) {
    // a = high * 2^128 + low, low read as signed: where its top bit is set, high counts one more.
    const Int256 low = product(Int128(a.low()), b);
    const Unsigned128 high = (a.high() + (a.low() >> 127)) * Unsigned128(b);
    return {low.high() + high, low.low()};
}

struct Quotient {
    Int256 quotient;         ///< rounded toward zero
    std::int64_t remainder;  ///< with the sign of what was divided
};
/// @param b  0 < b < 2^63
Quotient divide(const Int256& a, std::int64_t b);

/// a / b rounded to the nearest integer, halves to even.
/// @param a, b  b > 0; |a| < 2^200, b < 2^200, and the quotient fits 63 bits
std::int64_t divide_rounded(const Int256& a, const Int256& b);

}  // namespace firma

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
    Int256(Int128 value);

    friend Int256 operator+(const Int256& a, const Int256& b);
    friend Int256 operator-(const Int256& a, const Int256& b);
    friend Int256 operator-(const Int256& a);
    friend Int256 operator*(const Int256& a, std::int64_t b);
    friend Int256 operator*(const Int256& a, Int128 b);
    friend bool operator==(const Int256& a, const Int256& b) = default;

    /// -1, 0 or 1.
    int sign() const;
    /// Nearest double, halves to even.
    double to_double() const;
};

/// The product of two integers of 128 bits, exactly.
Int256 product(Int128 a, Int128 b);

/// a / b rounded to the nearest integer, halves to even.
/// @param a, b  b > 0; |a| < 2^200, b < 2^200, and the quotient fits 63 bits
std::int64_t divide_rounded(const Int256& a, const Int256& b);

}  // namespace firma

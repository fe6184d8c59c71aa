// SPDX-License-Identifier: MIT
// What a 256-bit integer is asked for seldom: its nearest double, and rounded quotients.
#include "geometry/exact_integer.h"

#include <bit>

namespace firma {
namespace {

/// Bits up to the highest one set; 0 for 0.
int bit_count(const Int256& magnitude) {
    for (int k = 3; k >= 0; --k)
        if (magnitude.word[k] != 0) return 64 * k + int(std::bit_width(magnitude.word[k]));
    return 0;
}

}  // namespace

double Int256::to_double() const {
    const bool negative = sign() < 0;
    const Int256 magnitude = negative ? -*this : *this;
    const int bits = bit_count(magnitude);
    if (bits <= 63) return negative ? -double(magnitude.word[0]) : double(magnitude.word[0]);

    // The 63 leading bits, the last of them set where anything set is left out: as they are ten more than a double
    // holds, converting them rounds as the whole number would.
    const int shift = bits - 63;
    const int whole = shift / 64, part = shift % 64;
    std::uint64_t leading = magnitude.word[whole] >> part;
    if (part != 0 && whole < 3) leading |= magnitude.word[whole + 1] << (64 - part);
    std::uint64_t left_out = part == 0 ? 0 : magnitude.word[whole] << (64 - part);
    for (int k = 0; k < whole; ++k) left_out |= magnitude.word[k];
    leading |= left_out != 0;

    const double scale = std::bit_cast<double>(std::uint64_t(1023 + shift) << 52);  // 2^shift
    const double value = double(std::int64_t(leading)) * scale;
    return negative ? -value : value;
}

Quotient divide(const Int256& a, std::int64_t b) {
    const bool negative = a.sign() < 0;
    Int256 left = negative ? -a : a;
    Unsigned128 rest = 0;
    for (int k = 3; k >= 0; --k) {
        rest = rest << 64 | left.word[k];
        left.word[k] = std::uint64_t(rest / std::uint64_t(b));
        rest %= std::uint64_t(b);
    }
    return negative ? Quotient{-left, -std::int64_t(rest)} : Quotient{left, std::int64_t(rest)};
}

// Long division, a bit at a time: only roundings within an error of a half come here.
std::int64_t divide_rounded(const Int256& a, const Int256& b) {
    const bool negative = a.sign() < 0;
    const Int256 magnitude = negative ? -a : a;
    Int256 rest;
    std::uint64_t quotient = 0;
    for (int k = bit_count(magnitude) - 1; k >= 0; --k) {
        const std::uint64_t bit = magnitude.word[k / 64] >> (k % 64) & 1;
        rest = rest + rest + Int256(Int128(bit));
        const Int256 less = rest - b;
        const bool fits = less.sign() >= 0;
        quotient = quotient << 1 | std::uint64_t(fits);
        if (fits) rest = less;
    }
    const int beyond_half = (rest + rest - b).sign();
    if (beyond_half > 0 || (beyond_half == 0 && (quotient & 1) != 0)) ++quotient;
    return negative ? -std::int64_t(quotient) : std::int64_t(quotient);
}

}  // namespace firma

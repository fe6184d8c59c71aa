// SPDX-License-Identifier: MIT
// Numbers modulo 2^61 - 1, a prime: by these, ratios of large integers are hashed.
#pragma once

#include <cstdint>

#include "geometry/exact_integer.h"

namespace firma {

inline constexpr std::uint64_t kPrime = (std::uint64_t(1) << 61) - 1;

/// 2^61 is 1 modulo the prime, so pieces of 61 bits add up: a division of 128 bits is a call of a library.
inline std::uint64_t reduced(std::uint64_t value) {
    value = (value & kPrime) + (value >> 61);
    return value >= kPrime ? value - kPrime : value;
}
inline std::uint64_t residue_of(Unsigned128 value) {
    return reduced((std::uint64_t(value) & kPrime) + (std::uint64_t(value >> 61) & kPrime) +
                   std::uint64_t(value >> 122));
}
inline std::uint64_t residue_of(Int128 value) {
    const std::uint64_t rest = residue_of(value < 0 ? -Unsigned128(value) : Unsigned128(value));
    return value < 0 && rest != 0 ? kPrime - rest : rest;
}
inline std::uint64_t residue_times(std::uint64_t a, std::uint64_t b) {
    return residue_of(Unsigned128(a) * b);
}
inline std::uint64_t residue_minus(std::uint64_t a, std::uint64_t b) {
    return a >= b ? a - b : a + kPrime - b;
}
/// a^(2^times)
inline std::uint64_t residue_squared(std::uint64_t a, int times) {
    for (; times > 0; --times) a = residue_times(a, a);
    return a;
}
/// By Fermat: a^(p - 2), where p - 2 = 4 (2^59 - 1) + 1; 0 of 0.
inline std::uint64_t residue_inverse(std::uint64_t a) {
    // ones[k]: a^(2^n - 1), n = 2^k
    std::uint64_t ones[6] = {a};
    for (int k = 1; k < 6; ++k) ones[k] = residue_times(residue_squared(ones[k - 1], 1 << (k - 1)), ones[k - 1]);
    std::uint64_t power = ones[5];  // 32 ones, of 59
    for (const int k : {4, 3, 1, 0})
        power = residue_times(residue_squared(power, 1 << k), ones[k]);  // 16, 8, 2, 1 more
    return residue_times(residue_squared(power, 2), a);
}

}  // namespace firma

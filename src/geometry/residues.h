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
/// By Fermat: a^(p - 2); 0 of 0.
inline std::uint64_t residue_inverse(std::uint64_t a) {
    std::uint64_t result = 1;
    for (std::uint64_t power = kPrime - 2; power != 0; power >>= 1) {
        if (power & 1) result = residue_times(result, a);
        a = residue_times(a, a);
    }
    return result;
}

}  // namespace firma

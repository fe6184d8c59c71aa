// SPDX-License-Identifier: MIT
// Seeded numbers that are the same on every machine, for shapes and moves that a seed decides.
// Source: S. Vigna, splitmix64 (public domain reference), 2015.
#pragma once

#include <cstdint>

namespace firma {

/// Scatters the bits of a number: the output function of splitmix64, a bijection.
inline std::uint64_t mix_bits(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
}

/// One draw a statement, please: the order in which arguments are evaluated differs between compilers.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() { return mix_bits(state_ += 0x9E3779B97F4A7C15ull); }
    /// low <= x < high, but for rounding
    double uniform(double low, double high) { return low + (high - low) * (double(next() >> 11) * 0x1p-53); }

private:
    std::uint64_t state_;
};

}  // namespace firma

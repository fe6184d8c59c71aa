// SPDX-License-Identifier: MIT
// Seeded random numbers that are the same on every machine.
// Source: S. Vigna, splitmix64 (public domain reference), 2015.
#pragma once

#include <cstdint>

#include "firma/vec.h"

namespace firma::scenes {

/// By way of memory: g++ 12 at -O3, where it makes vectors of several, goes from double to float and back by doing
/// nothing.
inline double rounded_to_float(double x) {
    volatile float rounded = float(x);
    return double(rounded);
}

class Rng {
public:
    explicit Rng(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    /// 0 <= x < 1
    double uniform() { return double(next() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// 0 <= x < count; count > 0
    std::uint32_t below(std::uint32_t count) {
        return std::uint32_t((std::uint64_t(std::uint32_t(next() >> 32)) * count) >> 32);
    }
    bool chance(double probability) { return uniform() < probability; }
    /// A unit vector, evenly over the sphere, without sine or cosine (they differ between machines).
    Vec3 direction() {
        for (;;) {
            const Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            const double square = dot(v, v);
            if (square > 1e-3 && square <= 1) return v * (1 / std::sqrt(square));
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace firma::scenes

// SPDX-License-Identifier: MIT
// Keys of hash tables that nobody outside can choose: a file whose points all shared one key would take time by the
// square of their number.
#pragma once

#include <cstdint>

#include "base/random.h"

namespace firma {

inline constexpr char kTableAnchor = 0;

/// Another number in each run where programs lie in memory at random, as they do by default on the systems that
/// Firma is built for; the same in all of them in WebAssembly. No result may depend on it.
inline std::uint64_t table_seed() {
    return std::uint64_t(reinterpret_cast<std::uintptr_t>(&kTableAnchor));
}

/// A key of three coordinates. Others may share it.
template <class Point>
std::uint64_t point_key(const Point& p) {
    const std::uint64_t xy = std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y);
    return mix_bits(mix_bits(xy ^ table_seed()) + std::uint32_t(p.z));
}

/// The key to look at when another object has this one.
inline std::uint64_t next_key(std::uint64_t key) {
    return mix_bits(key + 1);
}

}  // namespace firma

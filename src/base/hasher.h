// SPDX-License-Identifier: MIT
// A hash of 64 bits over words given one by one: the same on every machine.
#pragma once

#include <cstdint>

#include "base/random.h"

namespace firma {

class Hasher {
public:
    void add(std::uint64_t word) { state_ = mix_bits(state_ * 0x9E3779B97F4A7C15ull + word); }
    std::uint64_t value() const { return mix_bits(state_); }

private:
    std::uint64_t state_ = 0x6669726D61ull;
};

}  // namespace firma

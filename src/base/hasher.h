// SPDX-License-Identifier: MIT
// A 64-bit hash of a stream of words, the same on every machine: for telling whether two machines hold the same world,
// not against anyone who wants them to collide.
// Source: the mixing step is S. Vigna's splitmix64 (public domain reference), 2015, after D. Stafford's variant 13.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

namespace firma {

class Hasher {
public:
    template <std::integral Number>
    void add(Number number) {
        add_word(static_cast<std::uint64_t>(number));
    }
    /// Two counts or coordinates in one word; what does not fit 32 bits belongs in a word of its own.
    template <std::integral A, std::integral B>
    void add(A high, B low) {
        add_word(std::uint64_t(static_cast<std::uint32_t>(high)) << 32 | static_cast<std::uint32_t>(low));
    }
    /// By its bits: -0 is not 0.
    void add(double number) { add_word(std::bit_cast<std::uint64_t>(number)); }
    void add(float a, float b) { add(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b)); }

    std::uint64_t value() const {
        std::uint64_t sum = mixed(count_);
        for (const std::uint64_t chain : chain_) sum = mixed(sum + chain);
        return sum;
    }

private:
    /// Four chains in turn, so that a multiplication need not wait for the one before. The one at hand is always the
    /// first, which lets all of them stay in registers.
    void add_word(std::uint64_t word) {
        const std::uint64_t next = mixed_lightly(chain_[0], word);
        chain_[0] = chain_[1];
        chain_[1] = chain_[2];
        chain_[2] = chain_[3];
        chain_[3] = next;
        ++count_;
    }

    static std::uint64_t mixed_lightly(std::uint64_t chain, std::uint64_t word) {
        const std::uint64_t z = (std::rotl(chain, 29) ^ word) * 0x9E3779B97F4A7C15ull;
        return z ^ (z >> 32);
    }

    static std::uint64_t mixed(std::uint64_t z) {
        z += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }

    std::uint64_t chain_[4] = {0x243F6A8885A308D3ull, 0x13198A2E03707344ull, 0xA4093822299F31D0ull,
                               0x082EFA98EC4E6C89ull};  // of pi
    std::uint64_t count_ = 0;
};

}  // namespace firma

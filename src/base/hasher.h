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

    std::uint64_t value() const { return mixed(lanes_[0] + mixed(lanes_[1] + mixed(count_))); }

private:
    void add_word(std::uint64_t word) {
        // Two chains, so that one multiplication need not wait for the one before.
        std::uint64_t& lane = lanes_[count_++ & 1];
        lane = (std::rotl(lane, 29) ^ word) * 0x9E3779B97F4A7C15ull;
        lane ^= lane >> 32;
    }

    static std::uint64_t mixed(std::uint64_t z) {
        z += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }

    std::uint64_t lanes_[2] = {0x243F6A8885A308D3ull, 0x13198A2E03707344ull};  // of pi
    std::uint64_t count_ = 0;
};

}  // namespace firma

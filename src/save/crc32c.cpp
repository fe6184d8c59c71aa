// SPDX-License-Identifier: MIT
// Eight bytes at a time, by tables.
// Source: M. Kounavis, F. Berry, A Systematic Approach to Building High Performance Software-Based CRC Generators, 2005
// ("slicing by 8").
#include "save/crc32c.h"

#include <array>

#include "save/little_endian.h"

namespace firma {
namespace {

constexpr std::uint32_t kPolynomial = 0x82F63B78;  // reflected

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

Tables make_tables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t rest = byte;
        for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? kPolynomial : 0);
        tables[0][byte] = rest;
    }
    for (std::size_t k = 1; k < 8; ++k)
        for (std::size_t byte = 0; byte < 256; ++byte)
            tables[k][byte] = tables[k - 1][byte] >> 8 ^ tables[0][tables[k - 1][byte] & 255];
    return tables;
}

/// Made when first asked for: in a file they would be 8 KB that nothing packs.
const Tables& made_tables() {
    static const Tables tables = make_tables();
    return tables;
}

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before) {
    const Tables& tables = made_tables();
    std::uint32_t sum = ~before;
    const std::byte* at = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 8; left -= 8, at += 8) {
        const std::uint64_t word = read_u64(at) ^ sum;
        sum = 0;
        for (std::size_t k = 0; k < 8; ++k) sum ^= tables[7 - k][word >> 8 * k & 255];
    }
    for (; left > 0; --left, ++at) sum = sum >> 8 ^ tables[0][(sum ^ std::uint32_t(*at)) & 255];
    return ~sum;
}

}  // namespace firma

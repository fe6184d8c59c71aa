// SPDX-License-Identifier: MIT
// Numbers of the surface grid as exact decimals.
#pragma once

#include <cstdint>
#include <string>

namespace firma {

/// Metres of a count of surface steps (1/262144 m), with all its digits and none to spare: at most 18 behind the point.
inline std::string exact_decimal(std::int32_t steps) {
    const std::uint64_t size = steps < 0 ? std::uint64_t(-std::int64_t(steps)) : std::uint64_t(steps);
    std::string text = steps < 0 ? "-" : "";
    text += std::to_string(size >> 18);
    std::uint64_t rest = size & ((1u << 18) - 1);
    if (rest == 0) return text;
    text += '.';
    while (rest != 0) {  // a fraction of 2^18 ends after 18 digits
        rest *= 10;
        text += char('0' + (rest >> 18));
        rest &= (1u << 18) - 1;
    }
    return text;
}

}  // namespace firma

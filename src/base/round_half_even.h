// SPDX-License-Identifier: MIT
// The nearest whole number, the same on every machine.
#pragma once

#include <cmath>

namespace firma {

/// Halves to even. Beyond 2^52 every double is whole already and floor keeps it.
inline double round_half_even(double value) {
    const double below = std::floor(value);
    const double rest = value - below;  // exact: below 2^53 both are multiples of the same unit, and close
    const bool below_is_odd = std::floor(below * 0.5) != below * 0.5;
    return rest > 0.5 || (rest == 0.5 && below_is_odd) ? below + 1 : below;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// What numbers of a caller may be.
#pragma once

#include "firma/vec.h"

namespace firma::c {

inline bool is_above_zero(double number) {
    return is_finite(number) && number > 0;
}

inline bool is_not_below_zero(double number) {
    return is_finite(number) && number >= 0;
}

inline bool is_rotation(const double (&turned)[4]) {
    for (const double part : turned)
        if (!is_finite(part)) return false;
    return turned[0] != 0 || turned[1] != 0 || turned[2] != 0 || turned[3] != 0;
}

}  // namespace firma::c

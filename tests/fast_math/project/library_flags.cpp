// SPDX-License-Identifier: MIT
// Compiled as the library's files are, in a project that asks for -ffast-math.
#include <cmath>
#include <cstdio>

#include "geometry/double_double.h"

int main() {
    volatile double zero = 0, one = 1, small = 0x1p-60;
    const firma::DoubleDouble sum = firma::two_sum(one, small);
    const bool exact = sum.high == 1 && sum.low == small;  // what reassociation makes zero
    const bool told = std::isnan(zero / zero) && !std::isfinite(one / zero) && std::signbit(-zero);
    std::printf("sums exact: %d, NaN, infinity and -0 told: %d\n", exact, told);
    return exact && told ? 0 : 1;
}

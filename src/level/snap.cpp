// SPDX-License-Identifier: MIT
// The one snap: from metres to the input grid.
#include <cmath>

#include "firma/grid.h"

namespace firma {
namespace {

/// Nearest whole number, halves to even. Beyond 2^52 every double is whole already and floor keeps it.
double round_half_even(double value) {
    const double below = std::floor(value);
    const double rest = value - below;  // exact: below 2^53 both are multiples of the same unit, and close
    const bool below_is_odd = std::floor(below * 0.5) != below * 0.5;
    return rest > 0.5 || (rest == 0.5 && below_is_odd) ? below + 1 : below;
}

}  // namespace

std::optional<GridPoint> snap(const Vec3& point) {
    constexpr double kRim = kWorldRim * kInputSteps;
    GridPoint snapped;
    for (int axis = 0; axis < 3; ++axis) {
        // A power of two scales without rounding; what overflows here becomes infinite and is refused, as is NaN.
        const double steps = round_half_even(point[axis] * kInputSteps);
        if (!(steps >= -kRim && steps < kRim)) return std::nullopt;
        snapped[axis] = std::int32_t(steps) * kSurfacePerInput;
    }
    return snapped;
}

}  // namespace firma

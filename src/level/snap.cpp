// SPDX-License-Identifier: MIT
// The one snap: from metres to the input grid.
#include "base/round_half_even.h"
#include "firma/grid.h"

namespace firma {
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

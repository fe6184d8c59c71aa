// SPDX-License-Identifier: MIT
// Boxes of bodies in whole steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/grid_box.h"
#include "geometry/rounding.h"

namespace firma {

/// A metre in steps of these boxes. Bodies may be twice as far out as the rim of the world, as projectiles may.
inline constexpr double kTargetSteps = kSurfaceSteps / 2;

/// Around a ball, outward; cut off where no projectile flies.
inline GridBox target_box(const Vec3& centre, double reach) {
    const auto step = [](double at) { return std::int32_t(std::clamp(at, double(INT32_MIN), double(INT32_MAX))); };
    const double far = reach * (1 + rounding(64));
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = step(std::floor((centre[axis] - far) * kTargetSteps) - 1);
        box.high[axis] = step(std::ceil((centre[axis] + far) * kTargetSteps) + 1);
    }
    return box;
}

}  // namespace firma

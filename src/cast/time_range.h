// SPDX-License-Identifier: MIT
// When a plane is crossed, in double, with what rounding leaves open.
#pragma once

#include <cmath>

#include "cast/hull_against_polygon.h"
#include "geometry/rounding.h"

namespace firma {

/// Between which times something happens.
struct TimeRange {
    double low, high;
};

/// A time of more error than this share of all sizes, in metres along the path, is computed once more.
inline constexpr double kTimeError = 0x1p-46;

/// How far away something is at the end of a path.
inline Estimate at_end(const Estimate& now, const Estimate& change, double end) {
    const double gain = end * change.value;
    return {now.value + gain, now.error + end * change.error + rounding(4) * (std::fabs(now.value) + std::fabs(gain))};
}

/// When a facet's plane is crossed that is `now` away, for a change that is surely not 0.
inline TimeRange crossing(const Estimate& now, const Estimate& change) {
    const double distance = std::fabs(now.value), speed = std::fabs(change.value);
    const double t = distance / speed;
    const double error = (now.error + t * change.error) / (speed - change.error) + rounding(8) * t;
    return {t - error, t + error};
}

}  // namespace firma

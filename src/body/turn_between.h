// SPDX-License-Identifier: MIT
// The turn from one rotation to another, as axis times angle.
#pragma once

#include <cmath>

#include "firma/turn.h"

namespace firma {

/// Radians, 0 to pi, of an angle with this sine and cosine (of the sum of squares 1), the sine not negative.
inline double angle_of(double sine, double cosine) {
    // A rough angle, then Newton's step on the sine of what is left, which is exact to its third power.
    constexpr double kHalfTurn = 3.141592653589793;
    const double small = sine < std::fabs(cosine) ? sine : std::fabs(cosine);
    const double rough = small * (1 + small * small * (0.1667 + small * small * 0.12));
    double angle = sine < std::fabs(cosine) ? rough : kHalfTurn / 2 - rough;
    if (cosine < 0) angle = kHalfTurn - angle;
    for (int step = 0; step < 3; ++step) {
        const SineCosine at = sine_cosine(angle);
        angle += sine * at.cosine - cosine * at.sine;
    }
    return angle;
}

/// The shorter of the two ways, in the world's axes: turn_by() of it, after `from`, is `to` but for rounding.
inline Vec3 turn_between(const Quaternion& from, const Quaternion& to) {
    Quaternion step = normalised(compose(to, turn_back(from)));
    if (step[3] < 0) step = {-step[0], -step[1], -step[2], -step[3]};
    const Vec3 axis{step[0], step[1], step[2]};
    const double sine = length(axis);
    return sine > 0 ? axis * (2 * angle_of(sine, step[3]) / sine) : Vec3{};
}

}  // namespace firma

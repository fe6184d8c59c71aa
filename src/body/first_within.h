// SPDX-License-Identifier: MIT
// When a point on a straight way comes within a ball.
#pragma once

#include <cmath>

#include "firma/vec.h"

namespace firma {

/// The least t in [0, 1] at which |w + t d| is at most r and falls; beyond 1 if there is none.
inline double first_within(const Vec3& w, const Vec3& d, double r) {
    const double c = dot(w, w) - r * r, b = dot(w, d), a = dot(d, d);
    if (!(b < 0)) return 2;
    if (c <= 0) return 0;
    const double root = b * b - a * c;
    return root < 0 ? 2 : c / (-b + std::sqrt(root));
}

}  // namespace firma

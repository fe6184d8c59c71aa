// SPDX-License-Identifier: MIT
// Tells in plain double, with a margin for its own rounding, that a sweep stays clear of a polygon; when in doubt it
// says no.
//
// Two convex sets lie farther apart than r when along some direction w the gap between their shadows exceeds r |w|.
// That holds whatever w is, so w may be guessed carelessly; only the shadows are computed with care.
#pragma once

#include <span>
#include <vector>

#include "firma/vec.h"

namespace firma::reference {

/// A polygon in double: its corners (exact), and some guesses.
struct Hull {
    std::vector<Vec3> corners;
    Box box;
    Vec3 normal, middle;

    explicit Hull(std::span<const Vec3> points);
};

/// True only if no point of start + t path, 0 <= t <= end, lies within radius of the polygon.
bool surely_apart(const Hull& hull, const Vec3& start, const Vec3& path, double end, double radius);

}  // namespace firma::reference

// SPDX-License-Identifier: MIT
// How a body turns that nothing pushes: its angular momentum stays, and its axes move under it.
#pragma once

#include "firma/turn.h"

namespace firma {

/// Where a body's frame is turned to, and how fast it turns.
struct Spinning {
    Quaternion rotation;
    Vec3 spin;  ///< radians a second, in the world's axes
};

/// One step of a symplectic splitting: turns about one principal axis at a time, each exact, in an order that reads
/// the same backwards. So angular momentum stays to rounding, and energy within a bound that does not grow.
/// @param inertia  about the body's own axes
/// Source: A. Dullweber, B. Leimkuhler, R. McLachlan, Symplectic splitting methods for rigid body molecular dynamics,
/// 1997.
Spinning spin_freely(const Spinning& from, const Vec3& inertia, double seconds);

}  // namespace firma

// SPDX-License-Identifier: MIT
// What a predicate that answers zero would answer if part of the geometry were shifted a little: by e along x, e^2
// along y, e^3 along z, for an e smaller than anything. A whole cutter is shifted so, which settles each zero in one
// way. Source: H. Edelsbrunner, E. Muecke, Simulation of Simplicity, 1990.
#pragma once

#include "geometry/exact_plane.h"

namespace firma {

/// The side of a plane to which a point on it goes when it is shifted: 1 or -1. (A plane that is shifted leaves a point
/// on it on the other side.)
inline int shifted_side(const Plane& plane) {
    for (const std::int64_t n : plane.normal)
        if (n != 0) return n > 0 ? 1 : -1;
    return 0;
}

struct ShiftedPlane {
    const Plane* plane;
    bool shifts;
};

/// The side of plane `a` on which the meet of p, q, r lies once those that shift have done so; for one that lies on it.
///
/// @param p, q, r  exact_turn(p, q, r) != 0
/// @return 0 when all four stay together even so
int shifted_side(const ShiftedPlane& a, const ShiftedPlane& p, const ShiftedPlane& q, const ShiftedPlane& r);

}  // namespace firma

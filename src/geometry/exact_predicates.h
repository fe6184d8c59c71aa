// SPDX-License-Identifier: MIT
// Signs that must never be wrong: double arithmetic where its error bound settles them, exact sums of products where
// not. Source: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997.
//
// Numbers come from a Sweep: none beyond kLargestNumber, none but zero below kSmallestNumber; so no product here
// overflows or underflows. Corners lie on the surface grid.
#pragma once

#include "firma/vec.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// Sign of direction . normal.
int exact_facing(const Vec3& direction, const PolygonShape& polygon);

/// Sign of (point - plane) . normal: 1 in front, 0 on the plane.
int exact_plane_side(const Vec3& point, const PolygonShape& polygon);

/// The same for point + offset, the sum taken exactly.
int exact_plane_side(const Vec3& point, const Vec3& offset, const PolygonShape& polygon);

/// Sign of direction . ((a - start) x (b - start)): on which side the line through start leaves the directed edge a b.
/// Always exact: call it when double leaves the sign open.
int exact_edge_side(const Vec3& start, const Vec3& direction, const Vec3& a, const Vec3& b);

}  // namespace firma

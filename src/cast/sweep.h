// SPDX-License-Identifier: MIT
// A cast made ready: the path scaled to a direction, and what every face needs to know of it, computed once.
#pragma once

#include "firma/hit.h"
#include "firma/polygon.h"
#include "firma/vec.h"

namespace firma {

/// The centre moves as start + t * direction, t in [0, end]; fraction = t / end. `end` is a power of two, so nothing is
/// rounded by the change of scale.
struct Sweep {
    Vec3 start;
    Vec3 direction;  ///< the path over `end`: its largest coordinate is in [1, 2)
    double end = 0;  ///< a power of two
    double radius = 0;

    double direction_square = 0;
    double direction_length = 0;

    /// Projection along the path onto two axes: a point w from the start goes to (w[u] - shear_u * w[k], w[v] - shear_v
    /// * w[k]).
    int axis_u = 0, axis_v = 0, axis_k = 0;
    double shear_u = 0, shear_v = 0;

    Vec3 at(double t) const { return start + direction * t; }
    double fraction(double t) const { return t / end; }
};

/// @return kInvalid when a number is not finite or beyond kLargestNumber, or the radius is negative; kMiss for a zero
/// path (below kShortestPath); kHit
///         when the sweep was made.
Status make_sweep(const Sphere& sphere, const Vec3& path, Sweep& sweep);

}  // namespace firma

// SPDX-License-Identifier: MIT
// A capsule made ready for casts: its two ends as spheres, and the ball around it that boxes and portals are culled by.
#pragma once

#include "cast/shape_extent.h"
#include "cast/sweep.h"
#include "cast/vector_of.h"
#include "firma/capsule.h"
#include "geometry/exact_triple.h"

namespace firma {

/// The ends and the radius, parts too small to matter taken as zero as in make_sweep().
struct CapsuleShape {
    Vec3 from, to;
    double radius = 0;
    bool is_sphere() const { return from == to; }
};

CapsuleShape shape_of_capsule(const Capsule& capsule);

/// A ball around the middle that holds the capsule; the sphere itself when both ends are one. Its radius is negative
/// for numbers that cannot be cast.
Sphere ball_around(const Capsule& capsule);

/// Around the middle of ball_around().
ShapeExtent extent_of(const CapsuleShape& capsule);

/// A capsule on its way. Letters of the files that use it: A and B the ends at the start, s = B - A, d the path; v a
/// corner, e a side of the polygon.
struct CapsuleSweep {
    Sweep a, b;  ///< of the two ends, with the capsule's radius
    Vec3 s;      ///< B - A, rounded once

    /// @param around  of the ball around it
    CapsuleSweep(const Sweep& around, const CapsuleShape& capsule)
        : a(around), b(around), s(capsule.to - capsule.from) {
        a.start = capsule.from;
        b.start = capsule.to;
        a.radius = b.radius = capsule.radius;
    }

    double radius() const { return a.radius; }
    const Vec3& direction() const { return a.direction; }
    double end() const { return a.end; }
    SumVec<2> exact_s() const { return difference_as_sum(b.start, a.start); }
    VectorOf<DoubleDouble> precise_s() const { return difference<DoubleDouble>(b.start, a.start); }
};

}  // namespace firma

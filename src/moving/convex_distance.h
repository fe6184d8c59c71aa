// SPDX-License-Identifier: MIT
// How far two convex sets of corners are from each other.
#pragma once

#include <span>

#include "firma/vec.h"

namespace firma {

/// Slop, metres: a search for nearest points ends when it is known to be within this.
inline constexpr double kNearSlop = 1e-12;

struct ConvexDistance {
    bool apart = false;   ///< false: they share a point, but for 1e-9 m
    double distance = 0;  ///< of two points of them: they are not farther apart
    double at_least = 0;  ///< nor nearer than this, but for rounding: along `normal` no nearer
    Vec3 normal;          ///< unit, from b toward a
    Vec3 point;           ///< of a, one of the nearest
};

/// @param a, b  corners, metres, 1 to 64 of each
/// @return distance - at_least within kNearSlop, unless rounding of far or thin shapes hinders; at_least holds always
/// Never allocates.
/// Source: E. Gilbert, D. Johnson, S. Keerthi, A Fast Procedure for Computing the Distance between Complex Objects in
/// Three-Dimensional Space, 1988; the nearest point of a simplex as in C. Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.
ConvexDistance convex_distance(std::span<const Vec3> a, std::span<const Vec3> b);

}  // namespace firma

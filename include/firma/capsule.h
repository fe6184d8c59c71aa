// SPDX-License-Identifier: MIT
// Capsules that move, cast against one polygon. queries.h casts them through a world; docs/casting.md has their
// contract.
#pragma once

#include <span>

#include "firma/export.h"
#include "firma/polygon.h"

namespace firma {

/// All points within a radius of a segment. Its two ends are these very doubles, so it may lie any way. With both ends
/// at one place it is a sphere, and casts of it answer as those of the sphere, bit for bit.
struct Capsule {
    Vec3 from{};        ///< end of the segment at the start of the path, metres
    Vec3 to{};          ///< the other end
    double radius = 0;  ///< metres, >= 0; 0 is a segment

    Capsule() = default;
    FIRMA_INLINE Capsule(const Vec3& one, const Vec3& other, double r) : from(one), to(other), radius(r) {}
};

/// A capsule around its middle. Its ends are middle - axis * half and middle + axis * half, coordinate by coordinate,
/// the product and the sum rounded.
/// @param half  metres, from the middle to an end of the segment; the radius comes on top
/// @param axis  unit
[[nodiscard]] FIRMA_EXPORT Capsule make_capsule(const Vec3& middle, const Vec3& axis, double half, double radius);

/// Moves a capsule along a straight segment, without turning it, and finds its first touch with a polygon.
///
/// @param path, corners, sides  as cast_polygon() of a sphere
/// @return as for a sphere, with the distance of the segment from the polygon for that of the centre. Where the segment
///         itself meets the polygon at the start: kInitialOverlap if the path leads against all of the nearest ways
///         out, or against the polygon's plane if that is among them; kMiss otherwise. PolygonHit::centre is the middle
///         of the segment, `point` the nearest point of the polygon, the middle of them if there are several, `normal`
///         from there toward the segment. kInvalid also for ends beyond 2^199.
/// Never allocates, never throws. Costs about two spheres and what the corners and sides near the path take.
[[nodiscard]] FIRMA_EXPORT PolygonHit cast_polygon(const Capsule& capsule, const Vec3& path,
                                                   std::span<const Vec3> corners, Sides sides = Sides::kFront);

/// Whether a closed capsule and a closed polygon share a point, from either side. No tolerance: decided in double, and
/// once more in double-double where that leaves it open; exactly where its segment itself meets the polygon. False for
/// what cast_polygon() finds invalid. Never allocates, never throws.
[[nodiscard]] FIRMA_EXPORT bool overlap(const Capsule& capsule, std::span<const Vec3> corners);

}  // namespace firma

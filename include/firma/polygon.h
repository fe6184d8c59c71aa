// SPDX-License-Identifier: MIT
// One mover, one polygon: the pair functions, for people with geometry of their own.
//
// A polygon is its corners in order, counter-clockwise seen from its front [3 <= count], convex (corners may lie along
// a side), exactly planar, each coordinate a multiple of 1/262144 m within the world's range. check_polygon() tells
// whether it is. What these functions cost grows with the polygon's corners; clip_segment_box() costs the same for
// every box. None but check_polygon() allocates.
#pragma once

#include <cstdint>
#include <span>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/result.h"
#include "firma/vec.h"

namespace firma {

/// A ball. Radius 0 is a particle.
struct Sphere {
    Vec3 centre{};
    double radius = 0;  ///< metres, >= 0
};

/// A straight way of a particle.
struct Ray {
    Vec3 start{};  ///< metres
    Vec3 path{};   ///< motion, metres: its length says how far
};

/// Why corners do not make a polygon that can be cast against.
enum class PolygonFault : std::uint8_t {
    kNone,
    kTooFewCorners,  ///< fewer than three
    kOffGrid,        ///< a coordinate is not a multiple of 1/262144 m, not finite, or outside the world
    kNoArea,         ///< all corners on one line
    kNotPlanar,      ///< a corner off the plane, however little
    kNotConvex,      ///< a reflex corner, or an outline that winds more than once
};

/// Judges corners exactly. Allocates once, for a copy of the corners on the grid.
[[nodiscard]] FIRMA_EXPORT PolygonFault check_polygon(std::span<const Vec3> corners);

/// Moves a sphere along a straight segment and finds its first touch with a polygon.
///
/// @param sphere   centre at fraction 0 and radius (metres); radius 0 casts a particle, whose "inside" is decided
///                 exactly
/// @param path     motion (metres); a zero path (below 2^-1000 m) is kMiss: use overlap()
/// @param corners  the polygon, as the head of this file says; others give answers without meaning, never a crash
/// @param sides    kFront: only when path . normal < 0 (exact sign), wherever the centre is
/// @return kHit with fraction in (0, 1]; kInitialOverlap at fraction 0 when the distance at the start is at most the
///         radius and decreasing; kMiss otherwise, also when the sphere starts in touch and moves along or away.
///         An exact graze is a hit. A miss has fraction 1 and the end of the path as its centre. kInvalid, with
///         fraction 0 and the start as its centre, for a number that is not finite or beyond 2^200, a negative radius,
///         or corners that are fewer than three, outside the world or without area.
/// Never allocates, never throws.
/// Source: J. Slagel's system as described in Game Developer Magazine, "Collision Detection Using Ray Casting"; the
/// formulas are re-derived (docs/casting.md says which were wrong in print).
[[nodiscard]] FIRMA_EXPORT PolygonHit cast_polygon(const Sphere& sphere, const Vec3& path,
                                                   std::span<const Vec3> corners, Sides sides = Sides::kFront);

/// The point of a polygon nearest to a point.
struct ClosestPoint {
    Vec3 point;                        ///< metres
    double distance = 0;               ///< metres, >= 0
    Feature feature = Feature::kFace;  ///< where `point` lies
    std::uint32_t feature_index = 0;   ///< as in PolygonHit
};

/// The point of a polygon nearest to a point.
/// @param point    metres, finite
/// @param corners  the polygon; at an infinite distance when there are fewer than three, or one lies outside the world
/// Never allocates, never throws.
[[nodiscard]] FIRMA_EXPORT ClosestPoint closest_point(const Vec3& point, std::span<const Vec3> corners);

/// Whether a closed ball and a closed polygon share a point, from either side. No tolerance; false for what is not a
/// number, a negative radius, and corners that cast_polygon() finds invalid. Never allocates, never throws.
[[nodiscard]] FIRMA_EXPORT bool overlap(const Sphere& sphere, std::span<const Vec3> corners);

/// Whether a segment meets a box: by outcodes at first, clipping only where they leave it open (Cohen and Sutherland).
/// To move a sphere against a box, grow the box by the radius; the answer is then conservative at its corners.
///
/// @param start, path  metres, finite
/// @param box          closed; an empty box is never met
/// @return whether some point start + f * path with f in [0, 1] may lie in the box: never false when one does (the box
///         is grown by the rounding of this very computation, at most 2^-48 of the largest number involved)
/// Never allocates, never throws.
[[nodiscard]] FIRMA_EXPORT bool clip_segment_box(const Vec3& start, const Vec3& path, const Box& box);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Convex hulls and boxes that move: made, and cast against one polygon. queries.h casts them through a world;
// docs/casting.md has their contract.
//
// A hull is made once, for the way it is turned, and put anywhere: its corners are then exactly at + corner, the sum
// not rounded. So it is the same hull everywhere, and whether it meets a polygon is decided exactly for these corners.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "firma/export.h"
#include "firma/polygon.h"
#include "firma/result.h"

namespace firma {

struct HullShape;

/// A hull of more corners is refused.
inline constexpr std::size_t kMaxHullCorners = 64;

/// The convex hull of a few points, immutable: copies share it. The default one holds nothing, and casts of it are
/// kInvalid. Copies and questions never allocate.
class Hull {
public:
    Hull() = default;
    FIRMA_EXPORT explicit Hull(std::shared_ptr<const HullShape> shape);

    bool valid() const { return shape_ != nullptr; }
    /// Those of the points that the hull needs, in no particular order, metres; a view as long-lived as the hull and
    /// its copies.
    FIRMA_EXPORT std::span<const Vec3> corners() const;

    /// Inner workings; null when not valid().
    const HullShape* shape() const { return shape_.get(); }

private:
    std::shared_ptr<const HullShape> shape_;
};

/// A hull of points, already turned.
/// @param points  from where the hull is put, metres [4 <= count <= kMaxHullCorners]; coordinates below 2^-250 count as
///                zero
/// @return kTooLarge for too many points; kOutOfRange, with the point, for a number that is not finite or beyond 2^199;
///         kInvalid for points in one plane, and for a hull that the place it is put at lies outside of
/// Costs some microseconds for a box, some hundred for 64 points; allocates.
[[nodiscard]] FIRMA_EXPORT Result<Hull> make_hull(std::span<const Vec3> points);

/// A box around its middle. Its corners are axes[0] * (+-half.x) + axes[1] * (+-half.y) + axes[2] * (+-half.z),
/// coordinate by coordinate from left to right, each product and each sum rounded; the box is the hull of these
/// corners.
/// @param half  metres, > 0
/// @param axes  unit, perpendicular to each other; others make another parallelepiped
/// @return errors as make_hull()
[[nodiscard]] FIRMA_EXPORT Result<Hull> make_box(const Vec3& half, const std::array<Vec3, 3>& axes = {
                                                                       Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}});

/// Moves a hull along a straight segment and finds its first touch with a polygon. Exact: it is met when, in real
/// arithmetic, it is; only the fraction is rounded.
///
/// @param hull, at  at is where it is put at fraction 0, metres
/// @param path, corners, sides  as cast_polygon() of a sphere
/// @return kHit with fraction in (0, 1]; kInitialOverlap at fraction 0 when both share a point at the start and the
///         overlap gets deeper; kMiss otherwise, also when the hull starts in touch or overlap and moves along or away;
///         kInvalid as for a sphere, and for a hull that is not valid(). PolygonHit::centre is where the hull is put at
///         the fraction, `point` the middle of what touches there, `normal` the way the hull was pushed off: of the
///         polygon's face, of the hull's face, or across an edge of both.
/// Never allocates, never throws. Costs the product of the edges of both at most.
[[nodiscard]] FIRMA_EXPORT PolygonHit cast_polygon(const Hull& hull, const Vec3& at, const Vec3& path,
                                                   std::span<const Vec3> corners, Sides sides = Sides::kFront);

/// Whether a hull that is put at `at` and a closed polygon share a point, from either side: exactly. False for what
/// cast_polygon() finds invalid. Never allocates, never throws.
[[nodiscard]] FIRMA_EXPORT bool overlap(const Hull& hull, const Vec3& at, std::span<const Vec3> corners);

/// Up to four points.
struct ContactPoints {
    std::array<Vec3, 4> at;
    std::size_t count = 0;
    std::span<const Vec3> points() const { return std::span(at).first(count); }
};

/// Where a hull touches the polygon that it met: the corners of what a face, an edge or a corner of the hull and the
/// polygon have in common there, seen along the normal; of more than four the four that span the most area. The same
/// for the same hit, in order around the normal.
///
/// @param hit      of this hull with this polygon; through a world: `world.face(hit.face)->corners`
/// @param corners  the polygon
/// @return points on the polygon, metres; of a start in overlap those of both that lie farthest in, where they are one
///         above the other, else hit.point. None for a miss, a hull that is not valid(), or corners without area.
/// Never allocates, never throws. Costs the product of the edges that touch, microseconds for boxes.
[[nodiscard]] FIRMA_EXPORT ContactPoints contact_points(const Hull& hull, const PolygonHit& hit,
                                                        std::span<const Vec3> corners);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Points that solids are made of: on the input grid, or where three planes meet; and the signs that geometry asks of
// them. A floating filter with a proven bound answers nearly always; integers of up to 256 bits answer when it cannot.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "firma/vec.h"
#include "geometry/exact_plane.h"
#include "geometry/rounding.h"

namespace firma {

/// Where three planes meet: x / w and so on, in input steps; w > 0. |x|, |y|, |z| < 2^184, w < 2^159.
struct Meet {
    Int256 x, y, z, w;
};

/// @param a, b, c  exact_turn(a, b, c) != 0
Meet meet(const Plane& a, const Plane& b, const Plane& c);

/// Whether three planes meet in one point, and that lies within the world: what ExactPoint relies on. For planes from
/// outside.
bool meet_in_world(const Plane& a, const Plane& b, const Plane& c);

/// A point as an integer or as three planes. A view: whoever makes it keeps the planes. Immutable once made.
class ExactPoint {
public:
    ExactPoint() = default;
    explicit ExactPoint(const InputPoint& point);
    /// @param a, b, c  exact_turn(a, b, c) != 0, and the point within the world (FIRMA_ASSERT)
    ExactPoint(const Plane& a, const Plane& b, const Plane& c);

    bool on_grid() const { return planes_[0] == nullptr; }
    /// Only for one on_grid().
    InputPoint grid() const { return to_input(rounded_); }
    /// Null for one on_grid().
    const Plane* plane(int k) const { return planes_[k]; }

    /// Input steps, each coordinate off by at most kApproximation.
    const Vec3& approximate() const { return approximate_; }
    /// The nearest point of the surface grid, halves to even, exactly so. The world's far rim, 2^31, is no surface
    /// coordinate: what rounds to it is given as the last one before it.
    const GridPoint& rounded() const { return rounded_; }

private:
    const Plane* planes_[3] = {nullptr, nullptr, nullptr};
    Vec3 approximate_;
    GridPoint rounded_;
};

/// Bound on how far a coordinate of approximate() is off, in input steps: a few roundings of numbers up to 2^25.
inline constexpr double kApproximation = 0x1p-26;

/// Bound on how far normal . p + offset is off in double, as a share of the plane's size: n is exact, p is off by
/// kApproximation a coordinate; the terms add up to at most size * 2^25 each for normal . p and for the offset, and
/// none passes through more than four roundings (the first: one product, three sums). A fifth covers that p may lie
/// beyond the rim by its error, and the rounding of the bound itself.
inline constexpr double kSideError = kApproximation + rounding(5) * 0x1p+26;

/// exact_side() by integers alone.
int exact_side_by_integers(const Plane& plane, const ExactPoint& point);

/// The side of a plane that a point lies on: 1 in front, 0 on it, -1 behind.
inline int exact_side(const Plane& plane, const ExactPoint& point) {
    const Vec3& p = point.approximate();
    const double estimate = dot(plane.direction(), p) + plane.d;
    const double error = kSideError * plane.size;
    if (estimate > error) return 1;
    if (estimate < -error) return -1;
    return exact_side_by_integers(plane, point);
}

/// Whether a point lies on a plane, where it mostly does: first a look at the point's own planes.
bool lies_on(const Plane& plane, const ExactPoint& point);

/// Order along the line in which planes f and t meet, directed as f.normal x t.normal: the sign of (b - a) . direction.
///
/// @param a  a point of the line, and `across` a plane through it that is not parallel to the line
/// @param b  a point of the line
int exact_order(const Plane& f, const Plane& t, const ExactPoint& a, const Plane& across, const ExactPoint& b);

/// How often exact_side() and exact_order() took the exact path since the program started, for benchmarks; per thread.
std::uint64_t exact_fallbacks();

}  // namespace firma

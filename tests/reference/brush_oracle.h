// SPDX-License-Identifier: MIT
// The volume of brushes joined, by rationals and nothing of the library's: each brush is cut into convex parts outside
// those before it.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/brush_level.h"
#include "geometry/exact_plane.h"

namespace firma::reference {

using Rational = boost::multiprecision::cpp_rational;
using Whole = boost::multiprecision::cpp_int;
/// 332 bits.
using LongReal =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// normal . p + offset > 0 is outside, p in input steps. As doubles, too.
struct HalfSpace {
    std::array<Whole, 3> normal;
    Whole offset;
    double n[3], d;

    Rational at(const std::array<Rational, 3>& p) const;
};
HalfSpace half_space(const Plane& plane);
HalfSpace half_space(const BrushSide& side);

/// The half spaces whose common part a brush is.
using BrushBody = std::vector<HalfSpace>;

/// How far the corners of a body's faces lie from the planes that they once were in, at most; input steps, rounded.
/// @param once  by side of the body
double farthest_moved(const BrushBody& body, const BrushBody& once);

/// Cubic input steps of all brushes together, what lies in several counted once. All that decides is exact; volumes of
/// parts are summed with 332 bits.
LongReal joined_volume(std::span<const BrushBody> brushes);

/// Whether a point (input steps) lies inside some brush: 1; on the surface of one and inside none: 0; else -1.
int side_of_brushes(std::span<const BrushBody> brushes, const Rational (&point)[3]);

}  // namespace firma::reference

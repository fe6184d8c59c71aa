// SPDX-License-Identifier: MIT
// The volume of brushes joined, exactly, by rationals and nothing of the library's: each brush is cut into convex parts
// outside those before it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <vector>

#include "firma/brush_level.h"

namespace firma::reference {

using Rational = boost::multiprecision::cpp_rational;

/// @return cubic input steps of all brushes of kSolid and kSky together, what lies in several counted once
Rational joined_volume(const BrushLevel& level);

/// Whether a point (input steps) lies inside some such brush: 1; on the surface of one and inside none: 0; else -1.
int side_of_brushes(const BrushLevel& level, const Rational (&point)[3]);

}  // namespace firma::reference

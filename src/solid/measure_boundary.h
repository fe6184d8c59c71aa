// SPDX-License-Identifier: MIT
// Volume and area of a solid, to some hundred bits.
#pragma once

#include "geometry/double_double.h"
#include "geometry/exact_integer.h"
#include "solid/boundary.h"

namespace firma {

struct BoundaryMeasures {
    DoubleDouble volume;  ///< of the exact faces, cubic input steps: positive for solid in air
    DoubleDouble area;    ///< of the exact faces, square input steps
    Int128 facet_sixths;  ///< six times the volume that the facets bound, in cubic surface steps: exact
};

/// The nearest double-double but for a few of its last bits.
DoubleDouble to_double_double(const Int256& value);

/// A point of the input grid in the middle of a box.
InputPoint middle_of(const GridBox& box);

/// Sums are taken about a point in the middle, so that the volume of a small solid far out keeps its digits too.
BoundaryMeasures measure_boundary(const Boundary& boundary);

}  // namespace firma

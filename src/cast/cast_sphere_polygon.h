// SPDX-License-Identifier: MIT
// A sphere against a polygon: the earliest of face, edges and vertices.
#pragma once

#include "cast/contact.h"
#include "cast/sweep.h"
#include "firma/hit.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// The first touch of a sweep of any radius, 0 included, with a polygon.
///
/// @param latest  in the sweep's parameter: a touch after it need not be found (one at it will be)
/// @param counts  may be null; `precise` is added to
Contact cast_sweep_polygon(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                           CastCounts* counts = nullptr);

}  // namespace firma

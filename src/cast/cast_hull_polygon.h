// SPDX-License-Identifier: MIT
// A moving hull against a polygon: whether they meet is decided exactly, only the fraction is rounded.
#pragma once

#include "cast/contact.h"
#include "cast/hull_against_polygon.h"

namespace firma {

/// A touch, and which facet of the Minkowski sum it is with.
struct HullContact {
    Contact contact;
    SumFacet facet;
};

/// The first touch of a hull with a polygon that has area.
///
/// @param sweep   of the place the hull is put at; its radius does not count
/// @param latest  in the sweep's parameter: a touch after it need not be found
/// @param counts  may be null; `precise` is added to
HullContact cast_hull_polygon(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon, Sides sides,
                              double latest, CastCounts* counts = nullptr);

/// Whether the hull shares a point with the polygon where it starts, exactly.
bool hull_meets(const HullAgainstPolygon& pair);

/// The facet that the shortest way out of an overlap leads through, to rounding; of several as near the first.
SumFacet nearest_facet(const HullAgainstPolygon& pair);

}  // namespace firma

// SPDX-License-Identifier: MIT
// A first look at a hull that moves against a polygon: most pass beside it, or come down on it with a corner, or on one
// of its sides with an edge, and a few directions tell that without all facets of their sum.
//
// Beside: along any direction u, the hull is apart from the polygon while its lowest corner is above the polygon's
// highest. u may be rounded as it likes: it is that very u that separates. Each u leaves an interval of times in which
// both may meet; where no time is in all of them they do not.
//
// On it: the hull meets the polygon's plane first with its lowest corner, and where that corner is surely within all
// sides then, that is where it meets the polygon. Another corner may be as low, to rounding: then the time is off by no
// more than it is anyway; where that is much, no other may be. Likewise with an edge g that alone supports the hull
// along e x g, as the side e alone does the polygon, where both surely cross. How such an edge was found does not
// matter.
#pragma once

#include <cstdint>

#include "cast/hull_against_polygon.h"

namespace firma {

struct HullGlance {
    /// kBlurred: on it, at a time of which double loses too many digits.
    enum Kind : std::uint8_t { kBeside, kOnIt, kBlurred, kOpen };
    Kind kind = kOpen;
    double t = 0;       ///< of kOnIt: when, within [0, sweep.end]
    SumFacet::Name by;  ///< of kOnIt and kBlurred: the facet that is met, as cast_hull_polygon() finds it
};

/// @param facing  sign of direction . normal
/// @param latest  nothing after it is wanted
/// Costs the product of the hull's corners and the polygon's sides, and less than one for each side that is met.
HullGlance glance(const HullAgainstPolygon& pair, int facing, double latest);

}  // namespace firma

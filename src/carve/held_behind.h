// SPDX-License-Identifier: MIT
// A quick proof that a shell is not loose: a line from just behind one of its faces, straight into the solid.
#pragma once

#include "geometry/grid_box.h"
#include "solid/anchors.h"
#include "solid/block.h"

namespace firma {

/// Whether a facet is surely of a shell that is held or looks inward: by a line through it along an axis, which behind
/// it leaves the solid nowhere, or only through faces that hold. If the facet's shell looked outward, the line would
/// begin within it and leave it somewhere; so one of these faces would be its own.
///
/// @param root    of the index over the solid before a cut
/// @param facet   of a face that the cut left alone
/// @param cutter  around the cutter; a line that comes near it says nothing
/// @return false where this line does not tell
/// Never allocates. Costs a walk through the index along the line.
bool is_held_behind(const Node& root, const FacetPlace& facet, const GridBox& cutter, const Anchors& anchors);

}  // namespace firma

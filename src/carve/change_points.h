// SPDX-License-Identifier: MIT
// What a cut does to the hash of the solid's points.
#pragma once

#include "carve/cut_view.h"
#include "solid/region.h"

namespace firma {

/// Sums of PointHash, over the faces that come and, taken away, those that go. Edges that a face keeps are left out, so
/// this costs what the cut made and took.
SumsByKey change_of_points(const CutView& view, const NewLoops& loops);

}  // namespace firma

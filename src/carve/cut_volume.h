// SPDX-License-Identifier: MIT
// How much a cut took.
#pragma once

#include "carve/cut_view.h"

namespace firma {

/// Cubic metres that the solid has less, by the faces that go and come: by integers and sums of 100 bits about the
/// cutter's middle, rounded to double once or twice, wherever in the world it is.
double volume_taken(const CutView& view, const NewLoops& loops);

}  // namespace firma

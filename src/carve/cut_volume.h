// SPDX-License-Identifier: MIT
// What a cut took: how much, and of which faces.
#pragma once

#include "carve/cut_state.h"

namespace firma {

/// Cubic metres that the solid has less, by the faces that go and come: by integers and sums of 100 bits about the
/// cutter's middle, rounded to double once or twice, wherever in the world it is.
double volume_taken(const Cut& cut);

/// Whether a face that goes was cut or taken, not only divided.
bool takes_something_of(const Cut& cut, std::uint32_t face);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Boxes between the grid and floats.
#pragma once

#include "geometry/grid_box.h"
#include "index/bin.h"

namespace firma {

/// Rounded outward.
BoxF to_floats(const GridBox& box);

/// Exactly, for a box that to_floats() made: such floats are whole numbers of steps. (8192 m, which rounding up may
/// reach, counts as the last step; to_floats() makes it 8192 m again.)
GridBox to_grid(const BoxF& box);

}  // namespace firma

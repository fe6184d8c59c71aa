// SPDX-License-Identifier: MIT
// Boxes between the grid and floats.
#pragma once

#include "geometry/grid_box.h"
#include "index/box_f.h"

namespace firma {

/// Rounded outward.
BoxF to_floats(const GridBox& box);
/// Rounded inward: a flat box may have its low side above the high one then.
BoxF to_floats_within(const GridBox& box);

/// Exactly, for a box that to_floats() made or that a WideNode has: such floats are whole numbers of steps. (8192 m and
/// more, which rounding up may reach, counts as the last step.)
GridBox to_grid(const BoxF& box);

}  // namespace firma

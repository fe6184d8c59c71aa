// SPDX-License-Identifier: MIT
// Whether a polygon reaches into a box, or a bevelled one: in double, as no cut follows its shape.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/vec.h"
#include "geometry/bevelled_box.h"
#include "geometry/grid_box.h"

namespace firma {

/// Whether a loop and what it encloses reach into a box, by clipping it on each side in turn. Corners that lie along a
/// side make no difference, as they come and go with the neighbours' edges: whether a face is halved must not depend on
/// what was cut elsewhere before.
///
/// @param loop  input steps; used up
/// @param box   surface steps
bool polygon_reaches_into(std::vector<Vec3>& loop, const GridBox& box);

/// Likewise into a bevelled box, grown for `steps`; into its own box it must reach besides.
bool polygon_reaches_into(std::vector<Vec3>& loop, const BevelledBox& box, std::int32_t steps);

}  // namespace firma

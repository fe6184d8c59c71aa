// SPDX-License-Identifier: MIT
// The points that a divided patch comes to.
#pragma once

#include <vector>

#include "level/patch.h"

namespace firma {

/// Points row by row, columns() by rows() of them. Those on the rim of a span come from the rim's own three control
/// points alone, the same from either end: with the same chords they are the same for every patch that has this rim.
std::vector<Vec3> tessellate_patch(const Patch& patch, const PatchDivision& division);

}  // namespace firma

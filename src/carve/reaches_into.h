// SPDX-License-Identifier: MIT
// Whether a cutter reaches into a zone.
#pragma once

#include "carve/cutter_solid.h"
#include "firma/vec.h"

namespace firma {

/// By a triangle, or by holding its middle. False for a region that is empty, no numbers, or outside the world.
bool reaches_into(const CutterSolid& cutter, const Box& region);

}  // namespace firma

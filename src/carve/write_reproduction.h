// SPDX-License-Identifier: MIT
// What it takes to see a failed cut again.
#pragma once

#include <string>

#include "carve/cutter_solid.h"
#include "solid/solid_patch.h"

namespace firma {

/// An .obj in two groups, `solid` (the outer loops of the faces looked at, and their holes as faces of their own) and
/// `cutter`, with vertices rounded to the surface grid, as exact decimals.
std::string write_reproduction(const SolidPatch& patch, const CutterSolid& cutter);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Puts a cutter that is a Solid into the world: exactly, where a quarter turn and whole steps do it; else its facets.
#pragma once

#include <optional>

#include "carve/cutter_solid.h"

namespace firma {

/// @param cutter  made of a Solid
/// @param placed  replaced
/// @return errors of judge_pose(), one of outside_world(); kInvalid for a pose that is no grid_turn() and at which
///         snapped facets bound no solid, with the place
std::optional<Error> place_solid(const Cutter& cutter, const Pose& pose, CutterSolid& placed);

/// The facets of a solid at any pose, snapped to the input grid: triangles without area are left out, their neighbours
/// take over their corners.
/// @param mended  not null: where that crosses or touches itself it is mended, see mend_mesh(), and this says how many
///                triangles that took
/// @return as place_solid()
Result<Solid> snap_solid(const Cutter& cutter, const Pose& pose, int* mended = nullptr);

/// Any cutter: a mesh or a solid.
std::optional<Error> place_any_cutter(const Cutter& cutter, const Pose& pose, CutterSolid& placed);

}  // namespace firma

// SPDX-License-Identifier: MIT
// What a player overlaps that it may not.
#pragma once

#include <string>

#include "firma/players.h"

namespace firma::reference {

/// Deeper than rounding (1e-9 m): parts, and solid faces from in front. Sheets do not count: what moves along one
/// passes its rim, and what came upon one from behind is in it for a while.
/// @return "" where there is nothing
std::string player_overlap(const Scene& scene, const PlayerShape& shape, const Vec3& feet, bool crouched);

/// Whether `way` leads into the front of a sheet that it overlaps, and so may be held by an edge of it.
bool is_held_by_sheet(const Scene& scene, const PlayerShape& shape, const Vec3& feet, bool crouched, const Vec3& way);

}  // namespace firma::reference

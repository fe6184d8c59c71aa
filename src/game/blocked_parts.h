// SPDX-License-Identifier: MIT
// Parts that wait or go back where something is in their way.
#pragma once

#include <span>

#include "firma/game.h"

namespace firma {

/// Tries the coming tick on copies of players and bodies. Where one would be crushed, the drives of parts that are to
/// wait or to go back then are set so.
/// @param motions  of the coming tick, of all parts; those of parts that were set anew are put here
/// Costs a look at what is near the parts that move; where anything is, a move of each player and a step of all bodies.
void hold_blocked_parts(GameState& game, std::span<RigidMotion> motions);

}  // namespace firma

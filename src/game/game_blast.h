// SPDX-License-Identifier: MIT
// An explosion in a game: on the world, its parts, bodies and players.
#pragma once

#include "firma/game.h"

namespace firma {

/// @param charge  sound: judge_charge()
void explode_charge(GameState& game, const Vec3& at, const Charge& charge, GameReport& report);

}  // namespace firma

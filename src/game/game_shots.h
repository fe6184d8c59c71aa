// SPDX-License-Identifier: MIT
// Projectiles of a game in one tick: past its parts, through its world, until they stop or their fuses end.
#pragma once

#include <vector>

#include "firma/game.h"

namespace firma {

/// Where something with a charge went off.
struct Bang {
    double time = 0;  ///< seconds from the start of the tick
    std::uint32_t weapon = 0;
    Vec3 at;
};

/// Why a weapon's projectiles cannot fly in a tick, or nothing.
std::optional<Error> fault_of_weapon(const Weapon& weapon);
std::optional<Error> fault_of_shots(const GameShots& shots);

/// All of them fly for a tick; those that stop or expire go, unless they lie and wait.
/// @return by time, then weapon, then index
std::vector<Bang> fly_shots(GameState& game, double seconds, GameReport& report);

}  // namespace firma

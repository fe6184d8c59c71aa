// SPDX-License-Identifier: MIT
// A player as spheres in the world: what a blast sees of it, and what debris keeps clear of.
#pragma once

#include "firma/game.h"

namespace firma {

/// As it stands now. Of a capsule and a box in a row along its middle axis.
SphereSet spheres_of_player(const GamePlayer& player);

/// Half way up.
Vec3 middle_of_player(const GamePlayer& player);

}  // namespace firma

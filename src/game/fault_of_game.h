// SPDX-License-Identifier: MIT
// Whether a game is one that can be stepped on: what is asked before it is packed, and of one unpacked.
#pragma once

#include <optional>

#include "firma/game.h"

namespace firma {

/// The first thing that is wrong, with its place ("body 3"), or nothing. Costs all of its parts but the worlds.
std::optional<Error> fault_of_game(const GameState& game);

}  // namespace firma

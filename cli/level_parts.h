// SPDX-License-Identifier: MIT
// Parts of a level that move, put into a game: those of entities that have brushes, and of nodes of glTF.
#pragma once

#include "cli/load_level.h"
#include "firma/game.h"

namespace firma::cli {

/// Each with a name of its own: that of its node, or part_0, part_1, ... by its number.
/// @param arguments  the matters of the parts' worlds
/// @throws Failure with the node, for one that makes no world, and for a motion among its extras that is none
void add_level_parts(const LevelArguments& arguments, const LoadedLevel& loaded, GameState& game);

}  // namespace firma::cli

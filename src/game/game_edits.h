// SPDX-License-Identifier: MIT
// Edits of a game's world, which go into its log.
#pragma once

#include "firma/game.h"

namespace firma {

/// Counts an edit that was made, and puts it into the log where it did something.
void keep_edit(GameState& game, EditCommand command, CarveStatus status, const Error& error, GameReport& report);

/// Gives a command the log's next numbers, does it, and makes debris of what came loose.
void do_edit(GameState& game, EditCommand command, GameReport& report);

/// The command with numbers from the log's next one on.
EditCommand numbered(const GameState& game, EditCommand command);

}  // namespace firma

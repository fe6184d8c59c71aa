// SPDX-License-Identifier: MIT
// Scripts of games, as people write them: what a game is set up with, and what happens when.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/game.h"

namespace firma::cli {

struct GameScript {
    std::vector<GameEvent> events;  ///< by tick; before the end
    std::size_t after_end = 0;      ///< events that lie after it
};

/// Reads a script. What it sets up (seed, rules, weapons, parts) is put into the game at once.
/// @param ticks  how long the game goes on from now
/// @throws Failure with the file and, of what is no JSON, line and column; else the event ("event 3: blast: radius")
GameScript read_game_script(const std::string& path, GameState& game, std::uint64_t ticks);

/// What a script is, for people.
extern const char* const kScriptHelp;

}  // namespace firma::cli

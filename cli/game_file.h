// SPDX-License-Identifier: MIT
// Saved games as files, and what the verbs tell of a game.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "cli/atomic_file.h"
#include "cli/json.h"
#include "firma/game.h"

namespace firma::cli {

/// The game of a .firma file; nothing where it holds a world alone, or is no such file.
/// @throws Failure with the reader's place and reason
std::optional<GameState> read_saved_game(const std::string& path);

void write_bytes(std::span<const std::byte> bytes, AtomicFile& file);

/// {tick, seconds, explosions, edits, players, parts, projectiles, bodies, asleep, debris}
Json game_json(const GameState& game);
/// The same in a line, for people.
std::string game_text(const GameState& game);

}  // namespace firma::cli

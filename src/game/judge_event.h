// SPDX-License-Identifier: MIT
// What can be done to a game, and with which numbers.
#pragma once

#include <cstddef>
#include <optional>

#include "firma/game.h"

namespace firma {

/// How many there are of what events name.
struct GameCounts {
    std::size_t weapons = 0, players = 0, parts = 0;
};

/// Why an event cannot be done, or nothing.
std::optional<Error> judge_event(const GameEvent& event, const GameCounts& counts);

std::optional<Error> judge_charge(const Charge& charge);
std::optional<Error> judge_player(const GamePlayer& player, std::size_t parts);
std::optional<Error> judge_rules(const GameRules& rules);
std::optional<Error> judge_body(const Body& body);

}  // namespace firma

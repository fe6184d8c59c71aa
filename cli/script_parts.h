// SPDX-License-Identifier: MIT
// What a script sets a game up with: weapons, parts that move, rules; and charges.
#pragma once

#include <string>

#include "cli/json_fields.h"
#include "firma/game.h"

namespace firma::cli {

/// Seed, rules, weapons, parts.
void set_up_game(JsonFields& script, const std::string& place, GameState& game);

/// The keys of a charge among those of an object.
Charge charge_of(JsonFields& fields, const Charge& otherwise);

/// How a part goes: the keys `stops`, `repeats`, `axis`, `spin_degrees`, `swing`, `waits`, `when_blocked` of an object.
/// @param stands  where its frame is without them: stops are told from there
PartDrive drive_of(JsonFields& fields, const Pose& stands);

/// @return its index; throws a Failure of the key for one that is not there
std::uint32_t weapon_of(JsonFields& fields, std::string_view key, const GameState& game);

}  // namespace firma::cli

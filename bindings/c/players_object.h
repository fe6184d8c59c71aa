// SPDX-License-Identifier: MIT
// Shapes of players behind a handle, and players as a caller has them.
#pragma once

#include <utility>

#include "bindings/c/calls.h"
#include "bindings/c/handles.h"
#include "firma/players.h"

namespace firma::c {

struct PlayerShapeObject final : Object {
    static constexpr Kind kKind = Kind::kPlayerShape;
    static constexpr const char* kNoun = "player shape";
    explicit PlayerShapeObject(PlayerShape of) : shape(std::move(of)) {}
    const PlayerShape shape;
};

/// Whether what is 0 or 1 of a player is so.
firma_code judge_player_flags(const firma_player& given, const char* function);
Player player_of(const firma_player& from);
void put_player(const Player& from, firma_player& out);
firma_player_move move_of(const PlayerMove& from);
firma_code read_wish(const firma_player_wish* given, PlayerWish& wish, const char* function);
firma_player_wish wish_told(const PlayerWish& from);
/// Null gives the defaults.
firma_code read_player_rules(const firma_player_rules* given, PlayerRules& rules, const char* function);
firma_player_rules player_rules_told(const PlayerRules& from);

}  // namespace firma::c

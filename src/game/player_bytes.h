// SPDX-License-Identifier: MIT
// Players as bytes, and back.
#pragma once

#include "firma/game.h"
#include "log/byte_reader.h"

namespace firma {

/// @param player  its shape valid()
void put_player(ByteWriter& out, const GamePlayer& player);
/// Judged by judge_player().
GamePlayer take_player(ByteReader& in);

void put_wish(ByteWriter& out, const PlayerWish& wish);
PlayerWish take_wish(ByteReader& in);

}  // namespace firma

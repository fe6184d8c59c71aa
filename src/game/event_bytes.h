// SPDX-License-Identifier: MIT
// Events of games as bytes, and back.
#pragma once

#include <vector>

#include "firma/game.h"
#include "log/byte_reader.h"

namespace firma {

/// @param events  judged by judge_events()
void put_events(ByteWriter& out, const std::vector<GameEvent>& events);
std::vector<GameEvent> take_events(ByteReader& in);

}  // namespace firma

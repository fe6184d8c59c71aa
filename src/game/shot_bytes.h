// SPDX-License-Identifier: MIT
// Weapons, charges and projectiles as bytes, and back.
#pragma once

#include "firma/game.h"
#include "log/byte_reader.h"

namespace firma {

void put_charge(ByteWriter& out, const Charge& charge);
/// Judged by judge_charge().
Charge take_charge(ByteReader& in);

void put_shots(ByteWriter& out, const GameShots& shots);
/// Judged by fault_of_shots().
GameShots take_shots(ByteReader& in);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Parts that move, and debris, as bytes, and back: their solids as .firma files.
#pragma once

#include "firma/game.h"
#include "log/byte_reader.h"

namespace firma {

void put_part(ByteWriter& out, const MovingPart& part, const PartDrive& drive);
void take_part(ByteReader& in, MovingPart& part, PartDrive& drive);

void put_debris(ByteWriter& out, const Debris& debris);
Debris take_debris(ByteReader& in);

}  // namespace firma

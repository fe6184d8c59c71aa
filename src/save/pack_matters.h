// SPDX-License-Identifier: MIT
// What a world is made of, as sections of a .firma file.
#pragma once

#include <vector>

#include "save/container.h"
#include "solid/matter_pieces.h"

namespace firma {

/// In the order in which they are written.
std::vector<NewSection> pack_matters(const MatterPieces& matters);

}  // namespace firma

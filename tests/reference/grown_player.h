// SPDX-License-Identifier: MIT
// A player's shape with a margin all around.
#pragma once

#include "firma/players.h"

namespace firma::reference {

/// A box stays one: its corners are farther out than the margin.
/// @param margin metres; below zero what comes back is smaller. The feet of what comes back are lower by it.
PlayerShape grown_player(const PlayerShape& shape, double margin);

}  // namespace firma::reference

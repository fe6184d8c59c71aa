// SPDX-License-Identifier: MIT
// Parts of a game by its ticks: where they go, and which portals they close.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/game.h"

namespace firma {

/// Seconds on the path of a drive when so many ticks are behind.
double drive_seconds(const GameState& game, const PartDrive& drive, std::uint64_t tick);

/// How a part goes from this tick to the next.
RigidMotion drive_motion(const GameState& game, const PartDrive& drive);

/// A portal, and whether it is to be open in this tick.
struct PortalWish {
    PortalId portal;
    bool open = false;
};

/// Of all portals that a drive names, ascending, each once. Open where one of those that name it is away from its
/// first stop at this tick or the next.
std::vector<PortalWish> portal_wishes(const GameState& game);

}  // namespace firma

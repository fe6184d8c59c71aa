// SPDX-License-Identifier: MIT
// Narrows of the sampled air become portals, and the exact model says which of them are any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brush/air_grid.h"
#include "brush/find_narrows.h"
#include "firma/brush_world.h"
#include "join/join_brushes.h"

namespace firma {

struct PortalChoice {
    std::vector<std::uint32_t> narrows;  ///< that became portals; each divides two rooms
    std::size_t idle = 0;                ///< how many others were tried: the air goes around them
    std::vector<JoinRound> rounds;       ///< of joining: the level once, then what portals touch
};

/// Chooses narrows, leaves out those that divide nothing in the exact model, and looks whether others may take their
/// places. The level is joined once, with the portals of the first choice; after that only what a portal touches that
/// is added or removed.
///
/// @return of all choices that which divides the level by the most portals; kTooLarge for a level that cannot be joined
Result<PortalChoice> choose_portals(const BrushLevel& level, const AirGrid& grid, std::span<const Narrow> narrows,
                                    const DivideOptions& options);

/// Adds a narrow's portal to a level, as its last brush: a thin box with the portal as its first side.
void add_portal(BrushLevel& level, const AirGrid& grid, const Narrow& narrow);

}  // namespace firma

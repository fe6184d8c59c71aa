// SPDX-License-Identifier: MIT
// Are rooms and portals sound?
#pragma once

#include <optional>
#include <span>

#include "firma/world.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma {

/// The first thing that does not hold of rooms and portals, in a world whose blocks are sound; see check_world().
std::optional<WorldFault> check_rooms(const World& world);

/// Of rooms and portals what needs no face of the solid: their records, lists, polygons.
std::optional<WorldFault> check_cells(const WorldData& data);

/// Whether rooms that are closed by faces and portals stay so where some of these are exchanged: around each room, the
/// edges of what comes are those of what goes. Costs what is exchanged, sorted; all portals where cells are not shared.
/// @param before, after  with records of rooms; each room of before is now part of the same one as it was then
/// @param removed, added facets of the solid: of before, of after
std::optional<WorldFault> check_rooms_exchange(const WorldData& before, const WorldData& after, bool cells_shared,
                                               std::span<const FacetPlace> removed, std::span<const FacetPlace> added);

}  // namespace firma

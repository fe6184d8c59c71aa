// SPDX-License-Identifier: MIT
// Is a world sound that was made of a sound one by an exchange of faces? As check_world(), of what was exchanged.
#pragma once

#include <optional>
#include <span>

#include "firma/world.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma {

/// What does not hold of a face in a block by itself, null where all does. Its corners must be there.
/// @param solid  whether it is kept as one of a solid
const char* fault_of_face(const Block& block, const FaceRecord& record, bool solid);

/// Whether check_exchange() can tell: rooms keep their numbers, and those that are one stay one.
bool rooms_stay(const WorldData& before, const WorldData& after);

/// What check_world() would find in `after`, where it finds nothing in `before`. Blocks, indices and sums are taken to
/// be those that edits make. Costs the faces exchanged; of the others a comparison of ids at most.
/// @param after  with the faces of before, but for those removed and added; rooms_stay()
/// @param cells_shared     its cells are those of before
/// @param removed, added   facets of both kinds: of before, of after; the latter with different ids
std::optional<WorldFault> check_exchange(const WorldData& before, const WorldData& after, bool cells_shared,
                                         std::span<const FacetPlace> removed, std::span<const FacetPlace> added);

}  // namespace firma

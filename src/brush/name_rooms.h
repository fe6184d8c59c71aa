// SPDX-License-Identifier: MIT
// Gives rooms the names that their author wrote down: point entities `firma_room` in them.
#pragma once

#include <vector>

#include "firma/brush_world.h"
#include "firma/world.h"

namespace firma {

/// Names each room after the first entity of the class `firma_room` whose `origin` lies in its air: by its `name`. What
/// lies in the solid, on a face, or has no place or no name, names nothing.
/// @param notes  gets those that name nothing, and why; may be null
World name_rooms(const World& world, const BrushLevel& level, std::vector<EntityNote>* notes = nullptr);

}  // namespace firma

// SPDX-License-Identifier: MIT
// What of a level is outside: where nothing that began inside may be.
#pragma once

#include <vector>

#include "firma/world.h"

namespace firma::reference {

/// Of each room: whether ways through portals, open or closed, lead from it to the exterior.
std::vector<bool> rooms_outside(const World& world);

/// Whether a room that was not outside is, after an edit.
bool opens_way_out(const World& before, const World& after);

}  // namespace firma::reference

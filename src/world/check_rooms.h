// SPDX-License-Identifier: MIT
// Are rooms and portals sound?
#pragma once

#include <optional>

#include "firma/world.h"

namespace firma {

/// The first thing that does not hold of rooms and portals, in a world whose blocks are sound; see check_world().
std::optional<WorldFault> check_rooms(const World& world);

}  // namespace firma

// SPDX-License-Identifier: MIT
// A world without its rooms: the same faces in one tree, as of a level that has no portals.
#pragma once

#include "firma/world.h"

namespace firma::scenes {

/// Faces keep their ids, so casts against all faces answer alike in both. Costs all faces.
World in_one_tree(const World& world);

}  // namespace firma::scenes

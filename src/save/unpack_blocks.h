// SPDX-License-Identifier: MIT
// The rooms of a saved world: trees of blocks, bins and faces.
#pragma once

#include <span>
#include <vector>

#include "save/entries.h"
#include "solid/solid_face.h"
#include "world/world_data.h"

namespace firma {

/// @param exact  the exact faces that facets name; nothing else may hold them yet: their facets are counted here
/// @param has_exact  whether the file has that part at all
/// @return the rooms; check the Damage before using them. Every index in their blocks is good and every tree is one, no
///         deeper than walks can go; what faces and boxes are like is for check_world() to find out
std::vector<Ref<const Room>> unpack_rooms(Sections& sections, std::size_t rooms, bool has_exact,
                                          std::span<const Ref<SolidFace>> exact, Damage& damage);

}  // namespace firma

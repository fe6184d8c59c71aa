// SPDX-License-Identifier: MIT
// A world with one of its parts replaced; the rest stays as it is, and what follows from the faces is worked out anew.
// Rules: with_rules() of firma/world.h. Doors: set_portal_open() of firma/rooms.h.
#pragma once

#include "solid/face_store.h"
#include "world/world_data.h"

namespace firma {

/// One version on. Costs all faces.
/// @param solid  its parts are rooms of the world; ids of faces differ from those of what is castable only
World with_solid(const World& world, const Solid& solid);

/// One version on. Costs all faces.
/// @param castable  faces that bound no solid; its parts are rooms of the world; ids differ from those of the solid
World with_castable(const World& world, const FaceStore& castable);

/// One version on. Costs all faces.
/// @param cells  with all the rooms that faces are parts of
World with_cells(const World& world, const Cells& cells);

}  // namespace firma

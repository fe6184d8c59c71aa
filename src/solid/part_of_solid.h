// SPDX-License-Identifier: MIT
// Some of a solid's faces, with their exact forms, as a solid of their own; in place, or moved by whole steps.
#pragma once

#include <cstdint>
#include <span>

#include "firma/solid.h"
#include "solid/face_set.h"
#include "solid/solid_data.h"
#include "solid/solid_face.h"

namespace firma {

/// Puts facets of blocks at the end of a set, their owners among them; ids stay.
/// @param facets  all of each face
void append_facets(std::span<const FacetPlace> facets, FaceSet& set);

/// Moves faces and their exact forms by whole steps, each plane, vertex and edge once: what faces share they share
/// again. All must stay within the world.
void move_faces(const InputPoint& by, FaceSet& set);

/// A solid bounded by faces that close: of one part.
/// @param set        ids set, below `next_face`; owners among them
/// @param like       for the number of edits, and how its index is built
Solid solid_of_faces(FaceSet set, std::uint32_t next_face, const SolidData& like);

}  // namespace firma

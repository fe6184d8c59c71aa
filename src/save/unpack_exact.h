// SPDX-License-Identifier: MIT
// The exact part of a saved world: planes, vertices, edges and faces as objects that share each other again.
#pragma once

#include <vector>

#include "save/entries.h"
#include "solid/solid_face.h"

namespace firma {

/// Objects that come before those of the sections, by number: as ExactPacker::import() numbers them.
struct ExactImports {
    std::vector<Ref<const SolidPlane>> planes;
    std::vector<Ref<const SolidVertex>> vertices;
    std::vector<Ref<const SolidEdge>> edges;
    std::vector<bool> against;  ///< of each edge: whether its use runs from its second vertex to its first

    void add(const SolidFace& face);
};

/// @param imports  none for a whole world
/// @return the faces in the file's order, `facets` still 0; check the Damage before using them. Each is sound by
/// itself:
///         its numbers fit what exact arithmetic relies on, vertices lie in the world and on the planes of their edges,
///         loops have three edges and more. Whether they close, and on which plane, is for check_solid() to find out.
std::vector<Ref<SolidFace>> unpack_exact(Sections& sections, Damage& damage, ExactImports imports = {});

}  // namespace firma

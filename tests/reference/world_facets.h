// SPDX-License-Identifier: MIT
// Every facet of a world, out of its blocks, for tests that look at all of them.
#pragma once

#include <vector>

#include "firma/world.h"
#include "solid/face_set.h"
#include "solid/solid_patch.h"

namespace firma::reference {

/// In order of id.
std::vector<FacetPlace> all_facets(const World& world);
/// Those of one room, as its index has them.
std::vector<FacetPlace> facets_of_room(const World& world, std::uint32_t room);

/// What two versions of a world do not share, by id.
struct FacetChange {
    std::vector<FacetPlace> gone, come;
    bool untouched_kept = true;  ///< what both have is the same in both, corners and all else
};
FacetChange compare_facets(const World& before, const World& after);

/// The facets as they are, in a set; owners stay alive through the world.
FaceSet set_of(const World& world);

/// The world of one room, with these faces instead.
World with_faces(const World& world, const FaceSet& faces);

/// The same world, blocks and indices built from scratch.
World rebuilt(const World& world);

/// FNV-1a over all facets in order of id: corners, sources, materials, flags.
std::uint64_t hash_of_facets(const World& world);
/// Likewise, without ids and sources, whatever the order: equal for worlds whose surfaces are equal.
std::uint64_t hash_of_surface(const World& world);

}  // namespace firma::reference

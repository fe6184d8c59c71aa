// SPDX-License-Identifier: MIT
// The faces that a cut may touch, taken out of the tree.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/room_trees.h"
#include "geometry/bevelled_box.h"
#include "solid/solid_patch.h"
#include "tree/block.h"

namespace firma {

/// The facets of solids whose boxes meet a box, in the tree's order.
void gather_facets(const Block& root, const GridBox& box, std::vector<FacetPlace>& facets);

/// Those of them that may reach into a bevelled box as well (see BevelledBox::clear_of()).
/// @param others  of the rest, and of what lies around the box, facets of exact faces that may have several
void gather_facets(const Block& root, const GridBox& box, const BevelledBox& bevelled, std::int32_t steps,
                   std::vector<FacetPlace>& near, std::vector<FacetPlace>& others);

/// All facets of one exact face, and the rooms that they are of.
/// @param face  one of its facets
/// @param touch(room)  called for each facet
template <class Touch>
void gather_face(const WorldData& data, const FacetPlace& face, std::vector<FacetPlace>& facets, const Touch& touch) {
    const FaceOwner* owner = face.block->owner_of(face.record());
    if (!owner && !data.room_records) {
        facets.push_back(face);
        return touch(0);
    }
    const GridBox box = owner ? owner->box : face.block->box_of(face.record());
    std::vector<FacetPlace> near;
    for (const RoomTree& tree : trees_near(data, box)) {
        near.clear();
        gather_facets(*tree.root, box, near);
        for (const FacetPlace& place : near) {
            if (owner ? place.block->owner_of(place.record()) != owner : place != face) continue;
            facets.push_back(place);
            touch(tree.room);
        }
    }
}

/// A box grown by so many surface steps on each side, within what int32 holds.
GridBox grown(const GridBox& box, std::int32_t steps);

}  // namespace firma

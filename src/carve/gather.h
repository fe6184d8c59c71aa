// SPDX-License-Identifier: MIT
// The faces of a solid that a cut may touch, found by its index. What comes out is in order of id, so that nothing that
// follows depends on the index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bevelled_box.h"
#include "solid/block.h"

namespace firma {

/// The facets whose boxes meet a box.
/// @param root    null for no faces
/// @param facets  added to
/// @param lacked  not 0: only those whose masks lack some of these bits. Blocks of which none does cost next to nothing
void gather_facets(const Node* root, const GridBox& box, std::vector<FacetPlace>& facets, std::uint32_t lacked = 0);

/// Those of them that may reach into a bevelled box as well (see BevelledBox::clear_of()).
/// @param most_faces  of which there may be facets among them
/// @param others      of the rest, and of what lies around the box, facets of exact faces that may have several; in no
///                    order that means anything
/// @return false when there are facets of more faces: then some are left out
bool gather_facets(const Node* root, const GridBox& box, const BevelledBox& bevelled, std::int32_t steps,
                   std::size_t most_faces, std::vector<FacetPlace>& near, std::vector<FacetPlace>& others);

/// How many faces facets are of.
std::size_t count_faces(std::span<const FacetPlace> facets);

/// All facets.
std::vector<FacetPlace> all_facets(const Node* root);

/// All facets of one exact face.
/// @param face    one of its facets
/// @param facets  added to
void gather_face(const Node* root, const FacetPlace& face, std::vector<FacetPlace>& facets);

/// A box grown by so many surface steps on each side, within what int32 holds.
GridBox grown(const GridBox& box, std::int32_t steps);

}  // namespace firma

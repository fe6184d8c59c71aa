// SPDX-License-Identifier: MIT
// The faces that a cut may touch, taken out of the tree.
#pragma once

#include <vector>

#include "solid/solid_patch.h"
#include "tree/block.h"

namespace firma {

/// The facets of solids whose boxes meet a box, in the tree's order.
void gather_facets(const Block& root, const GridBox& box, std::vector<FacetPlace>& facets);

/// All facets of one exact face.
/// @param face  one of its facets
void gather_face(const Block& root, const FacetPlace& face, std::vector<FacetPlace>& facets);

/// A box grown by so many surface steps on each side, within what int32 holds.
GridBox grown(const GridBox& box, std::int32_t steps);

}  // namespace firma

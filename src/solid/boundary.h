// SPDX-License-Identifier: MIT
// The whole boundary of the solid in some blocks, as a patch, with the facets of each face.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solid/solid_patch.h"
#include "tree/block.h"

namespace firma {

struct Boundary {
    SolidPatch patch;
    std::vector<FacetPlace> facets;          ///< face by face, in the tree's order
    std::vector<std::uint32_t> first_facet;  ///< of each face of the patch in `facets`, and the end

    std::span<const FacetPlace> facets_of(std::uint32_t face) const {
        return {facets.data() + first_facet[face], first_facet[face + 1] - first_facet[face]};
    }
};

/// @param roots  trees of rooms; null ones are passed over
Boundary take_boundary(std::span<const Block* const> roots);

}  // namespace firma

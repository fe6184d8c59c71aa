// SPDX-License-Identifier: MIT
// The whole boundary of a solid as a patch, with the facets of each face.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solid/block.h"
#include "solid/solid_patch.h"

namespace firma {

struct Boundary {
    SolidPatch patch;                        ///< faces in order of the lowest id of their facets
    std::vector<FacetPlace> facets;          ///< face by face, in order of id
    std::vector<std::uint32_t> first_facet;  ///< of each face of the patch in `facets`, and the end

    std::span<const FacetPlace> facets_of(std::uint32_t face) const {
        return {facets.data() + first_facet[face], first_facet[face + 1] - first_facet[face]};
    }
};

/// @param root  of an index over the faces of a solid; null for none
Boundary take_boundary(const Node* root);

/// Of these facets, in any order.
Boundary boundary_of(std::vector<FacetPlace> facets);

}  // namespace firma

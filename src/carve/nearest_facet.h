// SPDX-License-Identifier: MIT
// The facet of a solid that is nearest to a point.
#pragma once

#include <optional>

#include "solid/block.h"

namespace firma {

struct NearestFacet {
    FacetPlace place;
    Vec3 at;      ///< metres: its point nearest to the one given
    Vec3 normal;  ///< unit, of the facet
};

/// Of several as near the one with the lowest id.
/// @param root   null for no faces
/// @param reach  metres: nothing farther counts
std::optional<NearestFacet> nearest_facet(const Node* root, const Vec3& point, double reach);

}  // namespace firma

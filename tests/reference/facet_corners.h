// SPDX-License-Identifier: MIT
// A facet's corners in a row.
#pragma once

#include <vector>

#include "solid/block.h"

namespace firma {

inline std::vector<GridPoint> grid_corners_of(const FacetPlace& place) {
    std::vector<GridPoint> corners;
    place.block->for_each_corner(place.record(), [&](const GridPoint& corner) { corners.push_back(corner); });
    return corners;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// A facet's corners in a row, and its area.
#pragma once

#include <span>
#include <vector>

#include "solid/block.h"

namespace firma {

inline std::vector<GridPoint> grid_corners_of(const FacetPlace& place) {
    std::vector<GridPoint> corners;
    place.block->for_each_corner(place.record(), [&](const GridPoint& corner) { corners.push_back(corner); });
    return corners;
}

/// In metres.
inline std::vector<Vec3> facet_corners(const FacetPlace& place) {
    std::vector<Vec3> corners;
    for (const GridPoint& corner : grid_corners_of(place)) corners.push_back(to_metres(corner));
    return corners;
}

/// Along the normal, twice the area long.
inline Vec3 area_vector(std::span<const Vec3> polygon) {
    Vec3 twice;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        twice = twice + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return twice;
}

}  // namespace firma

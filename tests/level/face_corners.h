// SPDX-License-Identifier: MIT
// Faces of a level, as places.
#pragma once

#include <vector>

#include "firma/grid.h"
#include "firma/level.h"
#include "firma/vec.h"

namespace firma::test {

inline std::vector<Vec3> corners_of(const Level& level, const LevelFace& face) {
    std::vector<Vec3> corners;
    for (std::uint32_t k = 0; k < face.corner_count; ++k)
        corners.push_back(to_metres(level.vertices[level.corners[face.first_corner + k]]));
    return corners;
}

/// Twice the area, along the normal.
inline Vec3 twice_area(const std::vector<Vec3>& corners) {
    Vec3 area;
    for (std::size_t k = 2; k < corners.size(); ++k)
        area = area + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    return area;
}

}  // namespace firma::test

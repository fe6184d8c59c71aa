// SPDX-License-Identifier: MIT
// Faces on their way into a tree: plain arrays, in no order.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/grid.h"
#include "firma/hit.h"

namespace firma {

struct FaceSet {
    struct Entry {
        FaceId id;
        std::uint32_t source = 0;
        std::uint32_t material = 0;
        std::uint32_t mask = ~0u;
        std::uint32_t first_corner = 0;
        std::uint32_t corner_count = 0;  ///< 3 to kMaxCorners
        bool two_sided = false;
    };
    std::vector<Entry> faces;
    std::vector<GridPoint> vertices;
    std::vector<std::uint32_t> corners;  ///< indices into vertices
};

}  // namespace firma

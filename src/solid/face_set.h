// SPDX-License-Identifier: MIT
// Faces on their way into blocks: plain arrays, in no order.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/grid.h"
#include "firma/hit.h"
#include "solid/block.h"

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
        bool solid = false;
        std::uint32_t edit = 0;
        std::uint32_t part = 0;
        const FaceOwner* owner = nullptr;  ///< null: its own
    };
    std::vector<Entry> faces;
    std::vector<GridPoint> vertices;
    std::vector<std::uint32_t> corners;  ///< indices into vertices
    /// Keeps alive what entries point to; may lack what something else keeps alive until the blocks are built.
    std::vector<Ref<const FaceOwner>> owners;

    const GridPoint& corner(const Entry& face, std::size_t k) const { return vertices[corners[face.first_corner + k]]; }
    /// Around its corners.
    GridBox box_of(const Entry& face) const {
        GridBox box;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) box.add(corner(face, k));
        return box;
    }
};

}  // namespace firma

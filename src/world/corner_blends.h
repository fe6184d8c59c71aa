// SPDX-License-Identifier: MIT
// How pictures along the three axes are mixed at the corners of faces that edits made, so that no seam shows between
// them.
//
// Faces of edits have no texture coordinates of their own, and lie in all directions: a picture laid along the axis
// nearest to each face would break where that axis changes. So three pictures are mixed, and by how much follows from
// the directions of all such faces around a corner: faces that share an edge then agree at both of its ends, and so all
// along it. Where faces meet sharply (kSharp) each side has its own mixture: a flat face of a box, say, whose corners
// would otherwise show the streaks of pictures that lie along it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/point_numbers.h"
#include "firma/hit.h"
#include "firma/vec.h"
#include "geometry/grid_box.h"
#include "world/world_data.h"

namespace firma {

/// Parts of 255: of the pictures along x, y and z, and of that by the face's own coordinates.
using Blend = std::array<std::uint8_t, 4>;

inline constexpr Blend kOwnPicture{0, 0, 0, 255};

class CornerBlends {
public:
    /// Of all corners in a box of faces that edits made, whatever room, mask and side.
    /// Costs the faces around the box.
    CornerBlends(const WorldData& data, const GridBox& box);

    /// @param corner, face  of a face that an edit made, in the box
    Blend at(const GridPoint& corner, FaceId face);

private:
    /// A face at a corner.
    struct Side {
        FaceId face;
        Vec3 normal;    ///< unit
        double weight;  ///< by its angle there
        Blend blend{};
    };

    void mix(std::span<Side> around);

    PointNumbers points_;
    std::vector<std::uint32_t> first_;  ///< into sides_, of each point, and the end
    std::vector<Side> sides_;
};

}  // namespace firma

// SPDX-License-Identifier: MIT
// Faces of a block as queries want them.
#pragma once

#include <span>

#include "firma/world.h"
#include "geometry/polygon_shape.h"
#include "tree/block.h"

namespace firma {

/// A face's corners in metres, on the stack, and the polygon that views them.
class FaceShape {
public:
    FaceShape(const Block& block, const FaceRecord& face) {
        for (std::size_t k = 0; k < face.corner_count; ++k) corners_.at[k] = to_metres(block.corner(face, k));
        polygon = make_shape({corners_.at, face.corner_count});
    }
    FaceShape(const FaceShape&) = delete;
    FaceShape& operator=(const FaceShape&) = delete;

    PolygonShape polygon;

private:
    /// Without the zeros that a Vec3 begins with: there are many, and few are used.
    union Corners {
        Corners() {}
        Vec3 at[kMaxCorners];
    } corners_;
};

/// A face as users see it, in the tree of its room.
Face describe_face(const Block& root, const Block& block, const FaceRecord& face);
/// The same without its neighbours.
Face describe_face(const Block& block, const FaceRecord& face);

}  // namespace firma

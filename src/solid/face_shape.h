// SPDX-License-Identifier: MIT
// A face of a block as casts and measures want it.
#pragma once

#include <span>

#include "geometry/polygon_shape.h"
#include "solid/block.h"

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

}  // namespace firma

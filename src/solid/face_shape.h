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
        std::size_t count = 0;
        block.for_each_corner(face, [&](const GridPoint& corner) { corners_.at[count++] = to_metres(corner); });
        polygon = make_shape({corners_.at, face.corner_count});
    }
    explicit FaceShape(std::span<const GridPoint> corners) {
        for (std::size_t k = 0; k < corners.size(); ++k) corners_.at[k] = to_metres(corners[k]);
        polygon = make_shape({corners_.at, corners.size()});
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

/// Of a facet all of whose corners are in one lane, exactly (FaceLanes::whole). The normal then is the exact one.
class LaneShape {
public:
    LaneShape(const FaceLanes& lanes, std::uint32_t lane) {
        lanes.read_corners(lane, corners_);
        polygon.corners = corners_;
        // Added to zero as make_shape() does, so that no zero is negative.
        polygon.normal = Vec3{} + cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
        polygon.normal_length = length(polygon.normal);
    }
    LaneShape(const LaneShape&) = delete;
    LaneShape& operator=(const LaneShape&) = delete;

    PolygonShape polygon;

private:
    Vec3 corners_[3];
};

}  // namespace firma

// SPDX-License-Identifier: MIT
// The point of a polygon nearest to a point, seen from the polygon's first corner so that nothing is lost far from the
// origin.
#pragma once

#include <cstdint>

#include "firma/polygon.h"
#include "geometry/polygon_shape.h"

namespace firma {

struct Closest {
    Vec3 offset;  ///< of the nearest point, from the first corner
    Vec3 away;    ///< from the nearest point to the point
    double distance = 0;
    Feature feature = Feature::kFace;
    std::uint32_t index = 0;  ///< of the vertex, or of the edge's first corner
};

/// @param w  the point less the polygon's first corner
Closest closest_to(const Vec3& w, const PolygonShape& polygon);

/// The same of the plane: what is nearest where foot_inside().
Closest foot_on_plane(const Vec3& w, const PolygonShape& polygon);

/// The same among the sides alone.
Closest closest_on_rim(const Vec3& w, const PolygonShape& polygon);

/// Whether the foot on the polygon's plane lies in the polygon, to rounding: then that is the nearest point.
bool foot_inside(const Vec3& w, const PolygonShape& polygon);

}  // namespace firma

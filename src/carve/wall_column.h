// SPDX-License-Identifier: MIT
// What stands straight over a hole in a wall: where the wall's plane meets a box, and a prism over polygons in it.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/cutter.h"
#include "firma/vec.h"
#include "geometry/grid_box.h"
#include "solid/face_set.h"

namespace firma {

/// As near as doubles are; where it is square to an axis, exactly.
struct WallPlane {
    Vec3 normal;             ///< unit, out of the wall
    double offset = 0;       ///< metres: the plane's points have normal . p = offset
    int axis = -1;           ///< that it is square to; -1: slanted
    std::int32_t level = 0;  ///< with an axis: of all its points, surface steps

    /// Metres in front of it.
    double height(const Vec3& p) const { return dot(normal, p) - offset; }
};

/// @param normal  unit
/// @param point   of the plane
WallPlane wall_plane(const Vec3& normal, const GridPoint& point);

/// Polygons, counter-clockwise seen from the wall's front, that cover where its plane meets a box. Of a slanted plane:
/// of corners on the surface grid at most 5 surface steps behind it.
/// @return none where they do not meet, or the polygons would reach out of the world
FaceSet section_of_box(const WallPlane& wall, const GridBox& box);

/// Prisms over polygons in the plane of a wall: from a little under it (2 mm; 8 mm of a slanted one) straight out.
/// @param polygons  convex, counter-clockwise seen from the wall's front
/// @param height    metres
/// @return one, with the polygons' corners snapped to the input grid. Where that crosses itself: one for each polygon,
///         grown by an input step, so that they overlap. None of what would reach out of the world.
std::vector<Cutter> columns_over(const FaceSet& polygons, const WallPlane& wall, double height);

}  // namespace firma

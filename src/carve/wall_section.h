// SPDX-License-Identifier: MIT
// Where the plane of a wall meets a placed cutter.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/cutter_solid.h"
#include "firma/grid.h"
#include "firma/vec.h"

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

/// Closed outlines, one behind the other, in metres.
struct WallOutlines {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> ends;
};

/// Outlines around what of the plane lies in the cutter: counter-clockwise seen from the wall's front, clockwise around
/// what is left within. In double: where it decides which side a vertex lies on, that holds for all triangles around
/// it, so outlines are closed whatever the rounding. A face of the cutter in the plane counts as the wall does: it
/// takes where both look the same way. The plane of a slanted wall is taken 4 surface steps behind it. Linear in the
/// cutter's triangles.
WallOutlines section_of(const CutterSolid& cutter, const WallPlane& wall);

}  // namespace firma

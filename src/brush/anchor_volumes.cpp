// SPDX-License-Identifier: MIT
// The volumes in which nothing falls.
#include <cmath>

#include "brush/winding.h"
#include "firma/brush_world.h"

namespace firma {

std::vector<Box> anchor_volumes(const BrushLevel& level) {
    std::vector<Box> volumes;
    for (const Brush& brush : level.brushes) {
        if (brush.entity >= level.entities.size()) continue;
        if (level.entities[brush.entity].value("classname") != "firma_anchor") continue;
        std::vector<FloatPlane> planes;
        for (std::uint32_t k = 0; k < brush.side_count && brush.first_side + k < level.sides.size(); ++k) {
            const GridPoint(&p)[3] = level.sides[brush.first_side + k].points;
            if (const auto plane = float_plane(to_metres(p[0]), to_metres(p[1]), to_metres(p[2])))
                planes.push_back(*plane);
        }
        Box box;
        for (std::size_t side = 0; side < planes.size(); ++side)
            for (const Vec3& corner : winding(planes, side, 4 * kWorldRim)) {
                // Corners are off by roundings; those of boxes lie on the grid.
                Vec3 snapped;
                for (int axis = 0; axis < 3; ++axis)
                    snapped[axis] = std::floor(corner[axis] * kInputSteps + 0.5) / kInputSteps;
                box.add(snapped);
            }
        bool is_sound = true;  // of one that is open, corners lie far outside
        for (int axis = 0; axis < 3; ++axis)
            is_sound = is_sound && box.low[axis] < box.high[axis] && box.low[axis] > -2 * kWorldRim &&
                       box.high[axis] < 2 * kWorldRim;
        if (is_sound) volumes.push_back(box);
    }
    return volumes;
}

}  // namespace firma

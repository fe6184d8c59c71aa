// SPDX-License-Identifier: MIT
// A cutter's triangles, and the inside of it, against a region widened to the surface grid.
#include "carve/reaches_into.h"

#include <cmath>
#include <vector>

#include "carve/polygon_reaches.h"

namespace firma {

bool reaches_into(const CutterSolid& cutter, const Box& region) {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = std::floor(region.low[axis] * kSurfaceSteps),
                     high = -std::floor(-region.high[axis] * kSurfaceSteps);
        if (!(low <= high) || high < INT32_MIN || low > INT32_MAX)
            return false;  // empty, no number, or outside the world
        box.low[axis] = low < INT32_MIN ? INT32_MIN : std::int32_t(low);
        box.high[axis] = high > INT32_MAX ? INT32_MAX : std::int32_t(high);
    }
    if (!boxes_meet(box, cutter.box)) return false;
    std::vector<Vec3> corners;
    const auto reaches = [&](std::uint32_t t) {
        corners.clear();
        for (const std::uint32_t v : cutter.triangle(t)) corners.push_back(cutter.points[v].approximate());
        return polygon_reaches_into(corners, box);
    };
    if (cutter.tree.for_each_meeting(box, reaches)) return true;
    GridPoint middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) / 2);
    return side_of_cutter(cutter, ExactPoint(to_input(middle))) > 0;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// The faces of a level as triangles, of which a cutter is made.
#pragma once

#include <vector>

#include "firma/cutter.h"
#include "firma/level.h"
#include "firma/result.h"
#include "firma/vec.h"

namespace firma {

struct LevelTriangles {
    std::vector<Vec3> vertices;  ///< metres; those in one place are named by the number of the first
    std::vector<CutterTriangle> triangles;
};

/// What cutter_from_level() gives make_cutter(), and its errors.
Result<LevelTriangles> level_triangles(const Level& level);

}  // namespace firma

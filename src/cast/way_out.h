// SPDX-License-Identifier: MIT
// How a shape that shares a point with a polygon leaves it.
#pragma once

#include "geometry/closest_point.h"

namespace firma {

struct WayOut {
    Vec3 direction;    ///< unit: moved this way by `depth` the shape no more than touches
    double depth = 0;  ///< metres, >= 0
    Closest closest;   ///< of the polygon, to the shape
};

}  // namespace firma

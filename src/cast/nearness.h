// SPDX-License-Identifier: MIT
// How near a point is to a polygon, against a radius and along a direction, in double-double: for what double leaves
// open.
#pragma once

#include "cast/vector_of.h"
#include "geometry/closest_point.h"
#include "geometry/polygon_shape.h"

namespace firma {

struct Nearness {
    bool within = false;  ///< distance <= radius, equal to the last digit counting as equal
    bool on_it = false;   ///< distance 0
    int change = 0;       ///< sign of the distance's derivative along the direction
};

/// @param closest  where on the polygon the nearest point lies, by double
/// @param facing   sign of direction . normal
Nearness nearness(const Vec3& point, double radius, const Vec3& direction, int facing, const PolygonShape& polygon,
                  const Closest& closest);

/// Of a point at w from a line along e.
Nearness near_line(const VectorOf<DoubleDouble>& w, const VectorOf<DoubleDouble>& e,
                   const VectorOf<DoubleDouble>& direction, double radius);

/// Of a point over a plane: its height and how that changes, both times the length of the plane's normal.
Nearness near_plane(const DoubleDouble& height, const DoubleDouble& change, const DoubleDouble& square_length,
                    double radius);

/// Whether a closed ball meets a closed polygon: by double where that is sure, else by nearness().
bool ball_meets(const Vec3& centre, double radius, const PolygonShape& polygon, const Closest& closest);

}  // namespace firma

// SPDX-License-Identifier: MIT
// A particle against a triangle of lanes whose corners are exact, once its plane is known to be crossed: what
// cast_particle_polygon() says, to the bit. Sides of edges that double leaves open are asked for exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "cast/contact.h"
#include "cast/sweep.h"
#include "geometry/closest_point.h"
#include "geometry/exact_predicates.h"
#include "geometry/polygon_shape.h"
#include "geometry/rounding.h"
#include "geometry/whole_path.h"
#include "solid/face_lanes.h"

namespace firma {

/// Whether the path's line passes between the edges, or through one or a corner. Apart, as of few triangles the lanes
/// leave that open.
/// @param facing   the sign of direction . normal, not 0
inline bool line_passes(const Sweep& sweep, const Vec3 (&corner)[3], int facing) {
    const double start[3] = {sweep.start.x, sweep.start.y, sweep.start.z};
    double seen[3][3];  // seen from the start, each coordinate rounded once
    double size = 0;
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) {
            seen[c][axis] = corner[c][axis] - start[axis];
            size = std::max(size, std::fabs(seen[c][axis]));
        }
    // By the sides of the projection: bounds as in cast_particle_polygon().
    const int u = sweep.axis_u, v = sweep.axis_v, k = sweep.axis_k;
    double flat[3][2];
    for (int c = 0; c < 3; ++c) {
        flat[c][0] = seen[c][u] - sweep.shear_u * seen[c][k];
        flat[c][1] = seen[c][v] - sweep.shear_v * seen[c][k];
    }
    const double side[3] = {(flat[0][0] * flat[1][1] - flat[0][1] * flat[1][0]) * facing,
                            (flat[1][0] * flat[2][1] - flat[1][1] * flat[2][0]) * facing,
                            (flat[2][0] * flat[0][1] - flat[2][1] * flat[0][0]) * facing};
    const double unsure = 128 * kRoundoff * size * size;
    const double least = std::min(std::min(side[0], side[1]), side[2]);
    if (least < -unsure) return false;
    if (least > unsure) return true;
    const unsigned open =
        unsigned(side[0] <= unsure) | unsigned(side[1] <= unsure) << 1 | unsigned(side[2] <= unsure) << 2;
    const unsigned signs = exact_triangle_sides(sweep.start, sweep.direction, corner, size, open);
    return !(signs & (facing > 0 ? kSomeNegative : kSomePositive));
}

/// The same of a lane that is whole.
/// @param whole  of the sweep's path; made at the first such question
/// @param open   the edges of which that is not known, bits as of exact_triangle_sides()
[[gnu::noinline]] inline bool line_passes(const Sweep& sweep, [[maybe_unused]] std::optional<WholePath>& whole,
                                          const FaceLanes& lanes, std::uint32_t lane, [[maybe_unused]] unsigned open,
                                          int facing) {
#if !defined(__wasm__)  // which has to be small
    if (!whole) whole.emplace(sweep.start, sweep.direction);
    if (whole->known()) {
        const auto corner = [&](std::uint32_t k) { return lanes.grid_corner(lane, k); };
        return !(whole->triangle_sides(corner, open) & (facing > 0 ? kSomeNegative : kSomePositive));
    }
#endif
    Vec3 corners[3];
    lanes.read_corners(lane, corners);
    return line_passes(sweep, corners, facing);
}

/// The same as make_hit(), to the bit, where the point met lies over the triangle as double has it.
/// @param polygon  of LaneShape
/// @param inside   whether the line surely passes between the edges
/// @param hit      one that says nothing yet
/// @return whether it was made
inline bool make_hit_inside(const Sweep& sweep, const PolygonShape& polygon, bool inside, bool away,
                            const Contact& contact, PolygonHit& hit) {
    const Vec3& corner = polygon.corners[0];
    const Vec3 centre = (sweep.start - corner) + sweep.direction * contact.t;
    if (!inside && !foot_inside(centre, polygon)) return false;
    const double height = dot(centre, polygon.normal) / polygon.normal_length;
    hit.status = contact.status;
    hit.feature = contact.feature;
    hit.feature_index = contact.index;
    hit.fraction = sweep.fraction(contact.t);
    hit.centre = sweep.at(contact.t);
    hit.face_normal = polygon.unit_normal();
    hit.point = corner + (centre - hit.face_normal * height);
    hit.normal = away ? -hit.face_normal : hit.face_normal;
    return true;
}

}  // namespace firma

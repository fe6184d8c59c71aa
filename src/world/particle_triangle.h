// SPDX-License-Identifier: MIT
// A particle against a triangle of lanes whose corners are exact: what cast_particle_polygon() says, to the bit, all in
// one where double settles every sign; where it leaves one open, the answer is to be asked of the polygon.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "cast/contact.h"
#include "cast/entry.h"
#include "cast/sweep.h"
#include "geometry/rounding.h"
#include "solid/face_lanes.h"

namespace firma {

/// @param sweep   of radius 0
/// @param lane    one of lanes.whole
/// @param latest  nothing after it is wanted
/// @return none where the polygon is to be asked
inline std::optional<Contact> cast_particle_triangle(const Sweep& sweep, const FaceLanes& lanes, std::uint32_t lane,
                                                     bool front_only, double latest) {
    const double start[3] = {sweep.start.x, sweep.start.y, sweep.start.z};
    const double origin[3] = {double(lanes.origin.x) / kSurfaceSteps, double(lanes.origin.y) / kSurfaceSteps,
                              double(lanes.origin.z) / kSurfaceSteps};
    double corner[3][3], seen[3][3];  // seen from the start, each coordinate rounded once
    double size = 0;
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) {
            corner[c][axis] = origin[axis] + double(lanes.corner[c][axis][lane]);
            seen[c][axis] = corner[c][axis] - start[axis];
            size = std::max(size, std::fabs(seen[c][axis]));
        }

    // The line, by the sides of the projection: bounds as in cast_particle_polygon().
    const int u = sweep.axis_u, v = sweep.axis_v, k = sweep.axis_k;
    double flat[3][2];
    for (int c = 0; c < 3; ++c) {
        flat[c][0] = seen[c][u] - sweep.shear_u * seen[c][k];
        flat[c][1] = seen[c][v] - sweep.shear_v * seen[c][k];
    }
    const double one = flat[0][0] * flat[1][1] - flat[0][1] * flat[1][0];
    const double two = flat[1][0] * flat[2][1] - flat[1][1] * flat[2][0];
    const double three = flat[2][0] * flat[0][1] - flat[2][1] * flat[0][0];
    const double least = std::min(std::min(one, two), three), most = std::max(std::max(one, two), three);
    const double unsure = 128 * kRoundoff * size * size;
    if (least < -unsure && most > unsure) return Contact{};
    int facing;
    if (least > unsure)
        facing = 1;
    else if (most < -unsure)
        facing = -1;
    else
        return std::nullopt;
    if (facing > 0 && front_only) return Contact{};

    // The plane, as view_plane() and enter_plane() have it.
    const Vec3 a{corner[0][0], corner[0][1], corner[0][2]};
    const Vec3 b{corner[1][0], corner[1][1], corner[1][2]}, c{corner[2][0], corner[2][1], corner[2][2]};
    const Vec3 normal = Vec3{} + cross(b - a, c - a);
    const double normal_length = length(normal);
    const Vec3 w = sweep.start - a;
    const double height = dot(w, normal), rise = dot(sweep.direction, normal);
    const Vec3 sizes{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
    const double height_sizes = std::fabs(w.x) * sizes.x + std::fabs(w.y) * sizes.y + std::fabs(w.z) * sizes.z;
    const double rise_sizes = 2 * (sizes.x + sizes.y + sizes.z);
    if (!(std::fabs(rise) > rounding(8) * rise_sizes) || (rise > 0) != (facing > 0)) return std::nullopt;
    const double end = height + rise * sweep.end;
    const double doubt = rounding(16) * (height_sizes + rise_sizes * sweep.end);
    if (!(std::fabs(height) > doubt) || !(std::fabs(end) > doubt)) return std::nullopt;
    if ((height > 0) == (facing > 0) || (end > 0) != (facing > 0)) return Contact{};
    const double scale = -facing / normal_length;
    const double approach = -rise * scale;
    if (!(approach >= sweep.direction_length * 0.125)) return std::nullopt;
    const double t = height * scale / approach;
    if (near_end(t, sweep.end) || !(t > 0)) return std::nullopt;
    if (t > latest) return Contact{};
    return Contact{Status::kHit, Feature::kFace, 0, t > sweep.end ? sweep.end : t};
}

}  // namespace firma

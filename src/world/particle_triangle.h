// SPDX-License-Identifier: MIT
// A particle against a triangle of lanes whose corners are exact: what cast_particle_polygon() says, to the bit, all in
// one. Sides of edges that double leaves open are asked for exactly; where it leaves the plane open, the answer is to
// be asked of the polygon.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cast/contact.h"
#include "cast/entry.h"
#include "cast/sweep.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"
#include "solid/face_lanes.h"

namespace firma {

/// Says by its time that the polygon is to be asked.
inline constexpr Contact kAskThePolygon{Status::kMiss, Feature::kFace, 0, -1};

/// One that is met at t if the open edges let the path through. Apart, as few are asked.
/// @param edges     those, bits as of exact_triangle_sides()
/// @param height    of the start over the plane, on its side
[[gnu::noinline]] inline Contact cast_past_open_edges(const Sweep& sweep, const FaceLanes& lanes, std::uint32_t lane,
                                                      unsigned edges, int facing, double size, double height,
                                                      double approach, double t, double latest) {
    Vec3 corners[3];
    lanes.read_corners(lane, corners);
    if (t > latest) {
        // Triangles at one corner are met at one time but for rounding: so far later ones are told of, as polygons are.
        const double error = rounding(16) * length(sweep.start - corners[0]);
        const double fall = (approach + rounding(16) * sweep.direction_length) * latest;
        if (height - error > fall * (1 + rounding(8))) return Contact{};
    }
    const unsigned signs = exact_triangle_sides(sweep.start, sweep.direction, corners, size, edges);
    if (signs & (facing > 0 ? kSomeNegative : kSomePositive)) return Contact{};
    return Contact{Status::kHit, Feature::kFace, 0, t > sweep.end ? sweep.end : t};
}

/// @param sweep   of radius 0, from within 2^20 m
/// @param lane    one of lanes.whole
/// @param latest  nothing after it is wanted, but by rounding
/// @return its t is below 0 where the polygon is to be asked
inline Contact cast_particle_triangle(const Sweep& sweep, const FaceLanes& lanes, std::uint32_t lane, bool front_only,
                                      double latest) {
    const double start[3] = {sweep.start.x, sweep.start.y, sweep.start.z};
    Vec3 corner[3];
    lanes.read_corners(lane, corner);
    double seen[3][3];  // seen from the start, each coordinate rounded once
    double size = 0;
    for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) {
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
    // Where an edge is open, what follows supposes that the line meets the triangle: where it does not, nothing is met.
    unsigned open = 0;
    if (!(least > unsure || most < -unsure))
        open = unsigned(std::fabs(one) <= unsure) | unsigned(std::fabs(two) <= unsure) << 1 |
               unsigned(std::fabs(three) <= unsure) << 2;
    int facing;
    if (most > unsure)
        facing = 1;
    else if (least < -unsure)
        facing = -1;
    else
        return kAskThePolygon;
    if (facing > 0 && front_only) return Contact{};

    // The plane, as view_plane() and enter_plane() have it.
    const Vec3 &a = corner[0], &b = corner[1], &c = corner[2];
    const Vec3 normal = Vec3{} + cross(b - a, c - a);
    const double normal_length = length(normal);
    const double height = dot(sweep.start - a, normal), rise = dot(sweep.direction, normal);
    const double normal_size = std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z);
    const double rise_size = 2 * normal_size;
    if (!(std::fabs(rise) > rounding(8) * rise_size) || (rise > 0) != (facing > 0)) return kAskThePolygon;
    const double end = height + rise * sweep.end;
    const double doubt = rounding(16) * (size * normal_size + rise_size * sweep.end);
    if (!(std::fabs(height) > doubt) || !(std::fabs(end) > doubt)) return kAskThePolygon;
    if ((height > 0) == (facing > 0) || (end > 0) != (facing > 0)) return Contact{};
    const double scale = -facing / normal_length;
    const double approach = -rise * scale;
    if (!(approach >= sweep.direction_length * 0.125)) return kAskThePolygon;
    const double t = height * scale / approach;
    if (near_end(t, sweep.end) || !(t > 0)) return kAskThePolygon;
#if defined(__wasm__)  // which has to be small
    if (open) return kAskThePolygon;
#else
    if (open) return cast_past_open_edges(sweep, lanes, lane, open, facing, size, height * scale, approach, t, latest);
#endif
    if (t > latest) return Contact{};
    return Contact{Status::kHit, Feature::kFace, 0, t > sweep.end ? sweep.end : t};
}

}  // namespace firma

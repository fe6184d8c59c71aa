// SPDX-License-Identifier: MIT
// Puts a cutter into the world: turned, scaled, moved, and snapped to the input grid, once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "carve/cutter_topology.h"
#include "firma/cutter.h"
#include "firma/result.h"
#include "geometry/exact_plane.h"

namespace firma {

/// Every triangle has area, and the whole encloses a positive volume, exactly; find_crossing() says whether it crosses
/// itself.
struct PlacedCutter {
    std::vector<InputPoint> vertices;
    std::vector<CutterTriangle> triangles;  ///< counter-clockwise seen from outside
    std::uint64_t hash = 0;                 ///< of vertices and triangles
    /// The edges, the same wherever a cutter is placed.
    std::shared_ptr<const CutterTopology> topology;
    std::string name;  ///< the cutter's, for messages
};

/// Turns, scales and moves each vertex in double, in a fixed order of operations, and snaps it: nearest multiple of
/// 1/4096 m, halves to even.
///
/// Errors: kInvalid for an empty cutter, a rotation that is zero or not finite, a scale that is not finite and above
/// zero, a triangle that has no area on the grid (named), a cutter that encloses no volume there; kOutOfRange for a
/// position that is not finite, or a vertex outside the world (named).
Result<PlacedCutter> place_cutter(const Cutter& cutter, const Pose& pose);

/// How far move_cutter() moves a vertex at most, in input steps a coordinate: at first, and (move_vertices() too) at
/// last.
inline constexpr std::int32_t kLeastMove = 3;
inline constexpr std::int32_t kFarthestMove = 24;

/// A cutter of more vertices is large: of it only what touches is moved.
inline constexpr std::size_t kMostMovedWhole = 2000;

/// A placed cutter with every vertex moved a little at random, seeded by its hash and the count of tries: for a cutter
/// in degenerate position. Vertices go outward, so that a cutter flush with a wall opens it rather than leave a contact
/// offset, and one that is put where it was before takes a little more each time; by up to 3 steps a coordinate, and
/// after every 16 tries by up to twice as much (where the same place is cut again and again, the first few steps fill
/// up).
///
/// @param placed  as place_cutter() gave it, never one that was moved already
/// @param tries   1, 2, ...
/// Errors: kInvalid, kOutOfRange as above.
Result<PlacedCutter> move_cutter(const PlacedCutter& placed, int tries);

/// Moves some vertices alone: for a cutter of very many, of which each try would bring others into degenerate position.
/// What earlier tries did to the rest stays. All go by the same steps, outward along each axis where there is an
/// outward, so that small triangles side by side do not fold: by one at first, then by up to one more after every
/// other try, kFarthestMove at last.
///
/// @param placed    as place_cutter() gave it: the vertices are put beside where they were in it
/// @param before    as the last try left it
/// @param vertices  in rising order
Result<PlacedCutter> move_vertices(const PlacedCutter& placed, const PlacedCutter& before,
                                   std::span<const std::uint32_t> vertices, int tries);

}  // namespace firma

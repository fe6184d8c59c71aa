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
#include "carve/pose_turn.h"
#include "firma/cutter.h"
#include "firma/result.h"
#include "geometry/exact_plane.h"

namespace firma {

/// Every triangle has area, and the whole encloses a positive volume, exactly; find_crossing() says whether it crosses
/// itself.
struct PlacedCutter {
    std::vector<InputPoint> vertices;
    std::vector<CutterTriangle> triangles;  ///< counter-clockwise seen from outside
    /// The edges, the same wherever a cutter is placed.
    std::shared_ptr<const CutterTopology> topology;
    std::string name;  ///< the cutter's, for messages
};

/// The turn and scale of a pose, if that can place a cutter at all: errors of place_cutter() that say why not.
Result<PoseTurn> judge_pose(const Cutter& cutter, const Pose& pose);

/// An error of a cutter: its name goes in front of the place.
Error cutter_error(const std::string& name, std::string place, ErrorCode code, std::string reason);
/// What place_cutter() says of a vertex.
Error outside_world(const std::string& name, std::size_t vertex);

/// Turns, scales and moves each vertex in double, in a fixed order of operations, and snaps it: nearest multiple of
/// 1/4096 m, halves to even.
///
/// Errors: kInvalid for an empty cutter, a rotation that is zero or not finite, a scale that is not finite and above
/// zero, a triangle that has no area on the grid (named), a cutter that encloses no volume there; kOutOfRange for a
/// position that is not finite, or a vertex outside the world (named).
///
/// @param cutter  a mesh; of a solid see place_solid.h
Result<PlacedCutter> place_cutter(const Cutter& cutter, const Pose& pose);

}  // namespace firma

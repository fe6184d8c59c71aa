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

}  // namespace firma

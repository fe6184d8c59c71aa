// SPDX-License-Identifier: MIT
// What a Cutter shares: its mesh, and the mesh's edges, found once however often it is placed; or a Solid.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carve/cutter_topology.h"
#include "firma/cutter.h"
#include "firma/solid.h"

namespace firma {

struct CutterData {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
    CutterTopology topology;
    std::optional<Solid> solid;  ///< that it is; then the mesh is its facets', and has no topology
    std::string name;
};

}  // namespace firma

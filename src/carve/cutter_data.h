// SPDX-License-Identifier: MIT
// What a Cutter shares: its mesh, and the mesh's edges, found once however often it is placed.
#pragma once

#include <string>
#include <vector>

#include "carve/cutter_topology.h"
#include "firma/cutter.h"

namespace firma {

struct CutterData {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
    CutterTopology topology;
    std::string name;
};

}  // namespace firma

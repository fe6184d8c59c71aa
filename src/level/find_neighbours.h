// SPDX-License-Identifier: MIT
// Which faces share an edge.
#pragma once

#include <span>
#include <vector>

#include "firma/hit.h"
#include "firma/level.h"

namespace firma {

/// For each corner of each face, in order, the face across the edge from this corner to the next; its index stands for
/// its id. Vertices at one position are one vertex. Invalid on an edge that is not used once each way.
std::vector<FaceId> find_neighbours(const Level& level);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Chunks of the depot by blasts, for benchmarks of bodies and pieces.
#pragma once

#include <cstddef>
#include <vector>

#include "firma/carve.h"

namespace firma::bench {

struct DepotRubble {
    World world;  ///< after the blasts
    std::vector<Chunk> chunks;
};

/// Chunks of at least 50 litres, of blasts twice as large as those of scenes::level_cuts().
DepotRubble depot_rubble(const World& level, std::size_t count);

}  // namespace firma::bench

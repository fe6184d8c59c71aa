// SPDX-License-Identifier: MIT
// Crossings in their order along each edge.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/crossings.h"

namespace firma {

/// Crossings along each edge that has some, in order from its first vertex.
struct CutOrder {
    /// In `along`.
    struct Range {
        std::uint32_t first = 0, count = 0;
    };
    std::vector<std::uint32_t> along;
    std::vector<Range> world_cuts, cutter_cuts;  ///< an edge each
};

/// Orders the crossings along every edge; they must alternate between entering and leaving.
/// @param order  replaced; keeps its memory
Verdict order_cuts(const CutInput& in, const Crossings& crossings, CutOrder& order);

/// Whether the edge goes inward here: it starts in front of the plane that it crosses.
bool enters(const CutInput& in, const CutPoint& crossing);

}  // namespace firma

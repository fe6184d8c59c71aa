// SPDX-License-Identifier: MIT
// Which faces of a level bound closed solids, and can be carved.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/level.h"

namespace firma {

struct LevelSolids {
    std::vector<bool> solid;    ///< a face each
    bool rock_outside = false;  ///< the largest piece is wound inward: what no face separates from infinity is solid
};

/// A piece of the surface, joined by edges, is closed when every edge is used exactly once each way, all its faces are
/// one-sided, and its vertices lie on the input grid.
LevelSolids find_solids(const Level& level);

}  // namespace firma

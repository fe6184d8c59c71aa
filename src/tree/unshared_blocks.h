// SPDX-License-Identifier: MIT
// The blocks that only one of two worlds' trees have: what an edit made, and what it let go of.
#pragma once

#include <span>
#include <vector>

#include "tree/block.h"

namespace firma {

struct UnsharedBlocks {
    std::vector<const Block*> before, after;  ///< in no order that means anything
};

/// Opens only what differs, so for trees a few edits apart the cost follows the edits.
/// @param before, after  roots, in any order; what both have may be left out
UnsharedBlocks unshared_blocks(std::span<const Block* const> before, std::span<const Block* const> after);

}  // namespace firma

// SPDX-License-Identifier: MIT
// The blocks that only one of two trees has: what an edit made, and what it let go of.
#pragma once

#include <vector>

#include "tree/block.h"

namespace firma {

struct UnsharedBlocks {
    std::vector<const Block*> before, after;  ///< in no order that means anything
};

/// Opens only what differs, so for trees a few edits apart the cost follows the edits.
/// @param before, after  null: a tree without blocks
UnsharedBlocks unshared_blocks(const Block* before, const Block* after);

}  // namespace firma

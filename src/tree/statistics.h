// SPDX-License-Identifier: MIT
// What a tree came to.
#pragma once

#include "firma/tree_options.h"
#include "tree/block.h"

namespace firma {

/// Memory that a block itself takes; neither its children nor owners.
std::size_t bytes_of(const Block& block);

TreeStatistics tree_statistics(const Block& root);

}  // namespace firma

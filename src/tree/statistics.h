// SPDX-License-Identifier: MIT
// What a tree came to.
#pragma once

#include "firma/tree_options.h"
#include "tree/block.h"

namespace firma {

TreeStatistics tree_statistics(const Block& root);

}  // namespace firma

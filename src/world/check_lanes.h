// SPDX-License-Identifier: MIT
// Whether wide nodes and lanes, which queries read, show what nodes and blocks hold.
#pragma once

#include <optional>

#include "firma/world.h"
#include "index/node.h"
#include "solid/block.h"

namespace firma {

/// What is wrong with where a block keeps the corners of its faces. Where nothing is, they may be asked for.
std::optional<WorldFault> fault_of_corners(const Block& block);

/// @param node  of an index over faces, with wide nodes; its children's boxes, and its block's corners, are sound
/// @return what is wrong with its wide nodes or its depth, or with the lanes of its block
std::optional<WorldFault> fault_of_wide_nodes(const Node& node);

}  // namespace firma

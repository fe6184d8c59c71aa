// SPDX-License-Identifier: MIT
// Whether wide nodes and lanes, which queries read, show what nodes and blocks hold.
#pragma once

#include <optional>

#include "firma/world.h"
#include "index/node.h"

namespace firma {

/// @param node  of an index over faces, with wide nodes; its children's boxes, and the faces of its block, are sound
/// @return what is wrong with its wide nodes or its depth, or with the lanes of its block
std::optional<WorldFault> fault_of_wide_nodes(const Node& node);

}  // namespace firma

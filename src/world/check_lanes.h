// SPDX-License-Identifier: MIT
// Whether casts, which read wide nodes and lanes, see what bins and blocks hold.
#pragma once

#include <optional>

#include "firma/world.h"
#include "index/node.h"

namespace firma {

/// @param node  of an index over faces; its bins, and the faces of its block, are sound
/// @return what is wrong with its wide nodes, or with the lanes of its block
std::optional<WorldFault> fault_of_lanes(const Node& node);

}  // namespace firma

// SPDX-License-Identifier: MIT
// How far faces reach.
#pragma once

#include "firma/vec.h"
#include "index/node.h"

namespace firma {

/// Around all faces of an index, exactly, by the boxes that may reach farthest: costs a few walks.
Box bounds_of(const Node& root);

}  // namespace firma

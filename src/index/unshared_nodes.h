// SPDX-License-Identifier: MIT
// The nodes that only one of two sets of indices has: what an edit made, and what it let go of.
#pragma once

#include <span>
#include <vector>

#include "index/node.h"

namespace firma {

struct UnsharedNodes {
    std::vector<const Node*> before, after;  ///< in no order that means anything
};

/// Opens only what differs, so for indices a few edits apart the cost follows the edits.
/// @param before, after  roots, in any order; what both have may be left out
UnsharedNodes unshared_nodes(std::span<const Node* const> before, std::span<const Node* const> after);

}  // namespace firma

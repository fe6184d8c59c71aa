// SPDX-License-Identifier: MIT
// What an index came to.
#pragma once

#include "firma/tree_options.h"
#include "index/node.h"

namespace firma {

/// Memory that a node itself takes; neither its children nor its facets.
std::size_t bytes_of(const Node& node);

/// `bytes` are those of the facets too, without what blocks share with others.
TreeStatistics tree_statistics(const Node& root);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Whether two boundaries are the same set of points, and look the same way, however they are divided into faces.
#pragma once

#include "index/node.h"

namespace firma {

/// Exact. Looks only at blocks that one of them has alone.
/// @param a, b  roots of indices over the faces of solids; null for none
bool same_boundary(const Node* a, const Node* b);

}  // namespace firma

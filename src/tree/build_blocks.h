// SPDX-License-Identifier: MIT
// From faces to a tree of blocks.
#pragma once

#include "base/ref.h"
#include "firma/tree_options.h"
#include "tree/block.h"
#include "tree/face_set.h"

namespace firma {

/// The deepest a tree may be, bins above a leaf: rules stop at 64, and what is left is halved by count.
inline constexpr int kDeepestTree = 64 + 32;

/// @return the root; null for no faces
Ref<const Block> build_blocks(const FaceSet& faces, const TreeOptions& options);

}  // namespace firma

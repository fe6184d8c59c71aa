// SPDX-License-Identifier: MIT
// A leaf of an index over faces, as it is read: wide nodes over its block, and the block's lanes for casts.
#pragma once

#include <cstdint>
#include <vector>

#include "index/node.h"
#include "index/widen_bins.h"
#include "solid/block.h"
#include "solid/face_set.h"

namespace firma {

/// Keeps its scratch memory from call to call.
class FaceLayout {
public:
    /// Fills Node::wide, box and depth, Block::lanes, and where faces have their corners there.
    /// @param block  of the faces below a bin, in their order there; it gets no others
    /// @param faces  what the tree's items are
    /// @param top    the bin
    void make(Node& leaf, Block& block, const FaceSet& faces, const BinTree& tree, std::uint32_t top);

private:
    BinWidener widener_;
    std::vector<FaceLanes> scratch_;
};

}  // namespace firma

// SPDX-License-Identifier: MIT
// A leaf of an index over faces, as it is read: wide nodes over its block, and the block's lanes for casts.
#pragma once

#include <cstdint>
#include <vector>

#include "index/node.h"
#include "index/widen_bins.h"
#include "solid/block.h"

namespace firma {

/// Keeps its scratch memory from call to call.
class FaceLayout {
public:
    /// Fills Node::wide, box and depth, and Block::lanes; of these nothing where Firma is compiled without lanes
    /// (FIRMA_SIMD).
    /// @param block  of the faces below a bin, in their order there; it gets no others
    /// @param top    the bin
    void make(Node& leaf, Block& block, const BinTree& tree, std::uint32_t top);

private:
    BinWidener widener_;
    std::vector<FaceLanes> scratch_;
};

}  // namespace firma

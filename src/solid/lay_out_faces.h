// SPDX-License-Identifier: MIT
// The layout for casts of a leaf of an index over faces: lanes of its block, and wide nodes over them.
#pragma once

#include <vector>

#include "index/node.h"
#include "index/widen.h"
#include "solid/block.h"

namespace firma {

/// Keeps its scratch memory from call to call.
class FaceLayout {
public:
    /// Fills Block::lanes and Node::wide; where Firma is compiled without lanes (FIRMA_SIMD), nothing.
    /// @param leaf  with its bins, over this block
    void make(Node& leaf, Block& block);

private:
    std::uint32_t lanes_below(const Node& leaf, std::uint32_t bin) const;
    std::uint32_t put(const Node& leaf, std::uint32_t bin);

    BinWidener widener_;
    std::vector<std::uint32_t> before_;  ///< triangles of facets before each one
    std::vector<std::uint32_t> last_;    ///< of each bin: the facet after its last one
    std::vector<FaceLanes> lanes_;
    std::vector<std::uint32_t> first_;  ///< of lanes_, by item
    const Block* block_ = nullptr;
};

}  // namespace firma

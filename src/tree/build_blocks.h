// SPDX-License-Identifier: MIT
// From faces to a tree of blocks.
#pragma once

#include <vector>

#include "base/ref.h"
#include "firma/tree_options.h"
#include "tree/block.h"
#include "tree/divide_bins.h"
#include "tree/face_set.h"
#include "tree/vertex_table.h"

namespace firma {

/// The deepest a tree may be, bins above a leaf: rules stop at 64, and what is left is halved by count.
inline constexpr int kDeepestTree = 64 + 32;

/// @param faces  at most 2^31
/// @return the root; null for no faces
Ref<const Block> build_blocks(const FaceSet& faces, const TreeOptions& options);

/// The same, keeping its scratch memory from call to call: for edits, which build many small trees.
class BlockBuilder {
public:
    /// @param depth  bins above the root, for the depth rule
    /// @return the root; null for no faces
    Ref<const Block> build(const FaceSet& faces, const TreeOptions& options, int depth = 0);

private:
    Ref<const Block> pack(std::uint32_t top);
    Ref<const Block> pack_faces(std::uint32_t top);
    Ref<const Block> pack_blocks(std::uint32_t top);
    void add_face(Block& block, const FaceSet::Entry& face);

    const FaceSet* faces_ = nullptr;
    BinTree tree_;
    std::vector<Bin> bins_;
    VertexTable vertices_;
};

}  // namespace firma

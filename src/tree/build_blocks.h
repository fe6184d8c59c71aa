// SPDX-License-Identifier: MIT
// From faces to a tree of blocks.
#pragma once

#include <span>
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

    /// Divides blocks as faces are divided, by surface area and whatever the stop rules, down to single ones; for the
    /// calls that follow.
    void divide(std::span<const Ref<const Block>> blocks);

    /// One block over all of the blocks divided, at most 64.
    Ref<const Block> join(std::span<const Ref<const Block>> blocks);

    /// A group of blocks below one bin of the division.
    struct Group {
        std::size_t end = 0;    ///< in the order that group() gives
        std::uint32_t bin = 0;  ///< for join_group()
    };
    /// The largest groups that the division makes of at most so many blocks and faces; a block alone is always one.
    /// @param order   the blocks' indices, group after group
    void group(std::span<const Ref<const Block>> blocks, std::size_t most_blocks, std::size_t most_faces,
               std::vector<std::uint32_t>& order, std::vector<Group>& groups) const;

    /// What dividing a group by itself and joining it would give, from the division that it is part of.
    /// @param blocks  all that were divided
    /// @return null where the two could differ: blocks that were halved by their order
    Ref<const Block> join_group(std::span<const Ref<const Block>> blocks, const Group& group);

private:
    Ref<const Block> join_below(std::uint32_t top, std::span<const Ref<const Block>> blocks);
    Ref<const Block> pack(std::uint32_t top);
    Ref<const Block> pack_faces(std::uint32_t top);
    Ref<const Block> pack_blocks(std::uint32_t top);
    void add_face(Block& block, const FaceSet::Entry& face);

    const FaceSet* faces_ = nullptr;
    BinTree tree_;
    std::vector<std::uint32_t> halved_;  ///< nodes that divide() halved by the order of their blocks, ascending
    std::vector<Bin> bins_;
    VertexTable vertices_;
};

}  // namespace firma

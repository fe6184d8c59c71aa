// SPDX-License-Identifier: MIT
// Changing a tree: some faces go, others come; blocks that are not touched are shared with the tree before.
//
// The rules are those of a B-tree over bins. A face that comes goes down the tree before the edit, at each bin to the
// child that has to grow least. Each leaf block that faces left or came to is built anew from what it then holds; one
// of more than 64 faces becomes several. Then, from the bottom up, each block above: bins over its children are split
// anew, one of more than 64 children becomes several, one of few, or of nothing but leaf blocks, hands its children to
// the block above, and small blocks side by side become one. So the work follows the change, not the tree.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/ref.h"
#include "firma/tree_options.h"
#include "tree/block.h"
#include "tree/build_blocks.h"
#include "tree/face_set.h"
#include "tree/join_blocks.h"

namespace firma {

/// One change to a tree: faces that go, faces that come. The tree before stays as it is. The result depends on the tree
/// before, on what was removed, and on what was added in which order, and on nothing else.
class BlockEdit {
public:
    /// @param root  null for a tree without faces
    BlockEdit(Ref<const Block> root, const TreeOptions& options);

    /// A face of the tree as it was given. Twice is once.
    void remove(const Block* leaf, std::uint32_t slot);
    /// Faces that come, ids and owners set.
    void add(FaceSet&& faces);

    /// Does one piece of work, about a block rebuilt (some 10 us): all changes must be in.
    /// @return whether there is more to do
    bool step();

    /// Once step() said false. Null when no face is left.
    Ref<const Block> result() const { return result_; }

private:
    /// A block before the edit that will be replaced. Parents stand before their children.
    struct Touched {
        const Block* block = nullptr;
        std::uint32_t item = 0;  ///< of its parent
        int depth = 0;           ///< bins above its root
        std::uint32_t first_child = kNone, next_sibling = kNone;
        std::uint32_t first_piece = 0, pieces = 0;  ///< what takes its place
        /// Leaf blocks side by side are rebuilt together, by the first; the next one, and whether this is not the
        /// first.
        std::uint32_t next_together = kNone;
        bool follows = false;
    };
    static constexpr std::uint32_t kNone = ~0u;
    struct Change {
        std::uint32_t leaf;   ///< touched
        std::uint32_t index;  ///< slot of a face that goes, or face of `added_`
        friend auto operator<=>(const Change&, const Change&) = default;
    };
    enum class Phase { kFind, kPlace, kRebuild, kDone };

    void find_some();
    void place_some();
    void gather_leaves();
    void rebuild_one();
    void finish();

    std::uint32_t touch(std::uint32_t parent, std::uint32_t item, int depth);
    std::uint32_t find_leaf(const Block* leaf, const GridBox& box);
    std::uint32_t place(const GridBox& box);

    void rebuild_leaves(std::uint32_t index);
    void append_changed(std::uint32_t index);
    void rebuild_inner(std::uint32_t index);
    void collect_items(const Touched& touched);
    void join_loose();
    void divide_items();
    void join_items(std::size_t fewest);
    Ref<const Block> from_scratch(const Block& block);
    BlockItem keep(Ref<const Block> block);

    const Ref<const Block> root_;
    const TreeOptions options_;
    std::vector<std::pair<const Block*, std::uint32_t>> removed_;
    FaceSet added_;

    Phase phase_ = Phase::kFind;
    std::size_t next_ = 0;  ///< in this phase
    std::vector<Touched> touched_;
    std::unordered_map<const Block*, std::uint32_t> leaves_;  ///< looked up only, never gone through
    std::vector<Change> goes_, comes_;                        ///< by leaf, once sorted
    std::vector<BlockItem> pieces_;
    std::vector<Ref<const Block>> made_;  ///< keeps alive what was made, needed in the end or not
    Ref<const Block> result_;

    BlockBuilder builder_;  // and scratch
    BlockJoiner joiner_;
    FaceSet faces_;
    std::vector<BlockItem> items_, loose_;  ///< of the block at hand; `loose_`: leaf blocks
    std::vector<std::uint32_t> touched_by_, nodes_;
};

}  // namespace firma

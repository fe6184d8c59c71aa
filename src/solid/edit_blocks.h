// SPDX-License-Identifier: MIT
// Changing which faces there are: blocks that lose faces go, new ones hold what is left of theirs and what is added.
//
// Blocks that go are put together with those near them, up to 32 of a part, and faces that are added with those
// that have to grow least for them; each such group is divided anew, down to blocks by surface area: edit by edit
// blocks would grow into each other otherwise. So the work follows the change, and blocks stay as full and as compact
// as those of a build.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "base/ref.h"
#include "firma/tree_options.h"
#include "index/join_nodes.h"
#include "solid/block.h"
#include "solid/build_blocks.h"
#include "solid/face_set.h"

namespace firma {

/// One change to a set of blocks. The blocks before stay as they are.
class BlockEdit {
public:
    explicit BlockEdit(const TreeOptions& options);

    /// A face that goes. Twice is once. The block must live until the end.
    void remove(const FacetPlace& facet);
    /// Faces that are added: ids, parts and owners set. Once.
    void add(FaceSet&& faces);

    /// Does one piece of work, some 10 us: all changes must be in.
    /// @return whether there is more to do
    bool step();

    /// Once step() said false: the blocks that go, by id of their first faces, and leaf nodes over those that come.
    const std::vector<const Block*>& removed() const { return blocks_; }
    const std::vector<Ref<const Node>>& added() const { return made_; }

private:
    static constexpr std::uint32_t kNone = ~0u;
    struct Change {
        std::uint32_t place;  ///< block that goes, or group
        std::uint32_t index;  ///< slot of a face that goes, or face of `added_`
        friend auto operator<=>(const Change&, const Change&) = default;
    };
    /// Blocks and faces of one part that are divided together.
    struct Group {
        std::uint32_t part = 0;
        std::vector<std::uint32_t> blocks;
    };
    /// The blocks of one part that go, divided until few are left together: a binary tree of boxes.
    struct PartTree {
        std::uint32_t part = 0;
        struct Node {
            GridBox box;
            std::uint32_t left = kNone, right = kNone;  ///< none: a group
            std::uint32_t group = kNone;
        };
        std::vector<Node> nodes;
    };
    enum class Phase { kStart, kPlace, kRebuild, kDone };

    void start();
    void sort_blocks();
    void group_blocks(std::uint32_t part, const std::vector<std::uint32_t>& blocks);
    std::uint32_t group_below(PartTree& tree, const std::vector<std::uint32_t>& blocks, std::uint32_t node);
    void place_some();
    std::uint32_t place(const FaceSet::Entry& face);
    void rebuild_one();

    TreeOptions options_;
    std::vector<const Block*> blocks_;  ///< that go
    FlatMap number_of_;                 ///< of each of them, by address
    std::vector<Change> goes_, comes_;  ///< by block, by group; sorted
    FaceSet added_;

    Phase phase_ = Phase::kStart;
    std::size_t next_ = 0;  ///< in this phase
    std::vector<Group> groups_;
    std::vector<PartTree> trees_;
    FlatMap tree_of_part_;
    std::vector<Ref<const Node>> made_;

    BlockBuilder builder_;  // and scratch
    NodeJoiner joiner_;
    FaceSet faces_;
};

}  // namespace firma

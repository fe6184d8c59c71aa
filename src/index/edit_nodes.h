// SPDX-License-Identifier: MIT
// Changing an index: some leaves are removed, others added; nodes that are not touched are shared with the index
// before.
//
// The rules are those of a B-tree over boxes. A leaf that is added goes down the index before the edit, at each node to
// the child that has to grow least, to a node above leaves. Each node above a change is made anew, from the bottom up:
// its children are divided anew, one of more than 64 children becomes several, one of few, or of nothing but leaves,
// hands its children to the node above. So the work follows the change, not the index.
//
// Nodes over leaves grow into each other, edit by edit. So beside those that a change touches one more is divided anew
// with them, the one that covers the largest share of one of them; and a second one that covers much.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/ref.h"
#include "index/join_nodes.h"
#include "index/node.h"

namespace firma {

/// One change to an index. The index before stays as it is.
class NodeEdit {
public:
    /// @param root  null for an index over nothing
    explicit NodeEdit(Ref<const Node> root) : root_(std::move(root)) {}

    /// A leaf over these facets, which the index has.
    /// @param box  around some of them
    void remove(const IndexedFacets* facets, const GridBox& box) { removed_.push_back({facets, box}); }
    void add(Ref<const Node> leaf) { added_.push_back(std::move(leaf)); }

    /// Does one piece of work, some 10 us: all changes must be in.
    /// @return whether there is more to do
    bool step();

    /// Once step() said false. Null when no leaf is left.
    Ref<const Node> result() const { return result_; }

private:
    /// A node before the edit that will be replaced, or a leaf that goes. Parents stand before their children.
    struct Touched {
        const Node* node = nullptr;
        std::uint32_t item = 0;  ///< of its parent
        std::uint32_t first_child = kNone, next_sibling = kNone;
        std::uint32_t first_piece = 0, pieces = 0;  ///< what takes its place
        std::uint32_t first_added = kNone;          ///< leaf that comes below it: a chain in `next_added_`
    };
    struct Removed {
        const IndexedFacets* facets;
        GridBox box;
    };
    static constexpr std::uint32_t kNone = ~0u;
    enum class Phase { kFind, kPlace, kRebuild, kDone };

    void find_some();
    void place_some();
    void rebuild_one();
    void finish();
    void start_over_leaf();

    std::uint32_t touch(std::uint32_t parent, std::uint32_t item);
    bool find_leaf(const Removed& removed);
    std::uint32_t place(const GridBox& box);

    void touch_beside();
    std::uint32_t find_beside(std::uint32_t parent, double least);

    void rebuild_inner(std::uint32_t index);
    void collect_items(const Touched& touched);
    void join_loose();
    void join_items(std::size_t fewest);
    Ref<const Node> over_leaves(const Ref<const Node>& node);
    NodeItem keep(Ref<const Node> node);

    const Ref<const Node> root_;
    std::vector<Removed> removed_;
    std::vector<Ref<const Node>> added_;
    std::vector<std::uint32_t> next_added_;

    Phase phase_ = Phase::kFind;
    std::size_t next_ = 0;  ///< in this phase
    std::vector<Touched> touched_;
    std::vector<NodeItem> pieces_;
    std::vector<Ref<const Node>> made_;  ///< keeps alive what was made, needed in the end or not
    Ref<const Node> result_;

    NodeJoiner joiner_;                    // and scratch
    std::vector<NodeItem> items_, loose_;  ///< of the node at hand; `loose_`: leaves
    std::vector<std::uint32_t> touched_by_, groups_;
};

}  // namespace firma

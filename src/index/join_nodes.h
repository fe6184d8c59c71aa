// SPDX-License-Identifier: MIT
// From nodes to nodes over them: how an index is put together from leaves, and how an edit puts what it made and what
// it left alone together again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/ref.h"
#include "index/divide_bins.h"
#include "index/node.h"
#include "index/widen_bins.h"

namespace firma {

/// A node that is to have another one above it. Whoever makes it keeps the node alive.
struct NodeItem {
    const Node* node = nullptr;
    GridBox box;           ///< Node::box
    bool is_leaf = false;  ///< Node::is_leaf()

    static NodeItem of(const Node& node) { return {&node, node.box, node.is_leaf()}; }
};

/// Keeps its scratch memory from call to call.
class NodeJoiner {
public:
    /// Divides items as facets are divided, by surface area and whatever the stop rules, until two or fewer are left
    /// together; for the calls that follow. Node 0 is the root.
    void divide(std::span<const NodeItem> items);

    /// The largest nodes of at most so many items each, two or more.
    void group(std::size_t max_items, std::vector<std::uint32_t>& nodes);

    /// How many items are below a node; after group().
    std::size_t count_below(std::uint32_t node) const { return sums_[node]; }
    /// Calls `function(item)`, left to right.
    template <class Function>
    void for_each_below(std::uint32_t node, const Function& function) const {
        if (is_leaf(node)) {
            for (const BuildItem& item : tree_.items_of(tree_.nodes[node])) function(item.face);
            return;
        }
        for_each_below(tree_.nodes[node].left, function);
        for_each_below(tree_.nodes[node].right, function);
    }
    /// The division itself: its nodes' boxes are those of the items below.
    const BinTree& tree() const { return tree_; }

    /// One node over all items below a node, at most 64; after group().
    Ref<const Node> join(std::span<const NodeItem> items, std::uint32_t node);

private:
    bool is_leaf(std::uint32_t node) const { return tree_.nodes[node].left == 0; }

    BinTree tree_;
    std::vector<std::uint32_t> sums_;
    BinWidener widener_;
};

/// One node over all of these, or the only one; null for none. The nodes between them hold up to 64 each. What would be
/// deeper than kDeepestTree is made anew from its leaves.
Ref<const Node> join_nodes(std::span<const Ref<const Node>> nodes);

/// The same for a few that lie in the same place: as far as one node has room for what they hold, it holds that instead
/// of them, which saves a cast the way through both.
Ref<const Node> join_opened(std::span<const Ref<const Node>> nodes);

}  // namespace firma

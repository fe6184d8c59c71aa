// SPDX-License-Identifier: MIT
// From nodes to nodes over them.
#include "index/join_nodes.h"

#include <algorithm>

#include "base/assert.h"
#include "index/traverse.h"

namespace firma {

// By surface area also where facets are split otherwise: leaves that edits made overlap more than bins do, and a
// traversal pays for overlap here more than anywhere.
void NodeJoiner::divide(std::span<const NodeItem> nodes) {
    constexpr std::size_t kTogether = 2;  // nothing to choose
    constexpr int kUnevenLevels = 12;  // then in halves: what the rule peels off one by one must not make a deep index
    tree_.items.resize(nodes.size());
    tree_.nodes.clear();
    for (std::uint32_t k = 0; k < nodes.size(); ++k) tree_.items[k] = {nodes[k].box, k};
    divide_bins(tree_.items, tree_.nodes, 0, std::uint32_t(nodes.size()), 0,
                [&](std::span<BuildItem> items, const GridBox& box, int depth) -> std::size_t {
                    if (items.size() <= kTogether) return 0;
                    const std::size_t left = depth < kUnevenLevels ? split_by_area(items, box) : 0;
                    return left != 0 ? left : split_by_count(items);
                });
}

void NodeJoiner::group(std::size_t max_items, std::vector<std::uint32_t>& nodes) {
    sums_.resize(tree_.nodes.size());
    for (auto n = std::uint32_t(tree_.nodes.size()); n-- > 0;)  // children stand after their parents
        sums_[n] = is_leaf(n) ? tree_.nodes[n].count : sums_[tree_.nodes[n].left] + sums_[tree_.nodes[n].right];
    nodes.clear();
    const auto below = [&](const auto& self, std::uint32_t n) -> void {
        if (sums_[n] <= max_items) return nodes.push_back(n);
        self(self, tree_.nodes[n].left);
        self(self, tree_.nodes[n].right);
    };
    below(below, 0);
}

Ref<const Node> NodeJoiner::join(std::span<const NodeItem> items, std::uint32_t root) {
    Ref<Node> made(new Node);
    made->children.reserve(sums_[root]);
    const auto node_of = [&](std::uint32_t place) { return items[tree_.items[place].face].node; };
    widener_.widen_over_nodes(*made, tree_, root, node_of);
    return Ref<const Node>(made.get());
}

Ref<const Node> join_nodes(std::span<const Ref<const Node>> nodes) {
    std::vector<Ref<const Node>> all(nodes.begin(), nodes.end()), above;
    std::vector<NodeItem> items;
    std::vector<std::uint32_t> groups;
    NodeJoiner joiner;
    while (all.size() > 1) {
        items.clear();
        for (const Ref<const Node>& node : all) items.push_back(NodeItem::of(*node));
        joiner.divide(items);
        joiner.group(kNodeItems, groups);
        above.clear();
        for (const std::uint32_t group : groups) {
            if (joiner.count_below(group) > 1)
                above.push_back(joiner.join(items, group));
            else
                joiner.for_each_below(group, [&](std::uint32_t item) { above.push_back(all[item]); });
        }
        // Every level but the last has fewer: where boxes make groups of one each, 64 and more are halved by count.
        all.swap(above);
    }
    if (all.empty()) return {};
    if (all[0]->depth <= kDeepestTree) return all[0];
    std::vector<Ref<const Node>> leaves;
    for_each_leaf(all[0], [&](const Ref<const Node>& leaf) { leaves.push_back(leaf); });
    FIRMA_ASSERT(leaves.size() > nodes.size(), "an index over leaves is never so deep");
    return join_nodes(leaves);
}

Ref<const Node> join_opened(std::span<const Ref<const Node>> nodes) {
    if (nodes.size() < 2) return join_nodes(nodes);
    std::vector<Ref<const Node>> opened;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const PoolVector<Ref<const Node>>& children = nodes[k]->children;
        const std::size_t others = nodes.size() - k - 1;
        if (nodes[k]->is_leaf() || opened.size() + children.size() + others > kNodeItems)
            opened.push_back(nodes[k]);
        else
            opened.insert(opened.end(), children.begin(), children.end());
    }
    return join_nodes(opened);
}

}  // namespace firma

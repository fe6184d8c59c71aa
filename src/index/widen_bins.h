// SPDX-License-Identifier: MIT
// From a binary tree of bins to wide nodes over the same items: those whose surfaces together are least, as a large one
// is met often.
//
// Source: H. Ylitie, T. Karras, S. Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs,
// 2017, section 3.2.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/ref.h"
#include "index/divide_bins.h"
#include "index/node.h"
#include "index/wide_node.h"

namespace firma {

/// Keeps its scratch memory from call to call.
class BinWidener {
public:
    /// What a lane is to lead to, left to right.
    struct Item {
        std::uint32_t what;         ///< a bin; or an item of the tree, by its place; or a part that a node is made of
        std::uint32_t above, lane;  ///< the wide node's number, and its lane
        std::uint32_t depth;        ///< wide nodes from the first one down to it
        bool is_part;               ///< only of nodes over a whole tree
    };

    /// A node over all bins of a tree below one. Fills Node::wide and Node::box, and Node::depth as if there were
    /// nothing below the items: those are the bins that are not divided, each as many of the Node's items as it holds.
    /// Lanes to items lead nowhere yet.
    std::span<const Item> widen(Node& node, const BinTree& tree, std::uint32_t top);

    /// A node over other nodes, whole: over the items of a tree below a bin. Bins that are not divided hold eight at
    /// most.
    /// @param node_of  (place of an item) the node that it stands for, which the caller keeps alive
    template <class NodeOf>
    void widen_over_nodes(Node& node, const BinTree& tree, std::uint32_t top, const NodeOf& node_of) {
        for (const Item& item : widen_items(node, tree, top)) hang(node, item, node_of(item.what));
    }

    /// Nodes over a whole tree: its wide nodes are chosen together, then each node takes two of them above each other,
    /// counted from below, so that no border between nodes costs a cast one more.
    /// @param leaf_of  (index of bin) the node over one of kNodeItems items at most
    template <class LeafOf>
    Ref<const Node> widen_all(const BinTree& tree, const LeafOf& leaf_of) {
        if (tree.nodes[0].count <= kNodeItems) return leaf_of(0);
        return make_node(tree, choose_all(tree), leaf_of);
    }

private:
    static constexpr std::uint32_t kLanes = WideNode::kLanes;
    /// So many wide nodes are above each other as is best; deeper ones have as many lanes as they can, so that 64 items
    /// never make a deep index.
    static constexpr std::uint32_t kFreeDepth = 4;

    /// A bin, and what its share of the wide nodes comes to if it is spread over 1 to 8 lanes of the one above it.
    struct Part {
        const BinNode* bin = nullptr;
        std::uint32_t what = 0;
        bool is_item = false;
        std::uint16_t height = 0;              ///< wide nodes above each other, its own and below; of widen_all()
        std::uint32_t left = 0, right = 0;     ///< parts; 0: not divided
        float surface[kLanes] = {};            ///< by lanes less one, of the wide nodes below: of its own for one lane
        std::uint8_t left_lanes[kLanes] = {};  ///< how many of them its left part has; 0: as with one lane less
    };
    /// What a lane of the wide node at hand leads to.
    struct Lane {
        enum Kind : std::uint8_t { kPart, kBinItem, kTreeItem };
        const GridBox* box;
        std::uint32_t what;  ///< a part, a bin, or an item of the tree
        Kind kind;
    };
    struct Lanes {
        Lane lanes[kLanes];
        std::uint32_t count = 0;

        void add(const Lane& lane) { lanes[count++] = lane; }
    };
    struct Link {
        std::uint32_t above, lane, number;
    };

    /// Which bins are items.
    struct Rule {
        std::uint32_t up_to;  ///< those that hold so many
        bool undivided;       ///< those that are not divided; else these are opened into the tree's items
    };

    std::uint32_t add_part(const BinTree& tree, std::uint32_t bin, const Rule& rule);
    void choose_lanes(Part& part) const;
    static void add_tree_items(const BinTree& tree, const Part& part, Lanes& into);
    void spread(const BinTree& tree, std::uint32_t index, std::uint32_t lanes, Lanes& into) const;
    Lanes lanes_of(const BinTree& tree, std::uint32_t index, std::uint32_t depth) const;
    bool open_one(const BinTree& tree, Lanes& found) const;

    std::span<const Item> widen_items(Node& node, const BinTree& tree, std::uint32_t top);
    std::uint32_t choose_all(const BinTree& tree);
    std::uint16_t measure(const BinTree& tree, std::uint32_t index);
    bool starts_node(const Part& part, std::uint32_t depth) const;

    void fill(Node& node, const BinTree& tree, std::uint32_t index, bool bins_are_one_item);
    void put(const BinTree& tree, std::uint32_t index, std::uint32_t depth, bool bins_are_one_item);
    static void hang(Node& node, const Item& item, const Node* child);

    template <class LeafOf>
    Ref<const Node> make_node(const BinTree& tree, std::uint32_t index, const LeafOf& leaf_of) {
        Ref<Node> node(new Node);
        fill(*node, tree, index, true);
        const std::vector<Item> items = items_;
        node->children.reserve(items.size());
        for (const Item& item : items) {
            const Ref<const Node> child =
                item.is_part ? make_node(tree, item.what, leaf_of) : Ref<const Node>(leaf_of(item.what));
            hang(*node, item, child.get());
        }
        return Ref<const Node>(node.get());
    }

    std::vector<Part> parts_;
    std::vector<WideNode> wide_;
    std::vector<LaneItems> lane_items_;
    std::vector<Link> links_;
    std::vector<Item> items_;
    std::uint32_t next_item_ = 0;
};

}  // namespace firma

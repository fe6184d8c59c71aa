// SPDX-License-Identifier: MIT
// From a binary tree of bins to the wide nodes of a Node over the same items: those whose surfaces together are least,
// as a large one is met often.
//
// Source: H. Ylitie, T. Karras, S. Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs,
// 2017, section 3.2.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

#include "index/box_growth.h"
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
        bool is_part;               ///< only in widen_all()
    };

    /// Fills Node::wide and Node::box, and Node::depth as if there were nothing below the items. Lanes to items have
    /// neither `child` nor `facets` yet.
    /// @param is_item   (index of bin) whether it is an item; asked of no bin below one. A bin that is not divided, and
    ///                  not an item, is opened into the tree's items in it, eight at most: then these are items
    /// @param items_of  (index of bin that is an item) how many of the Node's items it holds
    template <class IsItem, class ItemsOf>
    std::span<const Item> widen(Node& node, const BinTree& tree, std::uint32_t top, const IsItem& is_item,
                                const ItemsOf& items_of) {
        parts_.clear();
        fill(node, tree, add_part(tree, top, is_item), items_of);
        return items_;
    }

    /// The same, and all else of a node over nodes.
    /// @param node_of  (Item::what) the node that it stands for, which the caller keeps alive
    template <class IsItem, class NodeOf>
    void widen_over_nodes(Node& node, const BinTree& tree, std::uint32_t top, const IsItem& is_item,
                          const NodeOf& node_of) {
        for (const Item& item : widen(node, tree, top, is_item, one_item)) hang(node, item, node_of(item.what));
    }

    /// Nodes over a whole tree: its wide nodes are chosen together, then each node takes two of them above each other,
    /// counted from below, so that no border between nodes costs a cast one more.
    /// @param is_item  as above; true for every bin that is not divided
    /// @param leaf_of  (index of bin that is an item) a node
    template <class IsItem, class LeafOf>
    Ref<const Node> widen_all(const BinTree& tree, const IsItem& is_item, const LeafOf& leaf_of) {
        if (is_item(0)) return leaf_of(0);
        parts_.clear();
        const std::uint32_t top = add_part(tree, 0, is_item);
        measure(tree, top);
        return make_node(tree, top, leaf_of);
    }

private:
    static constexpr std::uint32_t kLanes = WideNode::kLanes;
    /// So many wide nodes are above each other as is best; deeper ones have as many lanes as they can, so that 64 items
    /// never make a deep index.
    static constexpr std::uint32_t kFreeDepth = 4;

    /// A bin, and what its share of the wide nodes comes to if it is spread over 1 to 8 lanes of the one above it.
    struct Part {
        const BinNode* bin;
        std::uint32_t what;
        bool is_item;
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

    template <class IsItem>
    std::uint32_t add_part(const BinTree& tree, std::uint32_t bin, const IsItem& is_item) {
        const auto index = std::uint32_t(parts_.size());
        const BinNode& node = tree.nodes[bin];
        parts_.push_back({&node, bin, is_item(bin)});
        if (parts_[index].is_item) return index;
        if (node.left == 0) {
            for (std::uint32_t lanes = 1; lanes < node.count; ++lanes)
                parts_[index].surface[lanes - 1] = float(half_area(node.box));
            return index;
        }
        const std::uint32_t left = add_part(tree, node.left, is_item), right = add_part(tree, node.right, is_item);
        parts_[index].left = left;
        parts_[index].right = right;
        choose_lanes(parts_[index]);
        return index;
    }

    /// From what is best for its two parts.
    void choose_lanes(Part& part) {
        const Part &left = parts_[part.left], &right = parts_[part.right];
        float least[kLanes];
        for (std::uint32_t lanes = 2; lanes <= kLanes; ++lanes) {
            least[lanes - 1] = std::numeric_limits<float>::infinity();
            for (std::uint32_t k = 1; k < lanes; ++k) {
                const float surface = left.surface[k - 1] + right.surface[lanes - k - 1];
                if (!(surface < least[lanes - 1])) continue;
                least[lanes - 1] = surface;
                part.left_lanes[lanes - 1] = std::uint8_t(k);
            }
        }
        part.left_lanes[0] = part.left_lanes[kLanes - 1];  // of a wide node of its own
        part.surface[0] = float(half_area(part.bin->box)) + least[kLanes - 1];
        for (std::uint32_t lanes = 2; lanes <= kLanes; ++lanes) {
            const bool fewer = part.surface[lanes - 2] < least[lanes - 1];
            part.surface[lanes - 1] = fewer ? part.surface[lanes - 2] : least[lanes - 1];
            if (fewer) part.left_lanes[lanes - 1] = 0;
        }
    }

    /// A part over so many lanes at most.
    void spread(const BinTree& tree, std::uint32_t index, std::uint32_t lanes, Lanes& into) const {
        const Part& part = parts_[index];
        while (lanes > 1 && part.left != 0 && part.left_lanes[lanes - 1] == 0) --lanes;
        if (part.is_item) return into.add({&part.bin->box, part.what, Lane::kBinItem});
        if (part.left == 0 && lanes >= part.bin->count) return add_tree_items(tree, part, into);
        if (part.left == 0 || lanes == 1) return into.add({&part.bin->box, index, Lane::kPart});
        spread(tree, part.left, part.left_lanes[lanes - 1], into);
        spread(tree, part.right, lanes - part.left_lanes[lanes - 1], into);
    }

    static void add_tree_items(const BinTree& tree, const Part& part, Lanes& into) {
        for (std::uint32_t k = part.bin->first; k < part.bin->first + part.bin->count; ++k)
            into.add({&tree.items[k].box, k, Lane::kTreeItem});
    }

    /// What the lanes of a part's own wide node lead to.
    Lanes lanes_of(const BinTree& tree, std::uint32_t index, std::uint32_t depth) const {
        Lanes found;
        const Part& part = parts_[index];
        if (part.is_item) {
            found.add({&part.bin->box, part.what, Lane::kBinItem});
        } else if (part.left == 0) {
            add_tree_items(tree, part, found);
        } else if (depth <= kFreeDepth) {
            spread(tree, part.left, part.left_lanes[0], found);
            spread(tree, part.right, kLanes - part.left_lanes[0], found);
        } else {
            found.add({&part.bin->box, index, Lane::kPart});
            while (open_one(tree, found)) {
            }
        }
        return found;
    }

    /// Opens the first of the lanes that can be opened.
    bool open_one(const BinTree& tree, Lanes& found) const {
        for (std::uint32_t k = 0; k < found.count; ++k) {
            if (found.lanes[k].kind != Lane::kPart) continue;
            const Part& part = parts_[found.lanes[k].what];
            Lanes opened;
            if (part.left == 0) {
                add_tree_items(tree, part, opened);
            } else {
                spread(tree, part.left, 1, opened);
                spread(tree, part.right, 1, opened);
            }
            if (found.count - 1 + opened.count > kLanes) continue;
            std::move_backward(found.lanes + k + 1, found.lanes + found.count,
                               found.lanes + found.count - 1 + opened.count);
            std::copy(opened.lanes, opened.lanes + opened.count, found.lanes + k);
            found.count += opened.count - 1;
            return true;
        }
        return false;
    }

    static std::uint32_t one_item(std::uint32_t) { return 1; }

    /// @return the part's height
    std::uint16_t measure(const BinTree& tree, std::uint32_t index) {
        const Lanes found = lanes_of(tree, index, 1);
        std::uint16_t below = 0;
        for (std::uint32_t k = 0; k < found.count; ++k)
            if (found.lanes[k].kind == Lane::kPart) below = std::max(below, measure(tree, found.lanes[k].what));
        return parts_[index].height = std::uint16_t(below + 1);
    }

    /// Whether a part that is met so deep in a node has a node of its own.
    bool starts_node(const Part& part, std::uint32_t depth) const {
        return part.height != 0 && (depth > 2 || part.height % 2 == 0);
    }

    template <class LeafOf>
    Ref<const Node> make_node(const BinTree& tree, std::uint32_t index, const LeafOf& leaf_of) {
        Ref<Node> node(new Node);
        fill(*node, tree, index, one_item);
        const std::vector<Item> items = items_;
        node->children.reserve(items.size());
        for (const Item& item : items) {
            const Ref<const Node> child =
                item.is_part ? make_node(tree, item.what, leaf_of) : Ref<const Node>(leaf_of(item.what));
            hang(*node, item, child.get());
        }
        return Ref<const Node>(node.get());
    }

    static void hang(Node& node, const Item& item, const Node* child) {
        node.wide[item.above].child[item.lane] = child->wide.data();
        node.children.emplace_back(child);
        node.facets_below += child->facets_below;
        node.depth = std::max(node.depth, std::uint16_t(item.depth + child->depth));
    }

    /// All of a node but what its items tell.
    template <class ItemsOf>
    void fill(Node& node, const BinTree& tree, std::uint32_t index, const ItemsOf& items_of) {
        wide_.clear();
        items_.clear();
        links_.clear();
        next_item_ = 0;
        node.box = parts_[index].bin->box;
        put(tree, index, 1, items_of);
        node.wide.assign(wide_.begin(), wide_.end());
        node.depth = 0;
        for (const Item& item : items_) node.depth = std::max(node.depth, std::uint16_t(item.depth));
        for (const Link& link : links_) node.wide[link.above].child[link.lane] = &node.wide[link.number];
    }

    template <class ItemsOf>
    void put(const BinTree& tree, std::uint32_t index, std::uint32_t depth, const ItemsOf& items_of) {
        const Lanes found = lanes_of(tree, index, depth);
        const auto number = std::uint32_t(wide_.size());
        const GridBox* boxes[kLanes];
        for (std::uint32_t k = 0; k < found.count; ++k) boxes[k] = found.lanes[k].box;
        set_boxes(wide_.emplace_back(), {boxes, found.count});
        for (std::uint32_t k = 0; k < found.count; ++k) {
            const Lane& lane = found.lanes[k];
            wide_[number].first[k] = std::uint8_t(next_item_);
            const bool is_part = lane.kind == Lane::kPart;
            if (is_part && !starts_node(parts_[lane.what], depth + 1)) {
                links_.push_back({number, k, std::uint32_t(wide_.size())});
                put(tree, lane.what, depth + 1, items_of);
                continue;
            }
            items_.push_back({lane.what, number, k, depth, is_part});
            next_item_ += lane.kind == Lane::kBinItem ? items_of(lane.what) : 1;
        }
        std::fill(wide_[number].first + found.count, std::end(wide_[number].first), std::uint8_t(next_item_));
    }

    std::vector<Part> parts_;
    std::vector<WideNode> wide_;
    std::vector<Link> links_;
    std::vector<Item> items_;
    std::uint32_t next_item_ = 0;
};

}  // namespace firma

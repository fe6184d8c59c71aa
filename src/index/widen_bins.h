// SPDX-License-Identifier: MIT
// From a binary tree of bins to the wide nodes of a Node over the same items.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
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
        std::uint32_t what;         ///< a bin; or an item of the tree, by its place
        std::uint32_t above, lane;  ///< the wide node's number, and its lane
        std::uint32_t depth;        ///< wide nodes from the first one down to it
    };

    /// Fills Node::wide and Node::box, and Node::depth as if there were nothing below the items. Each wide node takes
    /// the bins below one of them: the largest is opened until there are eight or all are items. Lanes to items have
    /// neither `child` nor `facets` yet.
    /// @param is_item   (index of bin) whether it is an item; asked of no bin below one. A bin that is not divided, and
    ///                  not an item, is opened into the tree's items in it, eight at most: then these are items
    /// @param items_of  (index of bin that is an item) how many of the Node's items it holds
    template <class IsItem, class ItemsOf>
    std::span<const Item> widen(Node& node, const BinTree& tree, std::uint32_t top, const IsItem& is_item,
                                const ItemsOf& items_of) {
        wide_.clear();
        items_.clear();
        links_.clear();
        next_item_ = 0;
        node.box = tree.nodes[top].box;
        put(tree, top, 1, is_item, items_of);
        node.wide.assign(wide_.begin(), wide_.end());
        node.depth = 0;
        for (const Item& item : items_) node.depth = std::max(node.depth, std::uint16_t(item.depth));
        for (const Link& link : links_) node.wide[link.above].child[link.lane] = &node.wide[link.number];
        return items_;
    }

    /// The same, and all else of a node over nodes.
    /// @param node_of  (Item::what) the node that it stands for, which the caller keeps alive
    template <class IsItem, class NodeOf>
    void widen_over_nodes(Node& node, const BinTree& tree, std::uint32_t top, const IsItem& is_item,
                          const NodeOf& node_of) {
        for (const Item& item : widen(node, tree, top, is_item, [](std::uint32_t) { return 1u; })) {
            const Node* child = node_of(item.what);
            node.wide[item.above].child[item.lane] = child->wide.data();
            node.children.emplace_back(child);
            node.facets_below += child->facets_below;
            node.depth = std::max(node.depth, std::uint16_t(item.depth + child->depth));
        }
    }

private:
    /// What a lane of the wide node at hand may become.
    struct Top {
        enum Kind : std::uint8_t { kBin, kBinItem, kTreeItem };
        const GridBox* box;
        std::uint32_t what;
        Kind kind;
        std::uint8_t opens_to;  ///< of a bin: how many take its place when it is opened
        double size;
        std::uint32_t count;  ///< items of the tree: of boxes in one place the fullest is opened

        bool goes_before(const Top& other) const {
            return size != other.size ? size > other.size : count > other.count;
        }
    };
    struct Link {
        std::uint32_t above, lane, number;
    };

    template <class IsItem>
    static Top top_of(const BinTree& tree, std::uint32_t bin, const IsItem& is_item) {
        const BinNode& node = tree.nodes[bin];
        if (is_item(bin)) return {&node.box, bin, Top::kBinItem, 0, 0, 0};
        const auto opens_to = std::uint8_t(node.left != 0 ? 2 : node.count);
        return {&node.box, bin, Top::kBin, opens_to, half_area(node.box), node.count};
    }

    template <class IsItem, class ItemsOf>
    void put(const BinTree& tree, std::uint32_t root, std::uint32_t depth, const IsItem& is_item,
             const ItemsOf& items_of) {
        Top tops[WideNode::kLanes] = {top_of(tree, root, is_item)};
        std::uint32_t count = 1;
        for (;;) {
            Top* largest = nullptr;
            for (std::uint32_t k = 0; k < count; ++k)
                if (tops[k].kind == Top::kBin && count - 1 + tops[k].opens_to <= WideNode::kLanes &&
                    (!largest || tops[k].goes_before(*largest)))
                    largest = &tops[k];
            if (!largest) break;
            const BinNode& opened = tree.nodes[largest->what];
            // In order: what takes its place stands where it stood.
            std::move_backward(largest + 1, tops + count, tops + count - 1 + largest->opens_to);
            count += largest->opens_to - 1u;
            if (opened.left != 0) {
                largest[0] = top_of(tree, opened.left, is_item);
                largest[1] = top_of(tree, opened.right, is_item);
            } else {
                for (std::uint32_t k = 0; k < opened.count; ++k)
                    largest[k] = {&tree.items[opened.first + k].box, opened.first + k, Top::kTreeItem, 0, 0, 0};
            }
        }
        const auto number = std::uint32_t(wide_.size());
        const GridBox* boxes[WideNode::kLanes];
        for (std::uint32_t k = 0; k < count; ++k) boxes[k] = tops[k].box;
        set_boxes(wide_.emplace_back(), {boxes, count});
        for (std::uint32_t k = 0; k < count; ++k) {
            wide_[number].first[k] = std::uint8_t(next_item_);
            if (tops[k].kind == Top::kBin) {
                links_.push_back({number, k, std::uint32_t(wide_.size())});
                put(tree, tops[k].what, depth + 1, is_item, items_of);
                continue;
            }
            items_.push_back({tops[k].what, number, k, depth});
            next_item_ += tops[k].kind == Top::kBinItem ? items_of(tops[k].what) : 1;
        }
        std::fill(wide_[number].first + count, std::end(wide_[number].first), std::uint8_t(next_item_));
    }

    std::vector<WideNode> wide_;
    std::vector<Link> links_;
    std::vector<Item> items_;
    std::uint32_t next_item_ = 0;
};

}  // namespace firma

// SPDX-License-Identifier: MIT
// From the bins of a node to wide nodes over the same items.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "index/node.h"
#include "index/wide_node.h"

namespace firma {

/// Keeps its scratch memory from call to call.
class BinWidener {
public:
    /// Fills Node::wide. Each wide node takes the bins below one of them: the largest is opened until there are eight
    /// or all are items.
    /// @param node  with its bins
    /// @param item  (index of bin) returns the number of an item that stands for all of it, or kNone for an inner bin
    ///              that is to be divided further. Asked of no bin below an item
    /// @param lead  (number of item, wide node, lane) puts the item there, once all have been asked for
    template <class Item, class Lead>
    void widen(Node& node, const Item& item, const Lead& lead) {
        nodes_.clear();
        children_.clear();
        put(node.bins, 0, item(0), item);
        node.wide.assign(nodes_.begin(), nodes_.end());
        for (const Child& it : children_) {
            WideNode& above = node.wide[it.above];
            above.facets[it.lane] = 0;
            if (it.item != kNone)
                lead(it.item, above, it.lane);
            else
                above.child[it.lane] = &node.wide[it.number];
        }
    }
    /// Of a node over nodes, where these are widened; else it stays without.
    void widen(Node& node);

    static constexpr std::uint32_t kNone = ~0u;

private:
    struct Top {
        std::uint32_t bin, item;
        double size;
    };
    struct Child {
        std::uint32_t above, lane, item, number;
    };

    /// Half the surface.
    static double size_of(const BoxF& box) {
        const double x = double(box.high[0]) - box.low[0], y = double(box.high[1]) - box.low[1],
                     z = double(box.high[2]) - box.low[2];
        return x * y + y * z + z * x;
    }

    template <class Item>
    std::uint32_t put(std::span<const Bin> bins, std::uint32_t root, std::uint32_t root_item, const Item& item) {
        Top tops[WideNode::kLanes] = {{root, root_item, 0}};
        std::uint32_t count = 1;
        while (count < WideNode::kLanes) {
            Top* largest = nullptr;
            for (std::uint32_t k = 0; k < count; ++k)
                if (tops[k].item == kNone && (!largest || tops[k].size > largest->size)) largest = &tops[k];
            if (!largest) break;
            const std::uint32_t left = largest->bin + 1, right = bins[largest->bin].first;
            // In order: the right one stands after the left one.
            Top* const end = tops + count++;
            std::move_backward(largest + 1, end, end + 1);
            largest[0] = {left, item(left), size_of(bins[left].box)};
            largest[1] = {right, item(right), size_of(bins[right].box)};
        }
        const auto number = std::uint32_t(nodes_.size());
        nodes_.emplace_back();
        BoxF boxes[WideNode::kLanes];
        for (std::uint32_t k = 0; k < count; ++k) boxes[k] = bins[tops[k].bin].box;
        set_boxes(nodes_[number], {boxes, count});
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t below = tops[k].item == kNone ? put(bins, tops[k].bin, kNone, item) : kNone;
            children_.push_back({number, k, tops[k].item, below});
        }
        return number;
    }

    std::vector<WideNode> nodes_;
    std::vector<Child> children_;
};

}  // namespace firma

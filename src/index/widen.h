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
    /// Each wide node takes the bins below one of them: the largest is opened until there are eight or all are items.
    /// @param bins  of one node; bins[0] is the root
    /// @param item  (index of bin) returns the number of an item that stands for all of it, below 2^31; or ~0 for an
    ///              inner bin that is to be divided further. Asked once for each bin that it is not asked above
    /// @return nodes[0] is the root; good until the next call
    template <class Item>
    std::span<const WideNode> widen(std::span<const Bin> bins, const Item& item) {
        nodes_.clear();
        put(bins, 0, item(0), item);
        return nodes_;
    }

private:
    static constexpr std::uint32_t kNone = ~0u;
    struct Top {
        std::uint32_t bin, item;
        double half_area;
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
                if (tops[k].item == kNone && (!largest || tops[k].half_area > largest->half_area)) largest = &tops[k];
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
            const std::uint32_t child =
                tops[k].item != kNone ? tops[k].item | WideNode::kItem : put(bins, tops[k].bin, kNone, item);
            nodes_[number].child[k] = child;
        }
        return number;
    }

    std::vector<WideNode> nodes_;
};

/// Of a node over nodes, whose bins are known: an item is the number of a child.
inline void widen_node(Node& node, BinWidener& widener) {
    const auto wide = widener.widen(node.bins, [&](std::uint32_t bin) {
        return node.bins[bin].is_leaf() ? node.bins[bin].first : ~0u;
    });
    node.wide.assign(wide.begin(), wide.end());
}

}  // namespace firma

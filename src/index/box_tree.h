// SPDX-License-Identifier: MIT
// A tree over boxes that stay as they are for the length of one job: which of them does a box meet, or a ray?
//
// Unlike the blocks of a world it is built in one piece, searched a few hundred times and thrown away, so it is made to
// be built quickly: about as long as a hundred searches take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "index/split_bin.h"

namespace firma {

/// Whether two closed boxes share a point.
inline bool boxes_meet(const GridBox& a, const GridBox& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

class BoxTree {
public:
    BoxTree() = default;
    /// @param boxes  none empty; numbered as they stand
    explicit BoxTree(std::span<const GridBox> boxes);

    std::size_t size() const { return items_.size(); }
    /// Memory beside the object itself.
    std::size_t bytes() const { return items_.capacity() * sizeof(Item) + nodes_.capacity() * sizeof(Node); }
    /// Around all; empty when there are none.
    GridBox box() const { return nodes_.empty() ? GridBox{} : nodes_[0].box; }

    /// The boxes as the tree has them: neighbours in this order are mostly neighbours in space.
    struct Item {
        GridBox box;
        std::uint32_t number = 0;
    };
    std::span<const Item> items() const { return items_; }

    /// Calls `function(number)` for each box that meets this one, until it returns true; in an order that depends on
    /// the boxes alone.
    /// @return whether `function` did
    template <class Function>
    bool for_each_meeting(const GridBox& box, const Function& function) const {
        return for_each_where([&](const GridBox& other) { return boxes_meet(box, other); }, function);
    }

    /// The same for whatever `meets(box)` says, which must be true of a box around another for which it is: a ray, a
    /// ball, a half space.
    template <class Meets, class Function>
    bool for_each_where(const Meets& meets, const Function& function) const {
        std::uint32_t waiting[kDeepest + 1];
        int count = 0;
        if (!nodes_.empty()) waiting[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = waiting[--count];
            const Node& node = nodes_[at];
            if (!meets(node.box)) continue;
            if (node.count == 0) {
                waiting[count++] = node.first;
                waiting[count++] = at + 1;
                continue;
            }
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
                if (meets(items_[k].box) && function(items_[k].number)) return true;
        }
        return false;
    }

private:
    /// Below this depth bins are halved by count, so 2^32 boxes stay within kDeepest.
    static constexpr int kFreeDepth = 40;
    static constexpr int kDeepest = kFreeDepth + 32;
    static constexpr std::uint32_t kLeafItems = 4;

    /// With a count: a leaf of items first .. first + count. Without: the parent of the node after it and of `first`.
    struct Node {
        GridBox box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };

    void build(std::uint32_t first, std::uint32_t count, int depth);
    std::uint32_t divide(std::uint32_t first, std::uint32_t count, const GridBox& centres);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

}  // namespace firma

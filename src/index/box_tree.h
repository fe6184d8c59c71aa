// SPDX-License-Identifier: MIT
// A tree over boxes that stay as they are for the length of one job: which of them does a box meet, or a ray?
//
// Unlike the blocks of a world it is built in one piece, searched a few hundred times and thrown away, so it is made to
// be built quickly: about as long as a hundred searches take.
#pragma once

#include <algorithm>
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

    /// Calls `function(number, other)` once for each two boxes that meet, number < other, until it returns true: for
    /// each `number` in the order of items(), and for each of these in the same order. Searches once for several
    /// neighbours in the tree: a fraction of the time that a search for each takes.
    /// @return whether `function` did
    template <class Function>
    bool for_each_pair(const Function& function) const {
        if (nodes_.empty()) return false;
        std::vector<Item> near;
        std::vector<std::uint32_t> met;
        return pairs_below(0, 0, std::uint32_t(items_.size()), near, met, function);
    }

private:
    /// Below this depth bins are halved by count, so 2^32 boxes stay within kDeepest.
    static constexpr int kFreeDepth = 40;
    static constexpr int kDeepest = kFreeDepth + 32;
    static constexpr std::uint32_t kLeafItems = 4;
    static constexpr std::uint32_t kTogether = 16;  ///< at most, that for_each_pair() searches for at once

    /// With a count: a leaf of items first .. first + count. Without: the parent of the node after it and of `first`.
    struct Node {
        GridBox box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };

    /// The pairs of items begin .. end, which are those below the node.
    template <class Function>
    bool pairs_below(std::uint32_t at, std::uint32_t begin, std::uint32_t end, std::vector<Item>& near,
                     std::vector<std::uint32_t>& met, const Function& function) const {
        if (end - begin > kTogether && nodes_[at].count == 0) {
            const std::uint32_t middle = first_item(nodes_[at].first);
            return pairs_below(at + 1, begin, middle, near, met, function) ||
                   pairs_below(nodes_[at].first, middle, end, near, met, function);
        }
        std::uint32_t least = items_[begin].number;
        for (std::uint32_t k = begin + 1; k < end; ++k) least = items_[k].number < least ? items_[k].number : least;
        const std::size_t found_count = find_near(nodes_[at].box, least, near);  // `near` may move
        const std::span<const Item> found(near.data(), found_count);
        met.resize(std::max(met.size(), found.size()));
        for (std::uint32_t k = begin; k < end; ++k) {
            const Item item = items_[k];
            const std::size_t count = those_meeting(item, found, met.data());
            for (std::size_t m = 0; m < count; ++m)
                if (function(item.number, met[m])) return true;
        }
        return false;
    }
    std::uint32_t first_item(std::uint32_t at) const {
        while (nodes_[at].count == 0) ++at;
        return nodes_[at].first;
    }
    /// Puts the items that meet a node's box and have a greater number than `least` first, in order.
    /// @param near  some items, of which there may be more than it is left with
    /// @return how many
    std::size_t find_near(const GridBox& box, std::uint32_t least, std::vector<Item>& near) const;
    /// The numbers of those that an item meets and that are greater than its own, in order.
    static std::size_t those_meeting(const Item& item, std::span<const Item> near, std::uint32_t* met);

    void build(std::uint32_t first, std::uint32_t count, int depth);
    std::uint32_t divide(std::uint32_t first, std::uint32_t count, const GridBox& centres);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

}  // namespace firma

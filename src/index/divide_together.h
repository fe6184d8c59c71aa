// SPDX-License-Identifier: MIT
// The tree of bins of divide_bins(), made by several threads: large bins are divided level by level, each by one of
// them, then small ones down to the end. Which bins there are, and their order, is the same.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/long_work.h"
#include "index/divide_bins.h"

namespace firma {

template <class SplitBin>
class BinsTogether {
public:
    BinsTogether(BinTree& tree, const SplitBin& split, LongWork& work)
        : tree_(tree),
          split_(split),
          work_(work),
          small_(std::max(kSmallest, std::uint32_t(tree.items.size()) / kParts)) {}

    /// @return false when the work was stopped
    bool divide() {
        ranges_ = {{0, std::uint32_t(tree_.items.size()), 0}};
        for (std::size_t begin = 0; begin < ranges_.size();) {
            const std::size_t end = ranges_.size();
            if (!work_.each(end - begin, [&](std::size_t k) { divide_one(ranges_[begin + k]); })) return false;
            for (; begin < end; ++begin) add_halves(begin);
        }
        tree_.nodes.clear();
        put(ranges_[0]);
        return true;
    }

private:
    static constexpr std::uint32_t kParts = 64, kSmallest = 4096;

    /// Items of a bin.
    struct Range {
        std::uint32_t first, count;
        int depth;
        GridBox box{};
        std::uint32_t on_left = 0;          ///< items of the left half; 0: not divided
        std::uint32_t left = 0, right = 0;  ///< ranges
        std::vector<BinNode> below{};       ///< of a small one: its tree, from its own bin on
    };

    void divide_one(Range& range) {
        if (range.count <= small_) {
            divide_bins(std::span(tree_.items), range.below, range.first, range.count, range.depth, split_);
        } else {
            const std::span<BuildItem> items = tree_.items_of(range.first, range.count);
            range.box = box_around(items);
            range.on_left = std::uint32_t(split_(items, range.box, range.depth));
            if (range.on_left == 0) sort_bin(items);
        }
        if (range.on_left == 0) work_.add(range.count);
    }

    void add_halves(std::size_t of) {
        const Range range = ranges_[of];
        if (range.on_left == 0) return;
        ranges_[of].left = std::uint32_t(ranges_.size());
        ranges_[of].right = std::uint32_t(ranges_.size() + 1);
        ranges_.push_back({range.first, range.on_left, range.depth + 1});
        ranges_.push_back({range.first + range.on_left, range.count - range.on_left, range.depth + 1});
    }

    /// Its bins in order, each before its children.
    std::uint32_t put(const Range& range) {
        const auto index = std::uint32_t(tree_.nodes.size());
        for (BinNode node : range.below) {
            if (node.left) node.left += index;
            if (node.right) node.right += index;
            tree_.nodes.push_back(node);
        }
        if (!range.below.empty()) return index;
        tree_.nodes.push_back({range.box, range.first, range.count, 0, 0});
        if (range.on_left == 0) return index;
        const std::uint32_t left = put(ranges_[range.left]), right = put(ranges_[range.right]);
        tree_.nodes[index].left = left;
        tree_.nodes[index].right = right;
        return index;
    }

    BinTree& tree_;
    const SplitBin& split_;
    LongWork& work_;
    const std::uint32_t small_;
    std::vector<Range> ranges_;
};

/// As divide_bins() of all items; tells of each item once.
/// @return false when the work was stopped: then there is no tree
template <class SplitBin>
bool divide_together(BinTree& tree, const SplitBin& split, LongWork& work) {
    return BinsTogether<SplitBin>(tree, split, work).divide();
}

}  // namespace firma

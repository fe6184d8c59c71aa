// SPDX-License-Identifier: MIT
// The binary tree of bins over items that nodes are made of; how far to divide is given in.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "index/split_bin.h"

namespace firma {

/// A bin: the article's word for a node of this tree.
struct BinNode {
    GridBox box;
    std::uint32_t first = 0, count = 0;  ///< items below
    std::uint32_t left = 0, right = 0;   ///< 0: a leaf
};

struct BinTree {
    std::vector<BuildItem> items;
    std::vector<BinNode> nodes;  ///< nodes[0] is the root

    std::span<BuildItem> items_of(std::uint32_t first, std::uint32_t count) { return {items.data() + first, count}; }
    std::span<const BuildItem> items_of(const BinNode& node) const { return {items.data() + node.first, node.count}; }
};

/// Standard libraries partition in different orders; items lie in a bin that is not divided by their own.
inline void sort_bin(std::span<BuildItem> items) {
    std::sort(items.begin(), items.end(), [](const BuildItem& a, const BuildItem& b) { return a.face < b.face; });
}

/// Divides items first .. first + count.
/// @param nodes  the bins are added to these, each before its children
/// @param split  (items, box, depth) puts those of the left child first and returns how many; 0 leaves the bin whole
/// @return index of the node
template <class SplitBin>
std::uint32_t divide_bins(std::span<BuildItem> all, std::vector<BinNode>& nodes, std::uint32_t first,
                          std::uint32_t count, int depth, const SplitBin& split) {
    const auto index = std::uint32_t(nodes.size());
    BinNode node;
    node.first = first;
    node.count = count;
    const std::span<BuildItem> items = all.subspan(first, count);
    node.box = box_around(items);
    nodes.push_back(node);
    const auto left = std::uint32_t(split(items, node.box, depth));
    if (left == 0) {
        sort_bin(items);
        return index;
    }
    const std::uint32_t left_node = divide_bins(all, nodes, first, left, depth + 1, split);
    const std::uint32_t right_node = divide_bins(all, nodes, first + left, count - left, depth + 1, split);
    nodes[index].left = left_node;
    nodes[index].right = right_node;
    return index;
}

}  // namespace firma

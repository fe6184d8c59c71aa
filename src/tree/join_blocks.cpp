// SPDX-License-Identifier: MIT
// From blocks to blocks over them.
#include "tree/join_blocks.h"

#include <algorithm>

namespace firma {

// By surface area also where faces are split otherwise: blocks that edits made overlap more than bins do, and a walk
// pays for overlap here more than anywhere.
void BlockJoiner::divide(std::span<const BlockItem> blocks) {
    constexpr int kUnevenLevels = 12;  // then in halves: what the rule peels off one by one must not make a deep tree
    tree_.items.resize(blocks.size());
    tree_.nodes.clear();
    for (std::uint32_t k = 0; k < blocks.size(); ++k) tree_.items[k] = {to_grid(blocks[k].box), k};
    divide_bins(tree_, 0, std::uint32_t(blocks.size()), 0,
                [&](std::span<BuildItem> items, const GridBox&, int depth) -> std::size_t {
                    if (items.size() == 1) return 0;
                    if (items.size() == 2) {  // either way alike
                        if (items[1].face < items[0].face) std::swap(items[0], items[1]);
                        return 1;
                    }
                    const std::size_t left = depth < kUnevenLevels ? split_by_area(items) : 0;
                    return left != 0 ? left : split_by_count(items);
                });
}

void BlockJoiner::group(std::size_t most_items, std::vector<std::uint32_t>& nodes) {
    sum_up([](std::uint32_t) { return 1; });
    nodes.clear();
    const auto below = [&](const auto& self, std::uint32_t n) -> void {
        if (sums_[n] <= most_items) return nodes.push_back(n);
        self(self, tree_.nodes[n].left);
        self(self, tree_.nodes[n].right);
    };
    below(below, 0);
}

Ref<const Block> BlockJoiner::join(std::span<const BlockItem> items, std::uint32_t node) {
    Ref<Block> block(new Block);
    block->children.reserve(sums_[node]);
    bins_.clear();
    append_bins(tree_, node, 0, bins_, [&](std::uint32_t n, Bin& bin, int depth) {
        if (!is_leaf(n)) return false;
        const Block* child = items[item_at(n)].block;
        bin.first = std::uint32_t(block->children.size());
        bin.count = 1;
        block->children.emplace_back(child);
        block->faces_below += child->faces_below;
        block->depth = std::uint16_t(std::max<int>(block->depth, depth + child->depth));
        return true;
    });
    block->bins.assign(bins_.begin(), bins_.end());
    return Ref<const Block>(block.get());
}

}  // namespace firma

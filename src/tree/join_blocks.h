// SPDX-License-Identifier: MIT
// From blocks to blocks over them: how an edit puts what it rebuilt and what it left alone together again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/ref.h"
#include "tree/block.h"
#include "tree/divide_bins.h"
#include "tree/rounded_box.h"

namespace firma {

/// A block that is to have another one above it. Whoever makes it keeps the block alive.
struct BlockItem {
    const Block* block = nullptr;
    BoxF box;               ///< block->bins[0].box; the block above has it too, so that blocks need not be looked at
    bool of_faces = false;  ///< whether it is a leaf block
    bool is_new = false;    ///< whether the edit has changed what it holds

    static BlockItem of(const Block& block, bool is_new) {
        return {&block, block.bins[0].box, !block.holds_blocks(), is_new};
    }
};

/// Keeps its scratch memory from call to call.
class BlockJoiner {
public:
    /// Divides items as faces are divided, by surface area and whatever the stop rules, down to single ones; for the
    /// calls that follow. Node 0 is the root; leaves are items.
    void divide(std::span<const BlockItem> items);

    /// The division's largest nodes whose blocks together hold at most so many faces, a new one among them, become one
    /// item each.
    /// @param items  those divided, at whose end the new ones are put
    /// @param make   gives one, for a node
    template <class Make>
    void merge(std::vector<BlockItem>& items, std::size_t most_faces, const Make& make);

    /// The largest nodes of at most so many items each.
    void group(std::size_t most_items, std::vector<std::uint32_t>& nodes);

    /// How many items are below a node; after group().
    std::size_t count_below(std::uint32_t node) const { return sums_[node]; }
    /// Calls `function(item)`, left to right.
    template <class Function>
    void for_each_below(std::uint32_t node, const Function& function) const {
        if (is_leaf(node)) return function(item_at(node));
        for_each_below(tree_.nodes[node].left, function);
        for_each_below(tree_.nodes[node].right, function);
    }

    /// One block over all items below a node, at most 64; after group().
    Ref<const Block> join(std::span<const BlockItem> items, std::uint32_t node);

private:
    bool is_leaf(std::uint32_t node) const { return tree_.nodes[node].left == 0; }
    std::uint32_t item_at(std::uint32_t leaf) const { return tree_.items[tree_.nodes[leaf].first].face; }
    /// Sets `sums_`, of each node.
    template <class Of>
    void sum_up(const Of& of_item);

    BinTree tree_;
    std::vector<std::uint32_t> sums_;
    std::vector<std::uint8_t> has_new_;
    std::vector<Bin> bins_;
};

template <class Of>
void BlockJoiner::sum_up(const Of& of_item) {
    sums_.resize(tree_.nodes.size());
    for (auto n = std::uint32_t(tree_.nodes.size()); n-- > 0;)  // children stand after their parents
        sums_[n] = is_leaf(n) ? of_item(item_at(n)) : sums_[tree_.nodes[n].left] + sums_[tree_.nodes[n].right];
}

template <class Make>
void BlockJoiner::merge(std::vector<BlockItem>& items, std::size_t most_faces, const Make& make) {
    sum_up([&](std::uint32_t item) { return items[item].block->faces_below; });
    has_new_.resize(tree_.nodes.size());
    for (auto n = std::uint32_t(tree_.nodes.size()); n-- > 0;) {
        const BinNode& node = tree_.nodes[n];
        has_new_[n] = is_leaf(n) ? items[item_at(n)].is_new : has_new_[node.left] | has_new_[node.right];
    }
    const auto below = [&](const auto& self, std::uint32_t n) -> void {
        BinNode& node = tree_.nodes[n];
        if (node.left == 0 || !has_new_[n]) return;
        if (sums_[n] > most_faces) {
            self(self, node.left);
            self(self, node.right);
            return;
        }
        items.push_back(make(n));
        tree_.items[node.first].face = std::uint32_t(items.size() - 1);
        node.left = node.right = 0;
    };
    below(below, 0);
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// The one walk through a tree of blocks, nearest bins first; what is asked of bins and faces is given in.
#pragma once

#include <array>

#include "base/assert.h"
#include "tree/block.h"
#include "tree/build_blocks.h"

namespace firma {

/// Visits the faces of all bins that the visitor enters. Allocates nothing, counts no reference.
///
/// A visitor has
///   bool enter(const Bin&, double& nearest)   whether to look into a bin, and a lower bound for what it may find there
///   bool still(double nearest) const          whether such a bin is worth it by now
///   bool faces(const Block&, first, count)    looks at faces; true ends the walk
template <class Visitor>
void visit(const Block& root, Visitor& visitor) {
    struct Waiting {
        const Block* block;
        std::uint32_t bin;
        double nearest;
    };
    std::array<Waiting, kDeepestTree + 8> waiting;  // each bin on the way down leaves at most one sibling behind
    std::size_t count = 0;
    Waiting now{&root, 0, 0};
    if (!visitor.enter(root.bins[0], now.nearest)) return;
    for (;;) {
        const Bin& bin = now.block->bins[now.bin];
        bool go_on = false;
        if (!bin.is_leaf()) {
            Waiting left{now.block, now.bin + 1, 0}, right{now.block, bin.first, 0};
            const bool enters_left = visitor.enter(now.block->bins[left.bin], left.nearest);
            const bool enters_right = visitor.enter(now.block->bins[right.bin], right.nearest);
            if (enters_left && enters_right) {
                const bool left_first = left.nearest <= right.nearest;
                FIRMA_ASSERT(count < waiting.size(), "a tree is deeper than trees are built");
                waiting[count++] = left_first ? right : left;
                now = left_first ? left : right;
                go_on = true;
            } else if (enters_left || enters_right) {
                now = enters_left ? left : right;
                go_on = true;
            }
        } else if (now.block->holds_blocks()) {
            now = {now.block->children[bin.first].get(), 0, now.nearest};  // its root bin has the same box
            go_on = true;
        } else if (visitor.faces(*now.block, bin.first, bin.count)) {
            return;
        }
        while (!go_on) {
            if (count == 0) return;
            now = waiting[--count];
            go_on = visitor.still(now.nearest);
        }
    }
}

/// Every leaf block, in order.
template <class Function>
void for_each_face_block(const Block& root, const Function& function) {
    if (!root.holds_blocks()) return function(root);
    for (const Ref<const Block>& child : root.children) for_each_face_block(*child, function);
}

}  // namespace firma

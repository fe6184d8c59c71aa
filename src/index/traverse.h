// SPDX-License-Identifier: MIT
// The one traversal of an index, nearest bins first; what is asked of bins and facets is given in.
#pragma once

#include <array>

#include "base/assert.h"
#include "index/node.h"

namespace firma {

/// Goes through the facets of all bins that the visitor enters. Allocates nothing, counts no reference.
///
/// A visitor has
///   bool enter(const Bin&, double& nearest)   whether to look into a bin, and a lower bound for what it may find there
///   bool still(double nearest) const          whether such a bin is worth it by now
///   bool facets(const IndexedFacets&, first, count)    looks at facets; true ends the traversal
template <class Visitor>
void traverse(const Node& root, Visitor& visitor) {
    struct Waiting {
        const Node* node;
        std::uint32_t bin;
        double nearest;
    };
    std::array<Waiting, kDeepestTree + 8> waiting;  // each bin on the way down leaves at most one sibling behind
    std::size_t count = 0;
    Waiting now{&root, 0, 0};
    if (!visitor.enter(root.bins[0], now.nearest)) return;
    for (;;) {
        const Bin& bin = now.node->bins[now.bin];
        bool go_on = false;
        if (!bin.is_leaf()) {
            Waiting left{now.node, now.bin + 1, 0}, right{now.node, bin.first, 0};
            const bool enters_left = visitor.enter(now.node->bins[left.bin], left.nearest);
            const bool enters_right = visitor.enter(now.node->bins[right.bin], right.nearest);
            if (enters_left && enters_right) {
                const bool left_first = left.nearest <= right.nearest;
                FIRMA_ASSERT(count < waiting.size(), "an index is deeper than any that is built");
                waiting[count++] = left_first ? right : left;
                now = left_first ? left : right;
                go_on = true;
            } else if (enters_left || enters_right) {
                now = enters_left ? left : right;
                go_on = true;
            }
        } else if (!now.node->is_leaf()) {
            now = {now.node->children[bin.first].get(), 0, now.nearest};  // its root bin has the same box
            go_on = true;
        } else if (visitor.facets(*now.node->facets, bin.first, bin.count)) {
            return;
        }
        while (!go_on) {
            if (count == 0) return;
            now = waiting[--count];
            go_on = visitor.still(now.nearest);
        }
    }
}

/// Every leaf node, in order.
template <class Function>
void for_each_leaf(const Ref<const Node>& root, const Function& function) {
    if (root->is_leaf()) return function(root);
    for (const Ref<const Node>& child : root->children) for_each_leaf(child, function);
}

}  // namespace firma

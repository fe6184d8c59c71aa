// SPDX-License-Identifier: MIT
// The one traversal of an index, nearest boxes first; what is asked of boxes and facets is given in.
#pragma once

#include <array>

#include "base/assert.h"
#include "index/node.h"

namespace firma {

/// What lies below a lane: facets first .. first + count of a leaf node, or, without any, wide nodes from `wide` on.
struct BelowLane {
    const Node* node;
    const WideNode* wide;  ///< null: facets
    std::uint8_t first, count;

    static BelowLane root(const Node& node) { return {&node, node.wide.data(), 0, 0}; }
    static BelowLane of(const Node& node, const WideNode& above, std::uint32_t lane) {
        if (above.leads_to_facets(lane)) {
            const LaneItems& it = node.items_of(above);
            return {&node, nullptr, it.first[lane], std::uint8_t(it.items(lane))};
        }
        const Node* const other = node.node_below(above, lane);
        return {other ? other : &node, above.wide(lane), 0, 0};
    }
};

/// Goes through the facets of all boxes that the visitor enters. Allocates nothing, counts no reference.
///
/// A visitor has
///   bool enter(const BoxF&, double& nearest)  whether to look into a box, and a lower bound for what it may find there
///   bool still(double nearest) const          whether such a box is worth it by now
///   bool facets(const IndexedFacets&, first, count)    looks at facets; true ends the traversal
/// Of boxes that are equally near, those on the left come first.
template <class Visitor>
void traverse(const Node& root, Visitor& visitor) {
    struct Waiting {
        BelowLane below;
        double nearest;
    };
    // Each wide node on the way down leaves at most seven lanes behind.
    std::array<Waiting, (kDeepestTree + 1) * (WideNode::kLanes - 1) + 1> waiting;
    std::size_t count = 0;
    waiting[count++] = {BelowLane::root(root), 0};
    while (count > 0) {
        const Waiting now = waiting[--count];
        if (!visitor.still(now.nearest)) continue;
        if (!now.below.wide) {
            if (visitor.facets(*now.below.node->facets, now.below.first, now.below.count)) return;
            continue;
        }
        const WideNode& wide = *now.below.wide;
        const std::size_t base = count;
        for (std::uint32_t lane = now.below.node->items_of(wide).count; lane-- > 0;) {
            double nearest = 0;
            if (!visitor.enter(wide.box(lane), nearest)) continue;
            FIRMA_ASSERT(count < waiting.size(), "an index is deeper than any that is built");
            std::size_t at = count++;
            for (; at > base && waiting[at - 1].nearest < nearest; --at) waiting[at] = waiting[at - 1];
            waiting[at] = {BelowLane::of(*now.below.node, wide, lane), nearest};
        }
    }
}

/// Every leaf node, in order.
template <class Function>
void for_each_leaf(const Ref<const Node>& root, const Function& function) {
    if (root->is_leaf()) return function(root);
    for (const Ref<const Node>& child : root->children) for_each_leaf(child, function);
}

/// Calls `function(wide, lane)` for the lanes to items of a node whose boxes meet one, left to right.
template <class Function>
void for_each_item_meeting(const Node& node, const GridBox& box, const Function& function) {
    const auto below = [&](const auto& self, const WideNode& wide) -> void {
        const unsigned met = lanes_meeting(wide, box);
        for (std::uint32_t lane = 0; met >> lane; ++lane) {
            if (!(met >> lane & 1)) continue;
            if (wide.leads_to_facets(lane) || node.node_below(wide, lane))
                function(wide, lane);
            else
                self(self, *wide.wide(lane));
        }
    };
    below(below, node.wide[0]);
}

}  // namespace firma

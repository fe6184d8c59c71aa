// SPDX-License-Identifier: MIT
// Leaves over facets that are nothing but boxes, and indices over them looked at plainly: an index never asks what its
// facets are.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

#include "index/join_nodes.h"
#include "index/traverse.h"
#include "scenes/rng.h"

namespace firma::test {

struct PlainFacets final : IndexedFacets {
    explicit PlainFacets(const GridBox& around) : box(around) {}
    std::size_t bytes() const override { return sizeof *this; }
    GridBox box;
};

/// A leaf of so many facets, all in one box.
inline Ref<const Node> leaf_of(const GridBox& box, std::uint32_t facets) {
    Ref<Node> leaf(new Node);
    WideNode& wide = leaf->wide.emplace_back();
    const GridBox* const boxes[] = {&box};
    set_boxes(wide, boxes);
    wide.lead_to_facets(0, nullptr);
    LaneItems& items = leaf->lane_items.emplace_back();
    items.count = 1;
    for (std::uint32_t k = 0; k < WideNode::kLanes; ++k) items.first[k + 1] = std::uint8_t(facets);
    leaf->box = box;
    leaf->depth = 1;
    leaf->facets_below = facets;
    leaf->facets = Ref<const IndexedFacets>(new PlainFacets(box));
    return Ref<const Node>(leaf.get());
}

/// A box of up to `size` steps, somewhere within 0 .. `spread`.
inline GridBox random_box(scenes::Rng& rng, std::int32_t spread, std::int32_t size) {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::int32_t(rng.below(std::uint32_t(spread)));
        box.high[axis] = box.low[axis] + std::int32_t(rng.below(std::uint32_t(size)));
    }
    return box;
}

inline const PlainFacets* facets_of(const Ref<const Node>& leaf) {
    return static_cast<const PlainFacets*>(leaf->facets.get());
}

inline bool contains(const BoxF& outer, const GridBox& inner) {
    const Vec3 low = to_metres(inner.low), high = to_metres(inner.high);
    for (int axis = 0; axis < 3; ++axis)
        if (low[axis] < double(outer.low[axis]) || high[axis] > double(outer.high[axis])) return false;
    return true;
}

/// Every invariant of a node and of those below it.
class NodeChecker {
public:
    /// The facets below, in order.
    static std::vector<const IndexedFacets*> check(const Ref<const Node>& root) {
        NodeChecker checker;
        if (root) checker.node(*root);
        return checker.found_;
    }

private:
    void node(const Node& node) {
        ASSERT_FALSE(node.wide.empty());
        ASSERT_EQ(node.lane_items.size(), node.wide.size());
        ASSERT_EQ(node.is_leaf(), bool(node.facets));
        const std::size_t items = node.is_leaf() ? node.facets_below : node.children.size();
        ASSERT_GE(items, 1u);
        ASSERT_LE(items, kNodeItems);
        ASSERT_LE(node.depth, kDeepestTree);
        Walk walk{node};
        wide(node.wide[0], 1, walk);
        ASSERT_EQ(walk.wide_nodes, node.wide.size());
        ASSERT_EQ(walk.next_item, items) << "each item in one box, left to right";
        ASSERT_EQ(node.depth, walk.deepest);
        ASSERT_EQ(node.facets_below, node.is_leaf() ? items : walk.below);
        if (node.is_leaf()) return found_.push_back(node.facets.get());
        GridBox around;
        for (const Ref<const Node>& child : node.children) around.add(child->box);
        ASSERT_EQ(node.box, around);
    }

    /// Through the wide nodes of one node.
    struct Walk {
        const Node& in;
        std::size_t wide_nodes = 0, next_item = 0, below = 0;
        int deepest = 0;
        std::vector<std::pair<const WideNode*, std::uint32_t>> way{};
    };

    void wide(const WideNode& here, int depth, Walk& walk) {
        ++walk.wide_nodes;
        const LaneItems& items = walk.in.items_of(here);
        ASSERT_GE(items.count, 1u);
        ASSERT_LE(items.count, WideNode::kLanes);
        for (std::uint32_t lane = items.count; lane < WideNode::kLanes; ++lane) ASSERT_EQ(here.below[lane], 0u);
        for (std::uint32_t lane = 0; lane < items.count; ++lane) {
            ASSERT_EQ(items.first[lane], walk.next_item);
            walk.way.push_back({&here, lane});
            if (here.leads_to_facets(lane)) {
                ASSERT_TRUE(walk.in.is_leaf());
                expect_inside(walk.in.box, walk);
                walk.next_item += items.items(lane);
                walk.deepest = std::max(walk.deepest, depth);
            } else if (walk.in.leads_to_node(here, lane)) {
                const Node& child = *walk.in.children.at(walk.next_item++);
                EXPECT_EQ(here.wide(lane), child.wide.data());
                expect_inside(child.box, walk);
                walk.deepest = std::max(walk.deepest, depth + child.depth);
                walk.below += child.facets_below;
                node(child);
            } else {
                wide(*here.wide(lane), depth + 1, walk);
            }
            walk.way.pop_back();
            ASSERT_EQ(items.first[lane + 1], walk.next_item);
        }
    }

    /// What a lane leads to lies in its box, and in those of all lanes above it in the node.
    static void expect_inside(const GridBox& box, const Walk& walk) {
        for (const auto& [above, lane] : walk.way) {
            EXPECT_TRUE(contains(above->box(lane), box));
            EXPECT_TRUE(lanes_around(*above, box) >> lane & 1);
            EXPECT_TRUE(lanes_meeting(*above, box) >> lane & 1);
        }
    }

    std::vector<const IndexedFacets*> found_;
};

/// The index is sound and has these leaves, each once.
inline void expect_holds(const Ref<const Node>& root, const std::vector<Ref<const Node>>& leaves) {
    std::vector<const IndexedFacets*> found = NodeChecker::check(root), expected;
    for (const Ref<const Node>& leaf : leaves) expected.push_back(leaf->facets.get());
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected);
}

inline void collect(const Node& node, std::unordered_set<const Node*>& all) {
    if (!all.insert(&node).second) return;
    for (const Ref<const Node>& child : node.children) collect(*child, all);
}
inline std::unordered_set<const Node*> nodes_of(const Ref<const Node>& root) {
    std::unordered_set<const Node*> all;
    if (root) collect(*root, all);
    return all;
}

}  // namespace firma::test

// SPDX-License-Identifier: MIT
// Leaves over facets that are nothing but boxes, and indices over them looked at plainly: an index never asks what its
// facets are.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <unordered_set>
#include <vector>

#include "index/join_nodes.h"
#include "index/rounded_box.h"
#include "index/traverse.h"
#include "scenes/rng.h"

namespace firma::test {

struct PlainFacets final : IndexedFacets {
    explicit PlainFacets(const GridBox& around) : box(around) {}
    std::size_t bytes() const override { return sizeof *this; }
    GridBox box;
};

/// A leaf of so many facets, all in one bin.
inline Ref<const Node> leaf_of(const GridBox& box, std::uint32_t facets) {
    Ref<Node> leaf(new Node);
    leaf->bins.push_back({to_floats(box), 0, facets});
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

inline bool contains(const BoxF& outer, const BoxF& inner) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
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
        ASSERT_FALSE(node.bins.empty());
        ASSERT_EQ(node.is_leaf(), bool(node.facets));
        const std::size_t items = node.is_leaf() ? node.facets_below : node.children.size();
        ASSERT_GE(items, 1u);
        ASSERT_LE(items, kNodeItems);
        ASSERT_LE(node.depth, kDeepestTree);
        std::size_t next_item = 0, below = 0;
        int deepest = 0;
        const std::size_t bins = bin(node, 0, 0, next_item, below, deepest);
        ASSERT_EQ(bins, node.bins.size());
        ASSERT_EQ(next_item, items) << "each item in one bin, left to right";
        ASSERT_EQ(node.depth, deepest);
        ASSERT_EQ(node.facets_below, node.is_leaf() ? items : below);
        if (node.is_leaf()) found_.push_back(node.facets.get());
    }

    /// @return bins at and below `at`
    std::size_t bin(const Node& in, std::size_t at, int depth, std::size_t& next_item, std::size_t& below,
                    int& deepest) {
        if (at >= in.bins.size()) {
            ADD_FAILURE() << "a bin leads out of its node";
            return 0;
        }
        const Bin& here = in.bins[at];
        if (!here.is_leaf()) {
            EXPECT_TRUE(contains(here.box, in.bins[at + 1].box));
            EXPECT_TRUE(contains(here.box, in.bins[here.first].box));
            const std::size_t left = bin(in, at + 1, depth + 1, next_item, below, deepest);
            EXPECT_EQ(here.first, at + 1 + left);
            return 1 + left + bin(in, here.first, depth + 1, next_item, below, deepest);
        }
        EXPECT_EQ(here.first, next_item);
        next_item += here.count;
        if (in.is_leaf()) {
            deepest = std::max(deepest, depth);
            return 1;
        }
        EXPECT_EQ(here.count, 1u);
        const Node& child = *in.children[here.first];
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(here.box.low[axis], child.bins[0].box.low[axis]);
            EXPECT_EQ(here.box.high[axis], child.bins[0].box.high[axis]);
        }
        deepest = std::max(deepest, depth + child.depth);
        below += child.facets_below;
        node(child);
        return 1;
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

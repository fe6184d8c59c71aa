// SPDX-License-Identifier: MIT
// Nodes put together: each exactly once, in groups that are not too large, and not too deep.
#include "index/join_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/index/test_nodes.h"

namespace firma {
namespace {

struct Items {
    std::vector<Ref<const Node>> leaves;
    std::vector<NodeItem> items;

    explicit Items(std::size_t count, std::uint32_t facets) {
        scenes::Rng rng(5);
        for (std::size_t k = 0; k < count; ++k)
            leaves.push_back(test::leaf_of(test::random_box(rng, 1 << 24, 1 << 16), facets));
        for (const Ref<const Node>& leaf : leaves) items.push_back(NodeItem::of(*leaf));
    }
};

TEST(JoinNodes, GroupsHoldEachItemOnceAndAreNotTooLarge) {
    const Items of(200, 20);
    NodeJoiner joiner;
    joiner.divide(of.items);
    std::vector<std::uint32_t> nodes;
    joiner.group(kNodeItems, nodes);
    EXPECT_GT(nodes.size(), 3u);
    std::vector<const Node*> joined, all;
    for (const std::uint32_t node : nodes) {
        ASSERT_LE(joiner.count_below(node), kNodeItems);
        const Ref<const Node> made = joiner.join(of.items, node);
        ASSERT_EQ(made->children.size(), joiner.count_below(node));
        EXPECT_EQ(made->facets_below, 20 * made->children.size());
        test::NodeChecker::check(made);
        std::size_t at = 0;
        joiner.for_each_below(node, [&](std::uint32_t item) {
            EXPECT_EQ(made->children[at++].get(), of.leaves[item].get()) << "left to right";
        });
        for (const Ref<const Node>& child : made->children) joined.push_back(child.get());
    }
    for (const Ref<const Node>& leaf : of.leaves) all.push_back(leaf.get());
    std::sort(all.begin(), all.end());
    std::sort(joined.begin(), joined.end());
    EXPECT_EQ(joined, all);
}

TEST(JoinNodes, SmallerGroupsToo) {
    const Items of(100, 1);
    NodeJoiner joiner;
    joiner.divide(of.items);
    std::vector<std::uint32_t> nodes;
    for (const std::size_t most : {4u, 8u, 9u, 32u, 100u}) {
        joiner.group(most, nodes);
        std::vector<int> seen(100, 0);
        for (const std::uint32_t node : nodes) {
            EXPECT_LE(joiner.count_below(node), most);
            joiner.for_each_below(node, [&](std::uint32_t item) { ++seen[item]; });
        }
        EXPECT_EQ(seen, std::vector<int>(100, 1));
        EXPECT_GE(nodes.size(), 100 / most);
        EXPECT_LE(nodes.size(), most == 100 ? 1u : 100u);
    }
}

TEST(JoinNodes, NoneIsNoneAndOneIsItself) {
    EXPECT_FALSE(join_nodes({}));
    const Items one(1, 3);
    EXPECT_EQ(join_nodes(one.leaves).get(), one.leaves[0].get());
}

TEST(JoinNodes, AnyNumberHoldsEachOnce) {
    for (const std::size_t count : {2u, 63u, 64u, 65u, 500u, 5000u}) {
        const Items of(count, 2);
        const Ref<const Node> root = join_nodes(of.leaves);
        test::expect_holds(root, of.leaves);
        EXPECT_EQ(root->facets_below, 2 * count);
    }
}

/// Boxes one in the other, each half as large: a rule by area takes off one at a time.
TEST(JoinNodes, BoxesOfAllSizesInOnePointStayShallow) {
    std::vector<Ref<const Node>> leaves;
    for (int k = 0; k < 6000; ++k) {
        const std::int32_t a = std::int32_t(1) << (8 + k % 22);
        leaves.push_back(test::leaf_of({{0, 0, 0}, {a, a, k}}, 1));
    }
    const Ref<const Node> root = join_nodes(leaves);
    test::expect_holds(root, leaves);
    EXPECT_LE(root->depth, 3 * 9 + 1);
}

TEST(JoinNodes, BoxesInOnePlaceAreHalvedByCount) {
    std::vector<Ref<const Node>> leaves;
    for (int k = 0; k < 4096; ++k) leaves.push_back(test::leaf_of({{1, 2, 3}, {4, 5, 6}}, 1));
    const Ref<const Node> root = join_nodes(leaves);
    test::expect_holds(root, leaves);
    EXPECT_EQ(root->depth, 5) << "eights of eights, twice";
}

TEST(JoinOpened, HoldsWhatTheNodesHeldAsFarAsThatFits) {
    for (const auto& [one, other, children] :
         {std::array{20u, 30u, 50u}, {60u, 60u, 61u}, {64u, 64u, 2u}, {1u, 40u, 41u}}) {
        const Items a(one, 2), b(other, 3);
        const std::vector<Ref<const Node>> roots{join_nodes(a.leaves), join_nodes(b.leaves)};
        const Ref<const Node> root = join_opened(roots);
        EXPECT_EQ(root->children.size(), children);
        std::vector<Ref<const Node>> leaves = a.leaves;
        leaves.insert(leaves.end(), b.leaves.begin(), b.leaves.end());
        test::expect_holds(root, leaves);
        EXPECT_EQ(root->facets_below, 2 * one + 3 * other);
        EXPECT_LE(root->depth, join_nodes(roots)->depth);
    }
    EXPECT_FALSE(join_opened({}));
    const Items one(1, 3);
    EXPECT_EQ(join_opened(one.leaves).get(), one.leaves[0].get());
}

}  // namespace
}  // namespace firma

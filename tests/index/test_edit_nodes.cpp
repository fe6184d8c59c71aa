// SPDX-License-Identifier: MIT
// Edited indices hold the leaves they must, each once, share what was not touched, and stay shallow.
#include "index/edit_nodes.h"

#include <gtest/gtest.h>

#include "index/statistics.h"
#include "tests/index/test_nodes.h"
#include "tests/index/wide_contents.h"

namespace firma {
namespace {

struct EditedIndex {
    std::vector<Ref<const Node>> leaves;
    Ref<const Node> root;

    explicit EditedIndex(std::size_t count, std::uint64_t seed = 5) {
        scenes::Rng rng(seed);
        for (std::size_t k = 0; k < count; ++k)
            leaves.push_back(test::leaf_of(test::random_box(rng, 1 << 24, 1 << 18), 1 + rng.below(64)));
        root = join_nodes(leaves);
    }

    /// @return steps
    int apply(NodeEdit& edit) {
        int steps = 1;
        while (edit.step()) ++steps;
        root = edit.result();
        return steps;
    }
    /// Takes out some leaves around one, puts in others there.
    int change(std::size_t out, std::size_t in, scenes::Rng& rng) {
        NodeEdit edit(root);
        GridBox around = test::random_box(rng, 1 << 24, 1 << 10);
        for (; out > 0 && !leaves.empty(); --out) {
            std::size_t nearest = 0;
            double least = 1e300;
            for (std::size_t k = 0; k < leaves.size(); ++k) {
                const GridBox& box = test::facets_of(leaves[k])->box;
                double distance = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const double d = double(box.low[axis]) - around.low[axis];
                    distance += d * d;
                }
                if (distance < least) {
                    least = distance;
                    nearest = k;
                }
            }
            edit.remove(leaves[nearest]->facets.get(), test::facets_of(leaves[nearest])->box);
            leaves.erase(leaves.begin() + std::ptrdiff_t(nearest));
        }
        for (; in > 0; --in) {
            GridBox box = test::random_box(rng, 1 << 20, 1 << 18);
            for (int axis = 0; axis < 3; ++axis) {
                box.low[axis] += around.low[axis];
                box.high[axis] += around.low[axis];
            }
            leaves.push_back(test::leaf_of(box, 1 + rng.below(64)));
            edit.add(leaves.back());
        }
        return apply(edit);
    }
};

/// Boxes, counts and leaves in order: equal only for equal indices.
void everything(const Node& node, std::vector<std::uint64_t>& all) {
    test::add_wide_contents(node, all);
    all.push_back(std::uint64_t(node.facets_below) << 32 | node.depth);
    for (const Ref<const Node>& child : node.children) everything(*child, all);
}
std::vector<std::uint64_t> everything(const Ref<const Node>& root) {
    std::vector<std::uint64_t> all;
    if (root) everything(*root, all);
    return all;
}

TEST(EditNodes, RandomEditsHoldEachLeafOnce) {
    for (const std::size_t count : {0u, 1u, 2u, 40u, 64u, 65u, 1000u}) {
        EditedIndex index(count);
        scenes::Rng rng(count + 1);
        for (int k = 0; k < 120; ++k) {
            index.change(rng.below(k % 20 == 0 ? 90 : 12), rng.below(k % 30 == 0 ? 200 : 12), rng);
            test::expect_holds(index.root, index.leaves);
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(EditNodes, NothingChangedKeepsTheRoot) {
    for (const std::size_t count : {0u, 1u, 64u, 1000u}) {
        const EditedIndex index(count);
        NodeEdit edit(index.root);
        while (edit.step()) {
        }
        EXPECT_EQ(edit.result().get(), index.root.get());
    }
}

TEST(EditNodes, DownToNothingAndUpAgain) {
    EditedIndex index(2000);
    scenes::Rng rng(8);
    while (!index.leaves.empty()) {
        index.change(45, 0, rng);
        test::expect_holds(index.root, index.leaves);
        if (testing::Test::HasFailure()) return;
        // Nodes of few children hand them to the one above.
        const std::size_t inner = test::nodes_of(index.root).size() - index.leaves.size();
        EXPECT_LE(inner, 2 + index.leaves.size() / 4);
    }
    EXPECT_FALSE(index.root);
    for (int k = 0; k < 60; ++k) {
        index.change(0, 1 + rng.below(60), rng);
        test::expect_holds(index.root, index.leaves);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(EditNodes, AllAtOnceForAllOthers) {
    EditedIndex index(700);
    const EditedIndex others(900, 6);
    NodeEdit edit(index.root);
    for (const Ref<const Node>& leaf : index.leaves) edit.remove(leaf->facets.get(), test::facets_of(leaf)->box);
    for (const Ref<const Node>& leaf : others.leaves) edit.add(leaf);
    index.apply(edit);
    test::expect_holds(index.root, others.leaves);
}

TEST(EditNodes, TheIndexBeforeIsUntouchedAndTheRestIsShared) {
    EditedIndex index(5000);
    const Ref<const Node> before = index.root;
    const auto before_is = everything(before);
    const auto old_nodes = test::nodes_of(before);
    scenes::Rng rng(2);
    const int steps = index.change(8, 10, rng);
    test::expect_holds(index.root, index.leaves);
    EXPECT_EQ(everything(before), before_is);
    std::size_t fresh = 0;
    for (const Node* node : test::nodes_of(index.root)) fresh += !old_nodes.contains(node);
    EXPECT_GT(fresh, 10u);
    EXPECT_LT(fresh, 40u) << "of " << old_nodes.size();
    EXPECT_GT(steps, 3);
    EXPECT_LT(steps, 60) << "a node at most each";
}

TEST(EditNodes, SameEditsSameIndexAndOrderOfRemovalsDoesNotMatter) {
    const auto make = [](bool back) {
        EditedIndex index(1500);
        scenes::Rng rng(3);
        for (int k = 0; k < 40; ++k) {
            const std::size_t from = rng.below(std::uint32_t(index.leaves.size() - 9));
            NodeEdit edit(index.root);
            for (std::size_t j = 0; j < 9; ++j) {
                const Ref<const Node>& leaf = index.leaves[from + (back ? 8 - j : j)];
                edit.remove(leaf->facets.get(), test::facets_of(leaf)->box);
            }
            index.leaves.erase(index.leaves.begin() + std::ptrdiff_t(from),
                               index.leaves.begin() + std::ptrdiff_t(from + 9));
            for (int j = 0; j < 8; ++j) {
                index.leaves.push_back(test::leaf_of(test::random_box(rng, 1 << 24, 1 << 18), 5));
                edit.add(index.leaves.back());
            }
            index.apply(edit);
        }
        return index;
    };
    const EditedIndex one = make(false), between = EditedIndex(100), two = make(false), three = make(true);
    EXPECT_EQ(everything(one.root), everything(two.root)) << "whatever the addresses";
    EXPECT_EQ(everything(one.root), everything(three.root));
}

TEST(EditNodes, ThousandsOfAllSizesInOnePointStayShallow) {
    EditedIndex index(0);
    for (int k = 0; k < 1500; ++k) {
        NodeEdit edit(index.root);
        for (int j = 0; j < 4; ++j) {
            const std::int32_t a = std::int32_t(1) << (8 + (4 * k + j) % 22);
            index.leaves.push_back(test::leaf_of({{0, 0, 0}, {a, a, k}}, 1));
            edit.add(index.leaves.back());
        }
        index.apply(edit);
        ASSERT_LE(index.root->depth, kDeepestTree);
    }
    test::expect_holds(index.root, index.leaves);
}

TEST(EditNodes, StaysNearlyAsTightAsAnIndexFromScratch) {
    EditedIndex index(1000);
    scenes::Rng rng(9);
    for (int k = 0; k < 600; ++k) index.change(6, 6, rng);
    test::expect_holds(index.root, index.leaves);
    const TreeStatistics edited = tree_statistics(*index.root), scratch = tree_statistics(*join_nodes(index.leaves));
    EXPECT_EQ(edited.faces, scratch.faces);
    EXPECT_LE(edited.depth, scratch.depth + 16);
    EXPECT_LT(edited.overlap, 2 * scratch.overlap) << "what casts pay for it: tests/solid/test_edit_blocks.cpp";
    EXPECT_LT(edited.blocks, scratch.blocks + scratch.blocks / 4);
}

#if GTEST_HAS_DEATH_TEST && FIRMA_ASSERTIONS
TEST(EditNodesDeathTest, ALeafThatIsNotThereIsRefused) {
    const EditedIndex index(500), other(1, 77);
    NodeEdit edit(index.root);
    edit.remove(other.leaves[0]->facets.get(), test::facets_of(other.leaves[0])->box);
    EXPECT_DEATH(while (edit.step()){}, "remove");
}
#endif

}  // namespace
}  // namespace firma

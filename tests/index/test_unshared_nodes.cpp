// SPDX-License-Identifier: MIT
// Nodes that only one of two sets of indices has, against comparing all of them.
#include "index/unshared_nodes.h"

#include <gtest/gtest.h>

#include <set>

#include "index/edit_nodes.h"
#include "tests/index/test_nodes.h"

namespace firma {
namespace {

using Roots = std::vector<const Node*>;

std::unordered_set<const Node*> all_below(const Roots& roots) {
    std::unordered_set<const Node*> all;
    for (const Node* root : roots) test::collect(*root, all);
    return all;
}

std::set<const Node*> missing(const Roots& from, const Roots& in) {
    const auto here = all_below(from), there = all_below(in);
    std::set<const Node*> found;
    for (const Node* node : here)
        if (!there.contains(node)) found.insert(node);
    return found;
}

void expect_as_compared(const Roots& before, const Roots& after) {
    const UnsharedNodes found = unshared_nodes(before, after);
    EXPECT_EQ(std::set<const Node*>(found.before.begin(), found.before.end()), missing(before, after));
    EXPECT_EQ(std::set<const Node*>(found.after.begin(), found.after.end()), missing(after, before));
    EXPECT_EQ(found.before.size(), missing(before, after).size()) << "each once";
    EXPECT_EQ(found.after.size(), missing(after, before).size()) << "each once";
}

std::vector<Ref<const Node>> random_leaves(std::size_t count, scenes::Rng& rng) {
    std::vector<Ref<const Node>> leaves;
    for (std::size_t k = 0; k < count; ++k)
        leaves.push_back(test::leaf_of(test::random_box(rng, 1 << 24, 1 << 18), 1 + rng.below(64)));
    return leaves;
}

TEST(UnsharedNodes, OfNothingAndOfTheSame) {
    scenes::Rng rng(1);
    const std::vector<Ref<const Node>> leaves = random_leaves(300, rng);
    const Ref<const Node> root = join_nodes(leaves);
    expect_as_compared({}, {});
    expect_as_compared({root.get()}, {});
    expect_as_compared({}, {root.get()});
    const UnsharedNodes same = unshared_nodes(Roots{root.get()}, Roots{root.get()});
    EXPECT_TRUE(same.before.empty());
    EXPECT_TRUE(same.after.empty());
}

TEST(UnsharedNodes, AfterEditsWhateverLevelsNodesCameTo) {
    scenes::Rng rng(2);
    for (int round = 0; round < 60; ++round) {
        std::vector<Ref<const Node>> leaves = random_leaves(1 + rng.below(round % 5 == 0 ? 3000 : 300), rng);
        const Ref<const Node> before = join_nodes(leaves);
        Ref<const Node> now = before;
        for (std::uint32_t edits = 1 + rng.below(6); edits > 0; --edits) {
            NodeEdit edit(now);
            for (std::uint32_t k = rng.below(20); k > 0 && !leaves.empty(); --k) {
                const std::size_t at = rng.below(std::uint32_t(leaves.size()));
                edit.remove(leaves[at]->facets.get(), test::facets_of(leaves[at])->box);
                leaves.erase(leaves.begin() + std::ptrdiff_t(at));
            }
            for (std::uint32_t k = rng.below(round % 7 == 0 ? 400 : 20); k > 0; --k) {
                leaves.push_back(test::leaf_of(test::random_box(rng, 1 << 24, 1 << 18), 1 + rng.below(64)));
                edit.add(leaves.back());
            }
            while (edit.step()) {
            }
            now = edit.result();
        }
        expect_as_compared(before ? Roots{before.get()} : Roots{}, now ? Roots{now.get()} : Roots{});
        if (testing::Test::HasFailure()) return;
    }
}

TEST(UnsharedNodes, OfSeveralIndicesInAnyOrderOverTheSameLeaves) {
    scenes::Rng rng(3);
    const std::vector<Ref<const Node>> leaves = random_leaves(900, rng);
    // One over all, and others over some: leaves stand below several roots.
    const Ref<const Node> all = join_nodes(leaves);
    const auto some = [&](std::size_t from, std::size_t to) {
        return join_nodes(std::span(leaves).subspan(from, to - from));
    };
    const Ref<const Node> a = some(0, 300), b = some(200, 500), c = some(500, 900), d = some(450, 451);
    expect_as_compared({all.get()}, {a.get(), b.get(), c.get()});
    expect_as_compared({all.get(), d.get()}, {d.get(), c.get(), a.get()});
    expect_as_compared({a.get(), b.get()}, {b.get(), a.get()});
    expect_as_compared({c.get(), d.get(), d.get()}, {b.get()});
    expect_as_compared({a.get(), b.get(), a.get()}, {c.get(), c.get()});
}

}  // namespace
}  // namespace firma

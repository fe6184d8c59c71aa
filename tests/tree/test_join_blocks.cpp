// SPDX-License-Identifier: MIT
// Blocks put together: each exactly once, in groups that are not too large, small ones merged where something is new.
#include "tree/join_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/rng.h"
#include "tree/build_blocks.h"

namespace firma {
namespace {

/// A leaf block of so many triangles, somewhere.
Ref<const Block> leaf(std::uint32_t faces, scenes::Rng& rng) {
    FaceSet set;
    std::int32_t at[3];
    for (std::int32_t& a : at) a = std::int32_t(rng.below(1 << 24));
    for (std::uint32_t k = 0; k < faces; ++k) {
        FaceSet::Entry face;
        face.id = {k};
        face.first_corner = std::uint32_t(set.corners.size());
        face.corner_count = 3;
        for (int c = 0; c < 3; ++c) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            const auto x = std::int32_t(rng.below(1 << 16));
            const auto y = std::int32_t(rng.below(1 << 16));
            set.vertices.push_back({at[0] + x, at[1] + y, at[2]});
        }
        set.faces.push_back(face);
    }
    return build_blocks(set, {});
}

struct Items {
    std::vector<Ref<const Block>> blocks;
    std::vector<BlockItem> items;

    explicit Items(std::size_t count, std::uint32_t faces) {
        scenes::Rng rng(5);
        for (std::size_t k = 0; k < count; ++k) blocks.push_back(leaf(faces, rng));
        for (const Ref<const Block>& block : blocks) items.push_back(BlockItem::of(*block, false));
    }
};

TEST(JoinBlocks, GroupsHoldEachItemOnceAndAreNotTooLarge) {
    const Items of(200, 20);
    BlockJoiner joiner;
    joiner.divide(of.items);
    std::vector<std::uint32_t> nodes;
    joiner.group(kBlockItems, nodes);
    EXPECT_GT(nodes.size(), 3u);
    std::vector<const Block*> joined, all;
    for (const std::uint32_t node : nodes) {
        ASSERT_LE(joiner.count_below(node), kBlockItems);
        const Ref<const Block> block = joiner.join(of.items, node);
        ASSERT_EQ(block->children.size(), joiner.count_below(node));
        EXPECT_EQ(block->faces_below, 20 * block->children.size());
        for (const Ref<const Block>& child : block->children) joined.push_back(child.get());
    }
    for (const Ref<const Block>& block : of.blocks) all.push_back(block.get());
    std::sort(all.begin(), all.end());
    std::sort(joined.begin(), joined.end());
    EXPECT_EQ(joined, all);
}

TEST(JoinBlocks, SmallOnesMergeWhereOneIsNew) {
    Items of(40, 8);
    of.items[11].is_new = true;
    BlockJoiner joiner;
    joiner.divide(of.items);
    scenes::Rng rng(6);
    std::vector<Ref<const Block>> made;
    std::vector<std::uint32_t> merged;
    joiner.merge(of.items, 32, [&](std::uint32_t node) {
        joiner.for_each_below(node, [&](std::uint32_t item) { merged.push_back(item); });
        made.push_back(leaf(std::uint32_t(8 * merged.size()), rng));
        return BlockItem::of(*made.back(), true);
    });
    ASSERT_EQ(made.size(), 1u) << "one group holds the new one";
    EXPECT_GE(merged.size(), 2u);
    EXPECT_LE(merged.size(), 4u) << "of 32 faces at most";
    EXPECT_TRUE(std::find(merged.begin(), merged.end(), 11u) != merged.end());
    std::vector<std::uint32_t> nodes;
    joiner.group(kBlockItems, nodes);
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_EQ(joiner.count_below(0), 40 - merged.size() + 1);
    const Ref<const Block> block = joiner.join(of.items, 0);
    EXPECT_EQ(block->children.size(), 40 - merged.size() + 1);
    EXPECT_EQ(block->faces_below, 320u);
}

TEST(JoinBlocks, NothingMergesWhereNothingIsNew) {
    Items of(40, 2);
    BlockJoiner joiner;
    joiner.divide(of.items);
    joiner.merge(of.items, 32, [&](std::uint32_t) {
        ADD_FAILURE() << "nothing is new";
        return of.items[0];
    });
    EXPECT_EQ(of.items.size(), 40u);
}

}  // namespace
}  // namespace firma

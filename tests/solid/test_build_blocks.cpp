// SPDX-License-Identifier: MIT
// The index: stop rules, blocks of up to 64 items, and what happens when nothing can be divided.
#include "solid/build_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "index/statistics.h"
#include "scenes/rng.h"
#include "solid/append_faces.h"
#include "tests/index/wide_contents.h"

namespace firma {
namespace {

FaceSet random_faces(std::uint32_t count, std::int32_t spread, std::int32_t size) {
    scenes::Rng rng(41);
    FaceSet set;
    for (std::uint32_t k = 0; k < count; ++k) {
        const auto offset = [&](std::int32_t range) {
            return std::int32_t(rng.uniform(-range, range)) * kSurfacePerInput;
        };
        const GridPoint middle{offset(spread), offset(spread), offset(spread)};
        FaceSet::Entry face;
        face.id = {k};
        face.first_corner = std::uint32_t(set.corners.size());
        face.corner_count = 3;
        for (int c = 0; c < 3; ++c) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back({middle.x + offset(size), middle.y + offset(size), middle.z + offset(size)});
        }
        set.faces.push_back(face);
    }
    return set;
}

/// Of faces of one part.
Ref<const Node> index_over(const FaceSet& faces, const TreeOptions& options) {
    const std::vector<PartIndex> parts = build_blocks(faces, options);
    EXPECT_EQ(parts.size(), 1u);
    return parts.at(0).root;
}

std::size_t count_faces(const Node& root) {
    std::vector<int> seen;
    for_each_block(root, [&](const Block& block) {
        EXPECT_LE(block.faces.size(), kNodeItems);
        for (const FaceRecord& face : block.faces) {
            if (face.id.value >= seen.size()) seen.resize(face.id.value + 1, 0);
            ++seen[face.id.value];
        }
    });
    for (const int times : seen) EXPECT_EQ(times, 1);
    return seen.size();
}

TEST(BuildBlocks, NoFacesNoTree) {
    EXPECT_FALSE(BlockBuilder().build({}, {}));
    EXPECT_TRUE(build_blocks({}, {}).empty());
}

TEST(BuildBlocks, HoldsEachFaceOnceInBlocksOfUpTo64) {
    for (const Split split : {Split::kLongestAxis, Split::kSurfaceArea})
        for (const std::uint32_t count : {1u, 2u, 63u, 64u, 65u, 1000u, 20000u}) {
            const Ref<const Node> root = index_over(random_faces(count, 100000, 2000), {.split = split});
            EXPECT_EQ(count_faces(*root), count);
            const TreeStatistics statistics = tree_statistics(*root);
            EXPECT_EQ(statistics.faces, count);
            EXPECT_LE(statistics.max_leaf_faces, 8u);
            EXPECT_LE(statistics.depth, 40);
            EXPECT_GE(statistics.blocks, (count + 63) / 64);
        }
}

TEST(BuildBlocks, StopRules) {
    const FaceSet faces = random_faces(5000, 100000, 2000);
    for (const int per_leaf : {1, 4, 8, 9, 16, 17, 64}) {
        const TreeStatistics statistics = tree_statistics(*index_over(faces, {.faces_per_leaf = per_leaf}));
        const std::size_t most = std::size_t(per_leaf + 7) / 8 * 8;
        EXPECT_LE(statistics.max_leaf_faces, most) << per_leaf;
        EXPECT_GT(statistics.max_leaf_faces, most - 8) << per_leaf;
        EXPECT_GE(statistics.leaves, 5000 / most) << per_leaf;
    }
    EXPECT_GT(tree_statistics(*index_over(faces, {.max_depth = 8})).max_leaf_faces, 8u);
    EXPECT_LE(tree_statistics(*index_over(faces, {.max_depth = 8})).depth, 8);
    const std::size_t all = tree_statistics(*index_over(faces, {})).nodes;
    const std::size_t coarse = tree_statistics(*index_over(faces, {.min_node_volume = 2000})).nodes;
    EXPECT_LT(coarse, all / 2);
    EXPECT_EQ(count_faces(*index_over(faces, {.max_depth = -5, .faces_per_leaf = -5})), 5000u)
        << "nonsense counts as the nearest end";
}

/// Triangles of ten metres in two walls, a kilometre apart.
FaceSet two_walls() {
    FaceSet set;
    constexpr auto kMetre = std::int32_t(kSurfaceSteps);
    for (std::int32_t k = 0; k < 8; ++k) {
        const GridPoint corner{k / 4 * 1000 * kMetre, k % 4 * 10 * kMetre, 0};
        FaceSet::Entry face;
        face.id = {std::uint32_t(k)};
        const GridPoint corners[] = {
            corner, {corner.x, corner.y + 10 * kMetre, 0}, {corner.x, corner.y, 10 * kMetre + k}};
        add_facet(set, corners, face);
    }
    return set;
}

TEST(BuildBlocks, FewFacesAreDividedBySurfaceAreaWhereTheyLieApart) {
    EXPECT_EQ(tree_statistics(*index_over(two_walls(), {})).max_leaf_faces, 4u);
    EXPECT_EQ(tree_statistics(*index_over(two_walls(), {.max_depth = 0})).max_leaf_faces, 8u) << "a rule to stop";
    EXPECT_EQ(tree_statistics(*index_over(two_walls(), {.min_node_volume = 1e9})).max_leaf_faces, 8u);
    EXPECT_EQ(tree_statistics(*index_over(two_walls(), {.split = Split::kLongestAxis})).max_leaf_faces, 8u);
}

/// Lanes that say they have all of a triangle, of those that hold the faces.
std::size_t count_whole(const Node& root) {
    std::size_t whole = 0;
    for_each_block(root, [&](const Block& block) {
        for (std::size_t at = 0; at < block.lanes.size(); at += block.lanes[at].in_a_row())
            for (std::uint32_t lane = 0; lane < block.lanes[at].count(); ++lane)
                whole += block.lanes[at].whole >> lane & 1;
    });
    return whole;
}

TEST(BuildBlocks, LanesHaveTrianglesWholeUnlessTheirNormalsNeedMoreThanDouble) {
    // Of a corner that 16 bits cannot hold, which is as far from the origin as it is from the corner opposite.
    const auto whole_at = [](std::int32_t size) {
        FaceSet set;
        const GridPoint corners[] = {{1, 0, 0}, {2 * size + 1, 2 * size, 0}, {2 * size, 0, 2 * size + 1}};
        add_facet(set, corners, {});
        return count_whole(*index_over(set, {}));
    };
    constexpr std::int32_t kMost = 1 << 25;
    EXPECT_EQ(whole_at(1 << 12), 1u);
    EXPECT_EQ(whole_at(kMost - 1), 1u) << "256 m across";
    EXPECT_EQ(whole_at(kMost + 1), 0u);

    // 2 km across, in steps of 16 m: 16 bits hold that.
    FaceSet set;
    constexpr std::int32_t kStep = 1 << 22;
    const GridPoint corners[] = {{-60 * kStep, 0, 0}, {60 * kStep, 120 * kStep, 0}, {0, 0, 120 * kStep}};
    add_facet(set, corners, {});
    EXPECT_EQ(count_whole(*index_over(set, {})), 1u);
}

TEST(BuildBlocks, TooFullABinIsHalvedByCountUntilItFitsABlock) {
    const TreeStatistics statistics = tree_statistics(*index_over(random_faces(5000, 100000, 2000), {.max_depth = 0}));
    EXPECT_LE(statistics.max_leaf_faces, 64u);
    EXPECT_LE(statistics.depth, 7);
}

TEST(BuildBlocks, CoincidingCentresAreWellBehaved) {
    FaceSet faces = random_faces(10000, 1, 1000);
    for (FaceSet::Entry& face : faces.faces) {  // all triangles in one place
        for (int c = 0; c < 3; ++c) faces.corners[face.first_corner + std::uint32_t(c)] = std::uint32_t(c);
    }
    for (const Split split : {Split::kLongestAxis, Split::kSurfaceArea}) {
        const Ref<const Node> root = index_over(faces, {.split = split});
        EXPECT_EQ(count_faces(*root), 10000u);
        EXPECT_LE(tree_statistics(*root).depth, 14) << "halved by count";
    }
}

TEST(BuildBlocks, SameFacesSameTree) {
    const FaceSet faces = random_faces(3000, 100000, 2000);
    const Ref<const Node> a = index_over(faces, {}), b = index_over(faces, {});
    std::vector<std::uint32_t> ids_a, ids_b;
    for_each_block(*a, [&](const Block& block) {
        for (const FaceRecord& f : block.faces) ids_a.push_back(f.id.value);
    });
    for_each_block(*b, [&](const Block& block) {
        for (const FaceRecord& f : block.faces) ids_b.push_back(f.id.value);
    });
    EXPECT_EQ(ids_a, ids_b);
}

TEST(BuildBlocks, EachPartHasBlocksAndAnIndexOfItsOwn) {
    FaceSet faces = random_faces(3000, 100000, 2000);
    for (FaceSet::Entry& face : faces.faces) face.part = face.id.value * 7 % 5 * 10;  // as they come, mixed
    const std::vector<PartIndex> parts = build_blocks(faces, {});
    ASSERT_EQ(parts.size(), 5u);
    std::vector<int> seen(3000, 0);
    for (std::uint32_t k = 0; k < 5; ++k) {
        EXPECT_EQ(parts[k].part, 10 * k) << "ascending";
        EXPECT_EQ(parts[k].root->facets_below, 600u);
        for_each_block(*parts[k].root, [&](const Block& block) {
            EXPECT_EQ(block.part, 10 * k);
            for (const FaceRecord& face : block.faces) {
                EXPECT_EQ(face.id.value * 7 % 5 * 10, 10 * k);
                ++seen[face.id.value];
                const FaceSet::Entry& entry = faces.faces[face.id.value];
                for (std::uint32_t c = 0; c < 3; ++c) EXPECT_EQ(block.corner(face, c), faces.corner(entry, c));
            }
        });
    }
    EXPECT_EQ(seen, std::vector<int>(3000, 1));
}

void add_contents(const Node& node, std::vector<std::uint64_t>& all) {
    test::add_wide_contents(node, all);
    for (const Ref<const Node>& child : node.children) add_contents(*child, all);
}

bool same_index(const Node& a, const Node& b) {
    std::vector<std::uint64_t> mine, its;
    add_contents(a, mine);
    add_contents(b, its);
    return mine == its;
}

/// Casts by room go through the index of a part: above blocks it is divided by surface area, as edits do, whatever the
/// options say of what lies below.
TEST(BuildBlocks, AnIndexOfOnePartOfSeveralIsDividedBySurfaceAreaAboveBlocks) {
    for (const std::uint32_t count : {5000u, 64u}) {
        FaceSet alone = random_faces(count, 100000, 8000), one_of_two = alone;
        one_of_two.faces.push_back(alone.faces[0]);
        one_of_two.faces.back().part = 1;
        const TreeOptions halves{.split = Split::kLongestAxis};
        const Ref<const Node> root = build_blocks(one_of_two, halves)[0].root;
        EXPECT_EQ(count_faces(*root), count);
        EXPECT_TRUE(same_index(*root, *BlockBuilder().build(alone, halves, kNodeItems)));
        EXPECT_EQ(same_index(*root, *index_over(alone, halves)), count <= kNodeItems) << "a block has nothing above it";
    }
}

}  // namespace
}  // namespace firma

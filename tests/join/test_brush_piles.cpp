// SPDX-License-Identifier: MIT
// Piles of brushes of every kind, joined and judged.
#include <gtest/gtest.h>

#include "firma/brush_world.h"
#include "firma/rooms.h"
#include "scenes/brush_piles.h"
#include "tests/reference/judge_joined.h"

namespace firma {
namespace {

class BrushPiles : public testing::TestWithParam<int> {};

TEST_P(BrushPiles, BecomeSoundWorldsOfTheRightVolume) {
    const auto kind = scenes::BrushPile(GetParam());
    const bool cheap = kind != scenes::BrushPile::kCrystals;
    int moved = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const BrushLevel level = scenes::brush_pile(kind, seed, cheap ? 12 : 6);
        const reference::JoinedVerdict verdict = reference::judge_joined(level, seed, 60);
        EXPECT_EQ(verdict.fault, "") << "pile " << GetParam() << ", seed " << seed;
        moved += verdict.planes_moved > 0 || verdict.left_out > 0;
    }
    EXPECT_LE(moved, kind == scenes::BrushPile::kSlivers ? 6 : 1);
}

TEST_P(BrushPiles, OfManyBrushesToo) {
    const auto kind = scenes::BrushPile(GetParam());
    for (std::uint64_t seed = 101; seed <= 103; ++seed) {
        const reference::JoinedVerdict verdict = reference::judge_joined(scenes::brush_pile(kind, seed, 60), seed, 100,
                                                                         kind != scenes::BrushPile::kCrystals);
        EXPECT_EQ(verdict.fault, "") << "pile " << GetParam() << ", seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(All, BrushPiles, testing::Range(0, scenes::kBrushPiles));

TEST(BrushPiles, HallsHaveARoomForEach) {
    const Result<World> world = make_world(scenes::brush_pile(scenes::BrushPile::kHalls, 3, 32));
    ASSERT_TRUE(world.ok());
    EXPECT_GE(world.value().room_count(), 4u);
    EXPECT_GE(portal_count(world.value()), 2u);
}

TEST(BrushPiles, TheSameOverAgain) {
    const BrushLevel level = scenes::brush_pile(scenes::BrushPile::kWedges, 5, 30);
    EXPECT_EQ(hash_world(make_world(level).value()), hash_world(make_world(level).value()));
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// No id, hash, edit or saved byte depends on an index: the same cuts under different trees, and with the index built
// anew in between. ./test --full makes a thousand.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/level.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "scenes/level_cuts.h"
#include "tests/reference/judge_index.h"
#include "tests/sample.h"

namespace firma {
namespace {

constexpr std::size_t kCuts = test::sample(100);

void expect_agrees(const reference::IndexTally& tally, std::size_t cuts, std::size_t done) {
    EXPECT_EQ(tally.cuts, cuts);
    EXPECT_EQ(tally.failed, 0u);
    for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
    EXPECT_GE(tally.done, done);
    EXPECT_GE(tally.packed, cuts / 16 * 4);
    EXPECT_EQ(tally.rebuilds, cuts);
}

TEST(IndexIsFree, AHundredCutsInOurLevel) {
    const Level ours = read_level(FIRMA_ROOT "/levels/first.obj").value();
    const auto make = [&](const TreeOptions& tree) { return make_world(ours, {.tree = tree}).value(); };
    expect_agrees(reference::judge_index(make, reference::cuts_of_our_level(ours, 3, kCuts)), kCuts, kCuts * 3 / 5);
}

TEST(IndexIsFree, AHundredCutsInTheDepotWithItsRooms) {
    const BrushLevel level = read_brush_level(FIRMA_ROOT "/levels/depot.map").value();
    const auto make = [&](const TreeOptions& tree) { return make_world(level, {.tree = tree}).value(); };
    const World world = make({});
    EXPECT_GT(world.room_count(), 1u);
    EXPECT_GT(portal_count(world), 0u);
    const scenes::CutPlaces places = scenes::cut_places(world);
    std::vector<scenes::CutOrder> cuts;
    for (std::uint64_t index = 0; cuts.size() < kCuts; ++index)
        for (std::size_t kind = 0; kind < scenes::kLevelCutNames.size(); ++kind) {
            std::vector<scenes::CutOrder> some = scenes::level_cuts(places, scenes::LevelCuts(kind), 5, index);
            some.resize(std::min<std::size_t>(some.size(), 4));
            for (scenes::CutOrder& order : some) cuts.push_back(std::move(order));
        }
    cuts.resize(kCuts);
    expect_agrees(reference::judge_index(make, cuts), kCuts, kCuts / 2);
}

TEST(IndexIsFree, AFileWithoutItHasNothingOfTheTreesOptions) {
    const Level ours = read_level(FIRMA_ROOT "/levels/first.obj").value();
    const World one = make_world(ours).value();
    const World other = make_world(ours, {.tree = {.split = Split::kSurfaceArea, .faces_per_leaf = 9}}).value();
    const std::vector<std::byte> bytes = pack_world(one, {.index = false});
    EXPECT_EQ(bytes, pack_world(other, {.index = false}));
    EXPECT_NE(pack_world(one), pack_world(other));
    const World read = unpack_world(bytes, "bytes").value();
    EXPECT_EQ(hash_world(read), hash_world(other));
    EXPECT_FALSE(check_world(read));
}

}  // namespace
}  // namespace firma

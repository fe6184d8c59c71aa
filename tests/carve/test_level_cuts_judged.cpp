// SPDX-License-Identifier: MIT
// A few cuts of every kind in levels of brushes, each judged by all that must hold after an edit; ./test --full makes
// thousands, in more maps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "scenes/level_cuts.h"
#include "tests/openarena_maps.h"
#include "tests/reference/judge_cut.h"
#include "tests/sample.h"

namespace firma {
namespace {

/// A level made into a world twice, in memory laid out otherwise.
struct Twice {
    World world, again;
    scenes::CutPlaces places;

    explicit Twice(const std::string& path) {
        const BrushLevel level = read_brush_level(path).value();
        world = make_world(level).value();
        again = make_world(level).value();
        places = scenes::cut_places(world);
    }
};

constexpr reference::JudgeOptions kLevelSample{12, 8, 3, 0.2, true, 3};

void expect_holds(const reference::CutTally& tally) {
    EXPECT_EQ(tally.failed, 0u);
    for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
    EXPECT_EQ(tally.replayed, tally.cuts);
    EXPECT_EQ(tally.cuts, tally.done + tally.nothing + tally.refused);
}

reference::CutTally judge_kind(const Twice& level, std::size_t kind, const reference::JudgeOptions& options) {
    const auto cuts = scenes::level_cuts(level.places, scenes::LevelCuts(kind), 1, 0);
    return reference::judge_cuts(level.world, level.again, cuts, std::string(scenes::kLevelCutNames[kind]), 1, options);
}

TEST(LevelCuts, InTheDepotHoldEveryInvariant) {
    const Twice depot(FIRMA_ROOT "/levels/depot.map");
    reference::CutTally all;
    for (std::size_t kind = 0; kind < scenes::kLevelCutNames.size(); ++kind) {
        SCOPED_TRACE(scenes::kLevelCutNames[kind]);
        const reference::CutTally tally = judge_kind(depot, kind, kLevelSample);
        expect_holds(tally);
        EXPECT_GE(tally.done, 1u);
        all.add(tally);
    }
    EXPECT_GE(all.done, 16u);
    EXPECT_GE(all.holed, 1u);
    EXPECT_GE(all.crossings, 1u);
    EXPECT_GE(all.room_casts, 50u);
    EXPECT_GE(all.points, 20u);
    EXPECT_GE(all.rays, 50u);
}

TEST(LevelCuts, InFiveMapsOfOpenArenaHoldEveryInvariant) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    if (maps.empty()) GTEST_SKIP() << kNoOpenArena;
    std::size_t next_kind = 0;
    std::array<std::size_t, scenes::kLevelCutNames.size()> done_of_kind{};
    for (const std::string name : std::span(kRoomMaps).first(test::sample(kCarvedMaps))) {
        const auto path = std::find_if(maps.begin(), maps.end(), [&](const auto& it) { return it.stem() == name; });
        ASSERT_NE(path, maps.end()) << name;
        const Twice map(path->string());
        reference::JudgeOptions options = kLevelSample;
        options.most_cuts = 2;
        std::size_t done = 0;
        // Three kinds a map: in all five each kind once at least.
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t kind = next_kind++ % scenes::kLevelCutNames.size();
            SCOPED_TRACE(name + " " + std::string(scenes::kLevelCutNames[kind]));
            const reference::CutTally tally = judge_kind(map, kind, options);
            expect_holds(tally);
            done += tally.done;
            done_of_kind[kind] += tally.done;
        }
        EXPECT_GE(done, 3u) << name;
    }
    for (std::size_t kind = 0; kind < std::min(next_kind, done_of_kind.size()); ++kind)
        EXPECT_GE(done_of_kind[kind], 1u) << scenes::kLevelCutNames[kind];
}

TEST(LevelCuts, SameSeedsMakeSameCuts) {
    const World world = make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value();
    const scenes::CutPlaces places = scenes::cut_places(world), again = scenes::cut_places(world);
    EXPECT_FALSE(places.inside.faces.empty());
    EXPECT_FALSE(places.outside.faces.empty());
    EXPECT_GE(places.portals.size(), 35u);
    for (std::size_t kind = 0; kind < scenes::kLevelCutNames.size(); ++kind) {
        const auto a = scenes::level_cuts(places, scenes::LevelCuts(kind), 5, 3);
        const auto b = scenes::level_cuts(again, scenes::LevelCuts(kind), 5, 3);
        const auto c = scenes::level_cuts(places, scenes::LevelCuts(kind), 5, 4);
        ASSERT_GE(a.size(), 12u);
        ASSERT_EQ(a.size(), b.size());
        EXPECT_EQ(a[1].pose.position, b[1].pose.position);
        EXPECT_NE(a[1].pose.position, c[1].pose.position);
    }
}

}  // namespace
}  // namespace firma

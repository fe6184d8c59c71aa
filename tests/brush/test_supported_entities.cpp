// SPDX-License-Identifier: MIT
// Entities of levels that something holds: which count, where they stand, what shots take from them in the depot.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "firma/brush_parts.h"
#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/support.h"
#include "tests/brush/depot_level.h"
#include "tests/brush/map_text.h"
#include "tests/openarena_maps.h"

namespace firma {
namespace {

std::string entity_text(const std::string& classname, const std::string& origin, const std::string& more = "") {
    return "{\n\"classname\" \"" + classname + "\"\n\"origin\" \"" + origin + "\"\n" + more + "}\n";
}

/// A hall of 512 x 512 x 256 units in rock, with entities.
BrushLevel hall_with(const std::string& entities) {
    const auto wall = [](const Vec3& low, const Vec3& high) { return map_text::box(low, high, "rock"); };
    return read_map(map_text::world(wall({-272, -272, -16}, {272, 272, 0}) + wall({-272, -272, 256}, {272, 272, 272}) +
                                    wall({-272, -272, 0}, {-256, 272, 256}) + wall({256, -272, 0}, {272, 272, 256}) +
                                    wall({-256, -272, 0}, {256, -256, 256}) + wall({-256, 256, 0}, {256, 272, 256})) +
                        entities,
                    "hall.map")
        .value();
}

Supports supports_in(const BrushLevel& level) {
    const BrushParts parts = make_brush_parts(level).value();
    return find_supports(make_world(level).value(), supported_entities(level, parts)).value();
}

TEST(SupportedEntities, ClassesThatCount) {
    const std::string door =
        "{\n\"classname\" \"func_door\"\n" + map_text::box({-40, -4, 0}, {40, 4, 100}, "door") + "}\n";
    const std::string shelf =
        "{\n\"classname\" \"func_breakable\"\n" + map_text::box({200, 100, 50}, {255, 140, 54}, "wood") + "}\n";
    const Supports held = supports_in(hall_with(
        entity_text("info_player_start", "0 100 60") + entity_text("item_health", "100 0 128") +
        entity_text("weapon_railgun", "100 50 128", "\"spawnflags\" \"1\"\n") + entity_text("light", "-120 -120 240") +
        entity_text("light", "0 0 128") + entity_text("target_position", "0 0 10") +
        entity_text("info_player_intermission", "0 0 40") + entity_text("team_CTF_redflag", "-100 0 30") +
        entity_text("team_CTF_redplayer", "-100 50 30") + door + shelf + "{\n\"classname\" \"item_armor\"\n}\n"));
    const auto find = [&](std::uint32_t number) {
        const auto it = std::find_if(held.things.begin(), held.things.end(),
                                     [&](const Support& support) { return support.thing.entity == number; });
        return it == held.things.end() ? nullptr : &*it;
    };
    constexpr double kMetres = 1.0 / 32, kFootprint = 30 * 30 * kMetres * kMetres;
    EXPECT_EQ(held.things.size(), 8u);
    EXPECT_NEAR(find(1)->lowered, 36 * kMetres, 1e-9);
    EXPECT_NEAR(find(1)->area, kFootprint, 1e-9);
    EXPECT_NEAR(find(2)->lowered, 113 * kMetres, 1e-9);
    EXPECT_EQ(find(3), nullptr) << "it floats";
    EXPECT_NEAR(find(4)->area, 64 * kMetres * kMetres, 1e-9) << "12 units below the ceiling";
    EXPECT_EQ(find(5)->area, 0) << "in the middle of the air";
    EXPECT_EQ(find(6), nullptr);
    EXPECT_EQ(find(7), nullptr);
    EXPECT_NEAR(find(8)->lowered, 15 * kMetres, 1e-9);
    EXPECT_NEAR(find(9)->lowered, 6 * kMetres, 1e-9);
    EXPECT_NEAR(find(10)->area, 80 * 8 * kMetres * kMetres, 1e-9) << "the door stands on the floor";
    EXPECT_NEAR(find(11)->area, 40 * 4 * kMetres * kMetres, 1e-9) << "the shelf is a unit from the wall";
}

/// A lamp at a ceiling and a crate on the bridge, by the diff of the shots that take them away, and of the undo.
TEST(SupportedEntities, ShotsInTheDepot) {
    const BrushLevel level = test::depot_level();
    const World depot = with_anchors(make_world(level).value());
    std::vector<SupportedThing> things = supported_entities(level, make_brush_parts(level).value());
    SupportedThing crate;
    crate.entity = 1'000'000;
    crate.kind = SupportKind::kStands;
    crate.box = {{13.5, 6.5, 5}, {14.5, 7.5, 6}};  // over the middle of the bridge
    crate.reach = 4;
    things.push_back(crate);
    const Supports held = find_supports(depot, things).value();
    std::size_t players = 0, lamps = 0, lamp = 0;
    for (std::size_t k = 0; k + 1 < held.things.size(); ++k) {
        const std::string_view name = level.entities[held.things[k].thing.entity].value("classname");
        if (name.substr(0, 12) == "info_player_") {
            ++players;
            EXPECT_GT(held.things[k].area, 0.5) << k;
        }
        if (name != "light" || held.things[k].area == 0) continue;
        ++lamps;
        lamp = k;
    }
    EXPECT_GE(players, 12u);
    EXPECT_GE(lamps, 15u);
    EXPECT_NEAR(held.things.back().lowered, 1, 1e-3);
    EXPECT_NEAR(held.things.back().area, 1, 1e-6);

    // The bridge, shot at both ends: it falls as a chunk, and the crate has nothing under it.
    const Cutter blast = make_crater(CutterShape::kRocky, 1);
    CarveOptions options;
    options.chunks = ChunkOptions{.min_volume = 0.01, .density = 2400};
    World world = depot;
    Supports now = held;
    for (const double y : {1.0, 13.0}) {
        const CarveResult shot = carve(world, blast, {.position = {14, y, 3.75}, .scale = 3}, options);
        ASSERT_TRUE(shot.done());
        const SupportDiff diff = diff_supports(now, diff_worlds(world, shot.world), shot.world);
        const bool crate_told = std::any_of(diff.changes.begin(), diff.changes.end(),
                                            [](const SupportChange& it) { return it.entity == 1'000'000; });
        if (!shot.chunks.empty()) {
            ASSERT_TRUE(crate_told);
            EXPECT_EQ(diff.changes.back().loss, SupportLoss::kAll);
            EXPECT_EQ(diff.changes.back().after, 0);
        } else if (crate_told) {
            EXPECT_EQ(diff.changes.back().loss, SupportLoss::kNone);
        }
        now = diff.after;
        world = shot.world;
    }
    EXPECT_EQ(now.things.back().area, 0);

    // A lamp, with the ceiling above it.
    const Box& at = held.things[lamp].thing.box;
    const CarveResult shot = carve(world, blast, {.position = (at.low + at.high) * 0.5, .scale = 3}, options);
    ASSERT_TRUE(shot.done());
    const SupportDiff diff = diff_supports(now, diff_worlds(world, shot.world), shot.world);
    const auto told = std::find_if(diff.changes.begin(), diff.changes.end(),
                                   [&](const SupportChange& it) { return it.thing == lamp; });
    ASSERT_NE(told, diff.changes.end());
    EXPECT_EQ(told->loss, SupportLoss::kAll);

    const SupportDiff undone = diff_supports(diff.after, diff_worlds(shot.world, depot), depot);
    EXPECT_EQ(undone.after.things[lamp].faces, held.things[lamp].faces);
    EXPECT_EQ(undone.after.things.back().faces, held.things.back().faces);
}

/// Items and players of the maps stand on something.
TEST(SupportedEntities, InOpenArenaMaps) {
    std::size_t maps = 0, standing = 0, held = 0;
    for (const std::filesystem::path& path : openarena_maps()) {
        if (++maps > 3) break;
        const BrushLevel level = read_brush_level(path.string()).value();
        for (const Support& support : supports_in(level).things) {
            if (support.thing.kind != SupportKind::kStands) continue;
            ++standing;
            held += support.area > 0;
        }
    }
    if (maps == 0) GTEST_SKIP() << "no maps of OpenArena";
    EXPECT_GT(standing, 50u);
    EXPECT_GT(held * 10, standing * 9);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Entities as parts that move: what each class does by its keys, where parts stand, what is noted.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "firma/brush_parts.h"
#include "firma/moving_parts.h"
#include "firma/solid.h"
#include "tests/brush/map_text.h"

namespace firma {
namespace {

/// An entity of a class with keys, and one box, 2 x 1 x 3 m with units of metres, from (4, 0, 0).
std::string moving_entity(const std::string& classname, const std::string& keys, const std::string& more = "") {
    return "{\n\"classname\" \"" + classname + "\"\n" + keys + map_text::box({4, 0, 0}, {6, 1, 3}, "door") + more +
           "}\n";
}

std::string key(const std::string& name, const std::string& value) {
    return "\"" + name + "\" \"" + value + "\"\n";
}

BrushParts parts_of(const std::string& entities) {
    const std::string text = map_text::world(map_text::box({-9, -9, -2}, {9, 9, -1}, "floor")) + entities;
    return make_brush_parts(read_map(text, "test.map", {.scale = 1}).value()).value();
}

BrushPart part_of(const std::string& entities) {
    const BrushParts made = parts_of(entities);
    EXPECT_EQ(made.parts.size(), 1u);
    EXPECT_TRUE(made.notes.empty() || !made.notes[0].reason.empty());
    return made.parts.empty() ? BrushPart{} : made.parts[0];
}

void expect_near(const Vec3& got, const Vec3& wanted) {
    EXPECT_LT(length(got - wanted), 1e-9) << got.x << " " << got.y << " " << got.z;
}

TEST(BrushParts, DoorsSlideBySizeLessLip) {
    const BrushPart door =
        part_of(moving_entity("func_door", key("angle", "90") + key("speed", "2") + key("lip", "1")));
    EXPECT_EQ(door.entity, 1u);
    EXPECT_TRUE(door.waits_for_trigger);
    EXPECT_EQ(door.when_blocked, WhenBlocked::kReturns);
    EXPECT_EQ(door.world.bounds().low, (Vec3{4, 0, 0}));
    EXPECT_EQ(door.world.bounds().high, (Vec3{6, 1, 3}));
    // 1 m deep, 2 units more by the engines' measure, less the lip: 2 m at 2 m/s, then 2 s, then back.
    expect_near(part_pose(door.path, 0).position, {0, 0, 0});
    expect_near(part_pose(door.path, 0.5).position, {0, 1, 0});
    expect_near(part_pose(door.path, 2.9).position, {0, 2, 0});
    expect_near(part_pose(door.path, 4).position, {0, 0, 0});
    const BrushPart up = part_of(moving_entity("func_door", key("angle", "-1") + key("lip", "0") + key("wait", "-1")));
    expect_near(part_pose(up.path, 1e6).position, {0, 0, 5});
    const BrushPart open = part_of(moving_entity("func_door", key("spawnflags", "5") + key("lip", "0")));
    expect_near(part_pose(open.path, 0).position, {4, 0, 0});
    EXPECT_EQ(open.when_blocked, WhenBlocked::kCrushes);
}

TEST(BrushParts, LiftsBeginBelowWhereTheyAreDrawn) {
    const BrushPart lift = part_of(moving_entity("func_plat", key("height", "6") + key("speed", "3")));
    expect_near(part_pose(lift.path, 0).position, {0, 0, -6});
    expect_near(part_pose(lift.path, 1).position, {0, 0, -3});
    expect_near(part_pose(lift.path, 2.5).position, {0, 0, 0});
}

TEST(BrushParts, WhatTurnsDoesSoAboutItsOriginBrush) {
    const std::string origin = map_text::box({3.5, 0.25, 1}, {4.5, 0.75, 2}, "common/origin");
    const BrushPart door =
        part_of(moving_entity("func_door_rotating", key("speed", "45") + key("distance", "90"), origin));
    EXPECT_EQ(door.world.bounds().low, (Vec3{0, -0.5, -1.5}));  // seen from (4, 0.5, 1.5)
    EXPECT_EQ(door.world.bounds().high, (Vec3{2, 0.5, 1.5}));
    const Pose open = part_pose(door.path, 2.1);
    expect_near(open.position, {4, 0.5, 1.5});
    expect_near(matrix_of(open.rotation) * Vec3{2, 0, 0}, {0, 2, 0});
    const BrushPart blade =
        part_of(moving_entity("func_rotating", key("speed", "90") + key("spawnflags", "4"), origin));
    expect_near(matrix_of(part_pose(blade.path, 1).rotation) * Vec3{0, 1, 0}, {0, 0, 1});
    const BrushParts bare = parts_of(moving_entity("func_rotating", ""));
    ASSERT_EQ(bare.notes.size(), 1u);
    EXPECT_EQ(bare.notes[0].entity, 1u);
    // The box that hangs 1.5 below its origin, in units of metres less than 8: as one of 8.
    const BrushPart swings = part_of(moving_entity("func_pendulum", key("speed", "10"), origin));
    const double quarter = 0.25 * 2 * std::numbers::pi / std::sqrt(800.0 / 24);
    const Vec3 tip = matrix_of(part_pose(swings.path, quarter).rotation) * Vec3{0, 0, -1};
    expect_near(tip, {0, std::sin(10 * std::numbers::pi / 180), -std::cos(10 * std::numbers::pi / 180)});
}

TEST(BrushParts, BobsTrainsAndWhatBreaks) {
    const BrushPart bob =
        part_of(moving_entity("func_bobbing", key("height", "2") + key("speed", "8") + key("phase", "0.25")));
    expect_near(part_pose(bob.path, 0).position, {0, 0, 2});
    expect_near(part_pose(bob.path, 2).position, {0, 0, 0});
    const auto corner = [](const std::string& name, const std::string& target, const std::string& place,
                           const std::string& more = "") {
        return "{\n" + key("classname", "path_corner") + key("targetname", name) + key("target", target) +
               key("origin", place) + more + "}\n";
    };
    const std::string origin = map_text::box({4, 0, 0}, {5, 1, 1}, "common/origin");
    const BrushPart train =
        part_of(moving_entity("func_train", key("target", "a") + key("speed", "2"), origin) +
                corner("a", "b", "1 2 3") + corner("b", "a", "5 2 3", key("wait", "1") + key("speed", "4")));
    EXPECT_TRUE(train.path.repeats);
    for (const double round : {0.0, 4.0, 400.0}) {
        expect_near(part_pose(train.path, round).position, {1, 2, 3});
        expect_near(part_pose(train.path, round + 1).position, {3, 2, 3});
        expect_near(part_pose(train.path, round + 2.5).position, {5, 2, 3});
        expect_near(part_pose(train.path, round + 3.5).position, {3, 2, 3});
    }
    const BrushPart ends = part_of(moving_entity("func_train", key("target", "a"), origin) + corner("a", "", "1 2 3"));
    expect_near(part_pose(ends.path, 1e9).position, {1, 2, 3});
    EXPECT_EQ(parts_of(moving_entity("func_train", key("target", "nowhere"), origin)).notes.size(), 1u);

    const BrushPart crate = part_of(moving_entity("func_breakable", key("health", "40")));
    EXPECT_TRUE(crate.breaks);
    EXPECT_EQ(crate.health, 40);
    EXPECT_TRUE(part_of(moving_entity("func_explosive", "")).breaks);
    EXPECT_EQ(parts_of(moving_entity("func_mystery", "")).notes.size(), 1u);
}

/// Brushes of one entity become one solid; triggers and portals make no part; bad keys are as none.
TEST(BrushParts, SolidsAreJoinedAndOthersAreNone) {
    const BrushPart two = part_of(moving_entity("func_door", "", map_text::box({6, 0, 0}, {7, 1, 3}, "door")));
    EXPECT_EQ(two.world.bounds().high, (Vec3{7, 1, 3}));
    EXPECT_EQ(two.world.face_count(), 6u);
    EXPECT_GT(two.world.solid().face_count(), 0u);
    EXPECT_TRUE(parts_of(moving_entity("trigger_multiple", "")).parts.empty());
    EXPECT_TRUE(parts_of(moving_entity("func_wall", "")).parts.empty());  // of the level itself
    const BrushPart odd =
        part_of(moving_entity("func_door", key("speed", "-3") + key("lip", "x") + key("angle", "1e400")));
    EXPECT_TRUE(is_finite(part_pose(odd.path, 1).position));
    EXPECT_EQ(make_brush_parts(BrushLevel{}).value().parts.size(), 0u);
}

/// A ball before a door that opens against it is met by the part as by any other.
TEST(BrushParts, CastsMeetThem) {
    const BrushPart door =
        part_of(moving_entity("func_door", key("angle", "90") + key("speed", "2") + key("lip", "1")));
    MovingPart part(door.world, part_motion(door.path, 0, 0.5));
    part.entity = door.entity;
    const World level;
    const PartHit hit = cast(Scene{level, {&part, 1}}, Sphere{{5, 1.75, 1}, 0.25}, {});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.surface_velocity, (Vec3{0, 1, 0}));
}

}  // namespace
}  // namespace firma

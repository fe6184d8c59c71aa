// SPDX-License-Identifier: MIT
// Bodies in worlds that are cut, filled, opened and shut: never through a wall, woken when the ground goes, out of
// what comes upon them.
#include <gtest/gtest.h>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/rooms.h"
#include "scenes/level_cuts.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/openarena_maps.h"
#include "tests/reference/judge_bodies.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using scenes::Rng;
using test::ball;
using test::body_here;
using test::box_body;
using test::ground;
using test::run;

using reference::random_body;

std::string depth_fault(const World& world, const Bodies& bodies) {
    return reference::BodyDepths().fault(world, bodies);
}

/// Two seconds.
void judge_in(const World& level, double rate, bool cut_meanwhile) {
    reference::BodyRun run;
    run.bodies = std::uint32_t(test::sample(100));
    run.seconds = 2;
    run.rate = rate;
    run.cut = cut_meanwhile;
    run.seed = 3;
    const reference::BodyVerdict verdict = reference::judge_bodies(level, run);
    EXPECT_EQ(verdict.fault, "") << rate << (cut_meanwhile ? ", cut meanwhile" : ", cut before");
    EXPECT_GT(verdict.bounces, run.bodies);
    EXPECT_GT(verdict.cuts, 2u);
}

TEST(BodiesInWorlds, NeverThroughAWallOfTheDepot) {
    for (const double rate : {60.0, 30.0})
        for (const bool cut : {false, true}) judge_in(test::depot_world(), rate, cut);
}

TEST(BodiesInWorlds, NeverThroughAWallOfAMap) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    const auto level = [&](const char* name) {
        const auto map = std::find_if(maps.begin(), maps.end(), [&](const auto& path) { return path.stem() == name; });
        return make_world(read_brush_level(map == maps.end() ? name : map->string()).value()).value();
    };
    if (maps.empty()) GTEST_SKIP() << kNoOpenArena;
    judge_in(level("kaos2"), 60, true);
    judge_in(level("oa_koth1"), 30, true);
}

TEST(BodiesInWorlds, ABodyInAWallIsTold) {
    const World world = ground();
    Bodies bodies;
    Body& body = *bodies.find(add_body(bodies, body_here(ball(0.2), {0, 0, 0.3})));
    EXPECT_EQ(depth_fault(world, bodies), "");
    body.position = {0, 0, 0.1985};
    EXPECT_EQ(depth_fault(world, bodies), "body 0: a sphere 0.001500 m deep");
    body.position = {0, 0, -1};
    EXPECT_EQ(depth_fault(world, bodies), "body 0: a centre in solid");
}

TEST(BodiesInWorlds, ABodyOutsideIsTold) {
    const World world = test::depot_world();
    Bodies bodies;
    Rng rng(6);
    const BodyId id = add_body(bodies, random_body(world, scenes::cut_places(world).inside, rng));
    EXPECT_EQ(reference::BodyDepths(true).fault(world, bodies), "");
    bodies.find(id)->position = world.bounds().high + Vec3{1, 0, 0};
    EXPECT_EQ(reference::BodyDepths(true).fault(world, bodies), "body 0: lost");
    EXPECT_EQ(reference::BodyDepths().fault(world, bodies), "");
}

TEST(BodiesInWorlds, TheSameBitsEachTimeAndFromASnapshot) {
    const World world = test::depot_world();
    const Level walls = scenes::cut_places(world).inside;
    Rng rng(4);
    Bodies bodies;
    for (int k = 0; k < 20; ++k) add_body(bodies, random_body(world, walls, rng));
    Bodies again = bodies;
    for (int k = 0; k < 60; ++k) step(bodies, world, 1.0 / 60);
    for (int k = 0; k < 30; ++k) step(again, world, 1.0 / 60);
    Bodies snapshot = again;
    for (int k = 0; k < 30; ++k) step(again, world, 1.0 / 60);
    EXPECT_EQ(hash_bodies(again), hash_bodies(bodies));
    for (int k = 0; k < 30; ++k) step(snapshot, world, 1.0 / 60);
    EXPECT_EQ(hash_bodies(snapshot), hash_bodies(bodies));
    snapshot.slots[0].velocity.x += 1e-9;
    EXPECT_NE(hash_bodies(snapshot), hash_bodies(bodies));
}

TEST(BodiesInWorlds, SleepersWakeWhenTheGroundIsCutAway) {
    World world = ground();
    Bodies bodies;
    const BodyId over = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.3}));
    const BodyId on_top = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.9}));
    run(bodies, world, 180);
    EXPECT_TRUE(bodies.find(over)->asleep);
    EXPECT_TRUE(bodies.find(on_top)->asleep);
    EXPECT_EQ(step(bodies, world, 1.0 / 60).awake, 0u);
    world = carve(world, make_crater(CutterShape::kBox, 0), test::pose_at(0, 0, 0, 1)).world;
    EXPECT_EQ(step(bodies, world, 1.0 / 60).woken, 2u);
    run(bodies, world, 240);
    EXPECT_NEAR(bodies.find(over)->position.z, -0.7, 0.01);
    EXPECT_TRUE(bodies.find(over)->asleep);
    EXPECT_EQ(depth_fault(world, bodies), "");
}

TEST(BodiesInWorlds, WhatFliesIntoASleeperWakesIt) {
    const World world = ground();
    Bodies bodies;
    const BodyId sleeper = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.3}));
    run(bodies, world, 120);
    ASSERT_TRUE(bodies.find(sleeper)->asleep);
    Body shot = body_here(ball(0.2), {-5, 0, 0.3});
    shot.velocity = {10, 0, 0};
    add_body(bodies, shot);
    run(bodies, world, 60);
    EXPECT_GT(bodies.find(sleeper)->position.x, 0.01);
    EXPECT_FALSE(bodies.find(sleeper)->asleep);
}

TEST(BodiesInWorlds, ABodyGoneWakesWhatRestedOnIt) {
    const World world = ground();
    Bodies bodies;
    const BodyId below = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.3}));
    const BodyId above = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.9}));
    run(bodies, world, 180);
    ASSERT_TRUE(bodies.find(above)->asleep);
    remove_body(bodies, below);
    run(bodies, world, 120);
    EXPECT_NEAR(bodies.find(above)->position.z, 0.3, 0.01);
}

TEST(BodiesInWorlds, OutOfWhatIsFilledInAroundThem) {
    World world = ground();
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(box_body({0.2, 0.2, 0.2}), {0, 0, 0.2}));
    run(bodies, world, 120);
    ASSERT_TRUE(bodies.find(id)->asleep);
    world = fill(world, make_crater(CutterShape::kBox, 0), test::pose_at(0.5, 0, 0, 1)).world;
    EXPECT_EQ(step(bodies, world, 1.0 / 60).stuck, 1u);
    run(bodies, world, 240);
    EXPECT_FALSE(bodies.find(id)->stuck);
    EXPECT_EQ(depth_fault(world, bodies), "");
    EXPECT_LT(length(bodies.find(id)->position), 2);
}

TEST(BodiesInWorlds, AShutDoorHoldsThemAndOpensUnderThem) {
    // A room 8 m high, divided half way up by a portal that lies flat.
    LevelPortal hatch;
    hatch.polygons.emplace_back();
    for (const Vec3& corner : {Vec3{-2, -2, 0}, Vec3{2, -2, 0}, Vec3{2, 2, 0}, Vec3{-2, 2, 0}})
        hatch.polygons[0].push_back(*snap(corner));
    const Result<World> made = make_divided_world(test::box_level({-2, -2, -4}, {2, 2, 4}, true), {&hatch, 1});
    ASSERT_TRUE(made.ok()) << made.error().text();
    ASSERT_EQ(portal_count(made.value()), 1u);
    const World shut = *set_portal_open(made.value(), {0}, false);
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(box_body({0.2, 0.2, 0.2}), {0, 0, 0.5}));
    run(bodies, shut, 180);
    EXPECT_NEAR(bodies.find(id)->position.z, 0.2, 0.005);
    EXPECT_TRUE(bodies.find(id)->asleep);
    const World open = *set_portal_open(shut, {0}, true);
    EXPECT_EQ(step(bodies, open, 1.0 / 60).woken, 1u);
    run(bodies, open, 180);
    EXPECT_NEAR(bodies.find(id)->position.z, -3.8, 0.005);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Bodies in worlds that are cut, filled, opened and shut: never through a wall, woken when the ground goes, out of
// what comes upon them.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/carve.h"
#include "firma/rooms.h"
#include "scenes/level_cuts.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
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

/// Deeper than the skin in what bounds solid, or a centre in it: "" where no sphere is.
std::string depth_fault(const World& world, const Bodies& bodies) {
    const double skin = world.tolerance().contact_offset;
    for (std::size_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const Body& body = bodies.slots[slot];
        if (!body.shape.valid()) continue;
        const Pose pose = pose_of(body);
        const TurnMatrix turn = matrix_of(pose.rotation);
        for (const Sphere& sphere : body.shape.spheres()) {
            const Vec3 centre = pose.position + turn * sphere.centre;
            if (locate(world.solid(), centre) == Where::kSolid) return "the centre of body " + std::to_string(slot);
            const NearFace near = closest(world, centre, sphere.radius);
            if (near && world.face_info(near.face)->solid && sphere.radius - near.distance > skin * 1.001)
                return "body " + std::to_string(slot) + " by " + std::to_string(sphere.radius - near.distance);
        }
    }
    return "";
}

/// In the air of rooms, clear of all, of 1 to 40 spheres, at 1 to 1,000 m/s and up to 200 rad/s.
Body random_body(const World& world, Rng& rng) {
    SphereSet spheres;
    const std::uint32_t count = rng.chance(0.1) ? 40 : 1 + rng.below(8);
    const double size = rng.uniform(0.05, 0.3);
    for (std::uint32_t k = 0; k < count; ++k)
        spheres.push_back({rng.direction() * (count == 1 ? 0 : rng.uniform(0, size)), size * rng.uniform(0.15, 0.5)});
    const BodyShape shape =
        make_body_shape(spheres, mass_of_box({size, size * rng.uniform(0.3, 1), size}, 2000)).value();
    const Box box = world.bounds();
    for (;;) {
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(box.low[axis], box.high[axis]);
        pose.rotation = random_turn(rng.next());
        const Location at = locate(world, pose.position);
        if (at.where != Where::kAir || room_info(world, at.room)->exterior || closest(world, pose.position, 1))
            continue;
        Body body = body_at(shape, pose);
        const double tens = rng.uniform(0, 3);
        body.velocity = rng.direction() * (tens < 1   ? 1 + 9 * tens
                                           : tens < 2 ? 10 + 90 * (tens - 1)
                                                      : 100 + 900 * (tens - 2));
        body.spin = rng.direction() * rng.uniform(0, 200);
        body.restitution = rng.uniform(0, 0.9);
        return body;
    }
}

TEST(BodiesInWorlds, NeverThroughAWallWhileItIsCut) {
    for (const double rate : {60.0, 30.0}) {
        World world = test::depot_world();
        const scenes::CutPlaces places = scenes::cut_places(world);
        Rng rng(3);
        Bodies bodies;
        for (int k = 0; k < test::sample(100); ++k) add_body(bodies, random_body(world, rng));
        std::size_t cuts = 0, bounces = 0;
        for (int frame = 0; frame < 120; ++frame) {
            if (frame % 2 == 0) {
                const auto orders = scenes::level_cuts(places, scenes::LevelCuts::kSpread, 5, std::uint64_t(frame));
                const CarveResult cut = carve(world, orders[0].cutter, orders[0].pose);
                cuts += cut.done();
                world = cut.world;
            }
            bounces += step(bodies, world, 1 / rate).bounces;
            ASSERT_EQ(depth_fault(world, bodies), "") << "frame " << frame;
        }
        EXPECT_GT(cuts, 10u);
        EXPECT_GT(bounces, std::size_t(test::sample(500)));
    }
}

TEST(BodiesInWorlds, TheSameBitsEachTimeAndFromASnapshot) {
    const World world = test::depot_world();
    Rng rng(4);
    Bodies bodies;
    for (int k = 0; k < 20; ++k) add_body(bodies, random_body(world, rng));
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

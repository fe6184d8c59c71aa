// SPDX-License-Identifier: MIT
// Bodies and parts of a level that move: carried, taken round, pushed, never passed through, crushed, woken.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "firma/moving_parts.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/moving/part_worlds.h"
#include "tests/random_vector.h"

namespace firma {
namespace {

using test::ball;
using test::body_here;
using test::box_body;
using test::box_world;
using test::ground;

constexpr double kTick = 1.0 / 60;
constexpr double kFriction = 0.6 * 9.81;  // metres a second squared, of a body and a part
constexpr double kSkin = 1.0 / 1024 + 1e-6;

BodyShape flat_crate() {
    return box_body({0.5, 0.5, 0.2});
}

/// A level with one part, whose motion of each step a function of its number gives.
struct PartRide {
    World level = ground();
    std::vector<MovingPart> parts;
    std::function<RigidMotion(int step)> motion;
    Bodies bodies;
    StepOptions options;
    StepReport last{};
    int steps = 0;
    std::size_t crushed = 0, woken = 0;

    explicit PartRide(const World& part) : parts{MovingPart(part)} {}
    Scene scene() const { return {level, parts}; }
    RigidMotion now() const { return parts[0].motion; }
    void run(int count) {
        for (int k = 0; k < count; ++k) {
            parts[0].motion = motion(steps++);
            last = step(bodies, scene(), kTick, options);
            crushed += last.crushed;
            woken += last.woken;
        }
    }
};

RigidMotion straight(const Vec3& from, const Vec3& velocity, int step) {
    RigidMotion motion;
    motion.position = from + velocity * (step * kTick);
    motion.path = velocity * kTick;
    return motion;
}

RigidMotion spinning(const Vec3& at, double rate, int step) {
    RigidMotion motion;
    motion.position = at;
    motion.rotation = turn_by({0, 0, rate * kTick * step});
    motion.turn = {0, 0, rate * kTick};
    return motion;
}

/// How deep the deepest sphere is in level or parts, where they are at the end of the step.
double deepest(const Scene& scene, const Bodies& bodies, bool level_alone = false) {
    double depth = 0;
    for (const Body& body : bodies.slots) {
        const Pose pose = pose_of(body);
        for (const Sphere& sphere : body.shape.spheres()) {
            const Vec3 centre = pose.position + matrix_of(pose.rotation) * sphere.centre;
            const double distance =
                level_alone ? closest(scene.world, centre).distance : closest(scene, centre, kEverywhere, 1).distance;
            depth = std::max(depth, sphere.radius - distance);
        }
    }
    return depth;
}

TEST(BodiesOnParts, ALiftCarriesACrateUpAndDown) {
    PartRide ride(box_world({-2, -2, -0.25}, {2, 2, 0}));
    const auto height = [](int step) { return 2 - std::cos(2 * step * kTick); };
    ride.motion = [&](int step) {
        RigidMotion motion;
        motion.position = {0, 0, height(step)};
        motion.path = {0, 0, height(step + 1) - height(step)};
        return motion;
    };
    const BodyId id = add_body(ride.bodies, body_here(flat_crate(), {0, 0, 1.2}));
    for (int k = 0; k < 200; ++k) {
        ride.run(1);
        const Body& body = *ride.bodies.find(id);
        ASSERT_NEAR(body.position.z, height(k + 1) + 0.2, kSkin) << k;
        ASSERT_NEAR(body.velocity.z, ride.now().path.z / kTick, 0.02) << k;
        ASSERT_LT(length(Vec3{body.position.x, body.position.y, 0}), 1e-3) << k;
        ASSERT_LT(length(body.spin), 0.01) << k;
        ASSERT_FALSE(body.asleep);
    }
    EXPECT_EQ(ride.crushed, 0u);
    ASSERT_FALSE(ride.bodies.contacts.empty());
    for (const BodyContact& contact : ride.bodies.contacts) EXPECT_EQ(contact.part, 0u);
}

TEST(BodiesOnParts, APlatformTakesACrateAlongAsFrictionDoes) {
    PartRide ride(box_world({-8, -2, -0.25}, {8, 2, 0}));
    constexpr double kSpeed = 2;
    bool goes = false;
    int since = 0;
    ride.motion = [&](int) { return goes ? straight({0, 0, 1}, {kSpeed, 0, 0}, since++) : straight({0, 0, 1}, {}, 0); };
    const BodyId id = add_body(ride.bodies, body_here(flat_crate(), {0, 0, 1.2}));
    ride.run(20);
    goes = true;
    ride.run(12);
    EXPECT_NEAR(ride.bodies.find(id)->velocity.x, kFriction * 12 * kTick, 0.03);
    ride.run(48);
    const Body& body = *ride.bodies.find(id);
    EXPECT_NEAR(body.velocity.x, kSpeed, 1e-3);
    EXPECT_NEAR(body.position.x, kSpeed * 1 - kSpeed * kSpeed / (2 * kFriction), 0.01);
}

/// How far from the axis a crate is that goes round with a turntable for two seconds, from two metres.
double radius_after(double rate, double* angle_off) {
    PartRide ride(box_world({-8, -8, -0.25}, {8, 8, 0}));
    ride.motion = [&](int step) { return spinning({0, 0, 1}, rate, step); };
    const BodyId id = add_body(ride.bodies, body_here(flat_crate(), {2, 0, 1.2}));
    ride.bodies.find(id)->velocity = {0, 2 * rate, 0};
    ride.bodies.find(id)->spin = {0, 0, rate};
    ride.run(120);
    const Vec3 place = ride.bodies.find(id)->position;
    const SineCosine round = sine_cosine(rate * 2);
    *angle_off = length(Vec3{place.x, place.y, 0} - Vec3{2 * round.cosine, 2 * round.sine, 0});
    return length(Vec3{place.x, place.y, 0});
}

TEST(BodiesOnParts, ATurntableHoldsWhatFrictionHolds) {
    // r w^2 against friction.
    const double limit = std::sqrt(kFriction / 2);
    double off = 0;
    EXPECT_NEAR(radius_after(0.9 * limit, &off), 2, 0.01);
    EXPECT_LT(off, 0.01);
    EXPECT_GT(radius_after(1.1 * limit, &off), 2.2);
}

TEST(BodiesOnParts, ADoorPushesARowOfCrates) {
    PartRide ride(box_world({-0.25, -1, 0.125}, {0, 1, 2}));
    ride.motion = [](int step) { return straight({0, 0, 0}, {1, 0, 0}, step); };
    for (int k = 0; k < 3; ++k) add_body(ride.bodies, body_here(flat_crate(), {0.8 + 1.1 * k, 0, 0.2}));
    for (int k = 0; k < 180; ++k) {
        ride.run(1);
        ASSERT_LT(deepest(ride.scene(), ride.bodies), kSkin) << k;
    }
    // They lie side by side now, as far apart as spheres sink into each other.
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(ride.bodies.slots[std::size_t(k)].position.x, 3.5 + k, 0.02);
    EXPECT_EQ(ride.crushed, 0u);
}

TEST(BodiesOnParts, AFastDoorNeverPassesThroughABall) {
    scenes::Rng rng(7);
    for (int k = 0; k < 40; ++k) {
        PartRide ride(box_world({-0.0625, -4, -4}, {0.0625, 4, 4}));
        ride.level = box_world({-400, -400, -400}, {-300, -300, -300});
        ride.options.gravity = {};
        ride.motion = [](int step) { return straight({0, 0, 0}, {30, 0, 0}, step); };
        const Vec3 at{rng.uniform(0.5, 3), 0, 0};
        const BodyId id = add_body(ride.bodies, body_here(ball(rng.uniform(0.05, 0.3)), at));
        ride.bodies.find(id)->velocity = {rng.uniform(-60, 0), rng.uniform(-1, 1), rng.uniform(-1, 1)};
        ride.bodies.find(id)->spin = test::random_vector(rng, 0, 50);
        for (int tick = 0; tick < 30; ++tick) {
            ride.run(1);
            const double face = ride.now().position.x + ride.now().path.x + 0.0625;
            const Body& body = *ride.bodies.find(id);
            ASSERT_GT(body.position.x - body.shape.reach(), face - kSkin) << k << " at " << tick;
        }
        EXPECT_GE(ride.bodies.find(id)->velocity.x, 30 - 1e-9) << k;
        EXPECT_EQ(ride.crushed, 0u);
    }
}

// Thirty together, so that some are held against it by others.
TEST(BodiesOnParts, ABladeIsNeverEntered) {
    for (int seed = 0; seed < 12; ++seed) {
        PartRide ride(test::cross_world());
        ride.level = box_world({-400, -400, -400}, {-300, -300, -300});
        ride.options.gravity = {};
        ride.motion = [](int step) { return spinning({0, 0, 0}, 20, step); };
        scenes::Rng rng{std::uint64_t(seed)};
        for (int k = 0; k < 30; ++k) {
            const Vec3 from = test::random_vector(rng, 2.5, 6);
            Body body = body_here(k % 2 ? ball(0.15) : box_body({0.2, 0.15, 0.1}), from);
            body.velocity = from * -rng.uniform(1, 8);
            add_body(ride.bodies, body);
        }
        std::size_t bounces = 0;
        double depth = 0;
        for (int tick = 0; tick < 90; ++tick) {
            ride.run(1);
            bounces += ride.last.bounces;
            depth = std::max(depth, deepest(ride.scene(), ride.bodies));
            for (const Body& body : ride.bodies.slots) ASSERT_FALSE(body.stuck) << seed << " at " << tick;
        }
        EXPECT_GT(bounces, 20u) << seed;
        EXPECT_EQ(ride.crushed, 0u) << seed;
        EXPECT_LT(depth, kSkin + 1e-4) << seed;
    }
}

TEST(BodiesOnParts, WhatADoorCrushesStaysClearOfTheWall) {
    PartRide ride(box_world({-0.25, -1, 0.125}, {0, 1, 2}));
    ride.level = test::brush_world(map_text::box({-8, -8, -1}, {8, 8, 0}, "rock") +
                                   map_text::box({2, -8, 0}, {3, 8, 4}, "rock"));
    ride.motion = [](int step) {
        return step < 120 ? straight({0, 0, 0}, {1, 0, 0}, step) : straight({2, 0, 0}, {-1, 0, 0}, step - 120);
    };
    const BodyId id = add_body(ride.bodies, body_here(ball(0.25), {1, 0, 0.25}));
    for (int k = 0; k < 120; ++k) {
        ride.run(1);
        ASSERT_LT(deepest(ride.scene(), ride.bodies, true), kSkin) << k;
        ASSERT_LT(ride.bodies.find(id)->position.x, 1.75 + kSkin) << k;
        if (k < 80) {
            ASSERT_EQ(ride.crushed, 0u) << k;
        }
    }
    EXPECT_GT(ride.crushed, 5u);
    for (int k = 0; k < 120; ++k) {
        ride.run(1);
        ASSERT_LT(deepest(ride.scene(), ride.bodies, true), kSkin) << k;
    }
    EXPECT_EQ(ride.last.crushed, 0u);
    EXPECT_EQ(ride.last.stuck, 0u);
    EXPECT_LT(deepest(ride.scene(), ride.bodies), kSkin);
}

TEST(BodiesOnParts, SleepersWakeWhenTheirPartGoesOrChanges) {
    PartRide ride(box_world({-2, -2, -0.25}, {2, 2, 0}));
    Vec3 velocity;
    int since = 0;
    ride.motion = [&](int) { return straight({0, 0, 1}, velocity, velocity == Vec3{} ? 0 : since++); };
    const BodyId id = add_body(ride.bodies, body_here(flat_crate(), {0, 0, 1.2}));
    ride.run(120);
    ASSERT_TRUE(ride.bodies.find(id)->asleep);
    ride.woken = 0;
    ride.run(60);
    EXPECT_TRUE(ride.bodies.find(id)->asleep);
    EXPECT_EQ(ride.woken, 0u);
    Bodies asleep = ride.bodies;
    velocity = {0, 0, 0.5};
    ride.run(1);
    EXPECT_EQ(ride.woken, 1u);
    EXPECT_FALSE(ride.bodies.find(id)->asleep);
    EXPECT_NEAR(ride.bodies.find(id)->velocity.z, 0.5, 0.02);
    // Another solid.
    ride.bodies = asleep;
    velocity = {};
    ride.parts[0].set_world(box_world({-2, -2, -0.25}, {-1, 2, 0}));
    ride.run(1);
    EXPECT_FALSE(ride.bodies.find(id)->asleep);
    ride.run(60);
    EXPECT_NEAR(ride.bodies.find(id)->position.z, 0.2, 0.001);
    // None at all.
    ride.bodies = asleep;
    step(ride.bodies, ride.level, kTick);
    EXPECT_FALSE(ride.bodies.find(id)->asleep);
}

TEST(BodiesOnParts, ADoorWakesWhatSleepsInItsWay) {
    PartRide ride(box_world({-0.25, -1, 0.125}, {0, 1, 2}));
    ride.motion = [](int step) {
        return straight({0, 0, 0}, {step < 120 ? 0.0 : 1.0, 0, 0}, step < 120 ? 0 : step - 120);
    };
    const BodyId near = add_body(ride.bodies, body_here(flat_crate(), {1, 0, 0.2}));
    const BodyId far = add_body(ride.bodies, body_here(flat_crate(), {1, 9, 0.2}));
    ride.run(120);
    ASSERT_TRUE(ride.bodies.find(near)->asleep);
    ride.run(80);
    EXPECT_FALSE(ride.bodies.find(near)->asleep);
    EXPECT_TRUE(ride.bodies.find(far)->asleep);
    EXPECT_NEAR(ride.bodies.find(near)->position.x, 80 * kTick + 0.5, 0.01);
}

TEST(BodiesOnParts, TheSameBitsEachTimeAndFromASnapshot) {
    PartRide ride(test::cross_world());
    ride.motion = [](int step) { return spinning({0, 0, 1}, 3, step); };
    for (int k = 0; k < 12; ++k)
        add_body(ride.bodies, body_here(box_body({0.2, 0.2, 0.15}), {0.3 * (k % 4) - 0.5, 0.3 * (k / 4) - 0.3, 2.5}));
    PartRide again = ride;
    ride.run(120);
    again.run(60);
    PartRide snapshot = again;
    again.run(60);
    snapshot.run(60);
    EXPECT_EQ(hash_bodies(again.bodies), hash_bodies(ride.bodies));
    EXPECT_EQ(hash_bodies(snapshot.bodies), hash_bodies(ride.bodies));
    snapshot.bodies.part_hashes[0] ^= 1;
    EXPECT_NE(hash_bodies(snapshot.bodies), hash_bodies(ride.bodies));
}

TEST(BodiesOnParts, WithoutPartsOrFarFromThemTheBitsAreThoseOfTheWorld) {
    const World world = ground();
    Bodies alone;
    for (int k = 0; k < 12; ++k)
        add_body(alone, body_here(box_body({0.2, 0.2, 0.15}), {0.3 * (k % 4), 0.3 * (k / 4), 1 + 0.5 * k}));
    Bodies in_scene = alone, beside = alone;
    std::vector<MovingPart> parts{MovingPart(test::leaf_world())};
    for (int k = 0; k < 120; ++k) {
        parts[0].motion = spinning({60, 0, 0}, 2, k);
        step(alone, world, kTick);
        step(in_scene, Scene{world}, kTick);
        step(beside, Scene{world, parts}, kTick);
    }
    EXPECT_EQ(hash_bodies(in_scene), hash_bodies(alone));
    beside.part_hashes.clear();
    EXPECT_EQ(hash_bodies(beside), hash_bodies(alone));
}

TEST(BodiesOnParts, AMotionThatCannotBeUsedMovesNothing) {
    PartRide ride(test::leaf_world());
    add_body(ride.bodies, body_here(ball(0.2), {0, 0, 5}));
    const std::uint64_t before = hash_bodies(ride.bodies);
    ride.motion = [](int) { return straight({0, 0, 0}, {NAN, 0, 0}, 0); };
    ride.run(1);
    EXPECT_EQ(ride.last.awake, 0u);
    EXPECT_EQ(hash_bodies(ride.bodies), before);
}

}  // namespace
}  // namespace firma

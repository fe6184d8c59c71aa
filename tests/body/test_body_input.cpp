// SPDX-License-Identifier: MIT
// Numbers that make no sense: a body that has one moves nobody, and nothing takes hours, or memory without bound.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "firma/moving_parts.h"
#include "tests/body/simple_bodies.h"
#include "tests/moving/part_worlds.h"

namespace firma {
namespace {

using test::ball;
using test::body_here;
using test::box_body;
using test::ground;
using test::run;

constexpr double kHuge = 0x1p+190;

bool all_finite(const Bodies& bodies) {
    for (const Body& body : bodies.slots) {
        if (!body.shape.valid()) continue;
        for (const Vec3& v : {body.position, body.velocity, body.spin})
            if (!is_finite(v)) return false;
        for (const double part : body.rotation)
            if (!is_finite(part)) return false;
    }
    for (const BodyContact& contact : bodies.contacts)
        for (const Vec3& v : {contact.point, contact.normal, contact.friction, contact.slip, contact.rolling})
            if (!is_finite(v) || !is_finite(contact.force)) return false;
    return true;
}

/// A few boxes that fall onto each other.
Bodies heap() {
    Bodies bodies;
    for (int k = 0; k < 12; ++k)
        add_body(bodies, body_here(box_body({0.2, 0.2, 0.15}), {0.3 * (k % 4), 0.3 * (k / 4), 1 + 0.5 * k}));
    return bodies;
}

const std::function<void(Body&)> kUnsound[] = {
    [](Body& body) { body.position.x = NAN; },
    [](Body& body) { body.position.z = INFINITY; },
    [](Body& body) { body.position = {0, 0x1p+900, 0}; },
    [](Body& body) { body.rotation[2] = NAN; },
    [](Body& body) { body.velocity = {0, NAN, 0}; },
    [](Body& body) { body.velocity = {-INFINITY, 0, 0}; },
    [](Body& body) { body.spin.z = NAN; },
    [](Body& body) { body.force.x = INFINITY; },
    [](Body& body) { body.torque.y = NAN; },
    [](Body& body) { body.friction = -1; },
    [](Body& body) { body.friction = NAN; },
    [](Body& body) { body.rolling = NAN; },
    [](Body& body) { body.restitution = 1.5; },
    [](Body& body) { body.restitution = NAN; },
};

TEST(BodyInput, AnUnsoundBodyMovesNobodyAndStaysAsItIs) {
    const World world = ground();
    Bodies alone = heap();
    run(alone, world, 90);
    for (std::size_t kind = 0; kind < std::size(kUnsound); ++kind)
        for (const bool asleep : {false, true}) {
            Bodies bodies = heap();
            // In the midst of the heap.
            Body odd = body_here(ball(0.5), {0.4, 0.3, 1});
            kUnsound[kind](odd);
            odd.asleep = asleep;
            const BodyId id = add_body(bodies, odd);
            const Body before = *bodies.find(id);
            for (int k = 0; k < 90; ++k) {
                const StepReport report = step(bodies, world, 1.0 / 60);
                ASSERT_EQ(report.unsound, 1u) << kind;
                ASSERT_TRUE(report.valid);
            }
            // By bits: NaN equals nothing.
            EXPECT_EQ(std::memcmp(&bodies.find(id)->position, &before.position, sizeof before.position), 0) << kind;
            EXPECT_EQ(std::memcmp(&bodies.find(id)->velocity, &before.velocity, sizeof before.velocity), 0) << kind;
            remove_body(bodies, id);
            bodies.slots.pop_back();
            bodies.free.clear();
            EXPECT_EQ(hash_bodies(bodies), hash_bodies(alone)) << kind << (asleep ? ", asleep" : "");
        }
}

TEST(BodyInput, HugeNumbersComeToNoneThatAreNot) {
    const World world = ground();
    for (int kind = 0; kind < 5; ++kind) {
        Bodies bodies = heap();
        Body& body = bodies.slots[3];
        if (kind == 0) body.velocity = {0, 0, -kHuge};
        if (kind == 1) body.force = {kHuge, 0, kHuge};
        if (kind == 2) body.spin = {0, kHuge, 0};
        if (kind == 3) push_body(bodies, {3, body.use}, {1e308, 1e308, -1e308}, body.position + Vec3{1, 0, 0});
        if (kind == 4) body.torque = {1e300, 0, 0};
        for (int k = 0; k < 60; ++k) step(bodies, world, 1.0 / 60);
        // What was pushed beyond all numbers is left as it is; nothing else is touched.
        if (kind == 3 && !is_finite(bodies.slots[3].velocity)) bodies.slots[3].velocity = bodies.slots[3].spin = {};
        EXPECT_TRUE(all_finite(bodies)) << kind;
    }
}

TEST(BodyInput, SpinsThatNoSolidHasTakeNoHours) {
    const World world = ground();
    for (const double spin : {1e4, 1e6, 1e8}) {
        Bodies bodies;
        const BodyId id = add_body(bodies, body_here(box_body({0.5, 0.3, 0.2}), {0, 0, 0.6}));
        bodies.find(id)->spin = {spin, spin / 2, 0};
        bodies.find(id)->velocity = {0, 0, -20};
        bodies.find(id)->restitution = 1;
        const auto start = std::chrono::steady_clock::now();
        for (int k = 0; k < 30; ++k) step(bodies, world, 1.0 / 30);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        EXPECT_LT(took.count(), 20) << spin;
        EXPECT_TRUE(all_finite(bodies)) << spin;
    }
}

TEST(BodyInput, OptionsOutOfRangeDoNothing) {
    const World world = ground();
    Bodies bodies = heap();
    run(bodies, world, 30);
    const std::uint64_t before = hash_bodies(bodies);
    const auto refused = [&](const StepOptions& options, double seconds = 1.0 / 60) {
        return !step(bodies, world, seconds, options).valid && hash_bodies(bodies) == before;
    };
    for (const int substeps : {0, -240, 10'001, std::numeric_limits<int>::max()})
        EXPECT_TRUE(refused({.substeps_a_second = substeps})) << substeps;
    for (const int bounces : {-1, 1001, std::numeric_limits<int>::max()})
        EXPECT_TRUE(refused({.max_bounces = bounces})) << bounces;
    for (const double number : {-1.0, double(NAN), double(INFINITY)}) {
        EXPECT_TRUE(refused({.contact_friction = number})) << number;
        EXPECT_TRUE(refused({.contact_offset = number})) << number;
        EXPECT_TRUE(refused({.gravity = {0, 0, number == -1 ? -0x1p+300 : number}})) << number;
    }
    for (const double seconds : {0.0, -1.0, 1e-10, 5e-324, double(NAN), double(INFINITY)})
        EXPECT_TRUE(refused({}, seconds)) << seconds;
    EXPECT_TRUE(step(bodies, world, 1e-9).valid);
    EXPECT_TRUE(all_finite(bodies));
}

TEST(BodyInput, AWorldOfNothingHasBodiesThatFall) {
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.5), {1, 2, 3}));
    EXPECT_TRUE(step(bodies, World(), 0.1).valid);
    EXPECT_NEAR(bodies.find(id)->position.z, 3 - 0.5 * 9.81 * 0.01, 1e-12);
    Bodies nobody;
    EXPECT_TRUE(step(nobody, World(), 0.1).valid);
    EXPECT_EQ(nobody.steps, 1u);
}

TEST(BodyInput, ThousandsOfSpheresInEachOtherAreSomeThousandContacts) {
    SphereSet spheres;
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            for (int z = 0; z < 10; ++z) spheres.push_back({{x * 0.08, y * 0.08, z * 0.08}, 0.6});
    MassProperties mass = mass_of_ball(0.8, 1000);
    mass.centre = {0.4, 0.4, 0.4};
    const BodyShape shape = make_body_shape(spheres, mass).value();
    Bodies bodies;
    add_body(bodies, body_here(shape, {0, 0, 5}));
    add_body(bodies, body_here(shape, {0.01, 0, 5}));
    const StepReport report = step(bodies, ground(), 1.0 / 60);
    EXPECT_GT(report.contacts, 1000u);
    EXPECT_LE(report.contacts, 4096u);
    EXPECT_TRUE(all_finite(bodies));
    for (const Body& body : bodies.slots) EXPECT_LT(length(body.velocity), 100);
}

TEST(BodyInput, ShapesBeyondAllNumbersAreRefused) {
    const Sphere sphere{{0, 0, 0}, 1};
    const auto refused = [](const Sphere& of, const MassProperties& mass) { return !make_body_shape({&of, 1}, mass); };
    EXPECT_FALSE(refused(sphere, mass_of_ball(1, 1000)));
    EXPECT_TRUE(refused({{0x1p+201, 0, 0}, 1}, mass_of_ball(1, 1000)));
    EXPECT_TRUE(refused({{0, 0, 0}, 0x1p+201}, mass_of_ball(1, 1000)));
    EXPECT_TRUE(refused(sphere, mass_of_ball(1, 5e-324)));
    EXPECT_TRUE(refused(sphere, mass_of_ball(1e100, 1e100)));
    EXPECT_TRUE(refused(sphere, mass_of_ball(-1, 1000)));
    MassProperties far = mass_of_ball(1, 1000);
    far.centre = {1e300, 0, 0};
    EXPECT_TRUE(refused(sphere, far));
}

/// A crate that was put on another when that slept: so each sleeps by itself.
struct OnASleeper {
    Bodies bodies;
    BodyId below, above;

    explicit OnASleeper(const World& world) {
        below = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.3}));
        run(bodies, world, 120);
        above = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.9}));
        run(bodies, world, 120);
        EXPECT_TRUE(bodies.find(below)->asleep);
        EXPECT_TRUE(bodies.find(above)->asleep);
        EXPECT_NE(bodies.find(below)->island, bodies.find(above)->island);
    }
};

TEST(BodyInput, WhatSleptOnABodyThatIsPutElsewhereFalls) {
    const World world = ground();
    OnASleeper pair(world);
    Body& below = *pair.bodies.find(pair.below);
    below.position = {9, 0, 0.3};
    below.asleep = false;
    run(pair.bodies, world, 60);
    EXPECT_NEAR(pair.bodies.find(pair.above)->position.z, 0.3, 0.01);
}

TEST(BodyInput, WhatSleptOnASlotThatIsEmptiedFalls) {
    const World world = ground();
    OnASleeper pair(world);
    pair.bodies.slots[pair.below.slot].shape = {};  // not as it is meant: remove_body()
    run(pair.bodies, world, 60);
    EXPECT_NEAR(pair.bodies.find(pair.above)->position.z, 0.3, 0.01);
    for (const BodyContact& contact : pair.bodies.contacts) EXPECT_NE(contact.body, pair.below.slot);
}

TEST(BodyInput, WhatMeetsNoFaceIsNotStuckInSolid) {
    const World world = ground();
    Bodies bodies;
    const BodyId ghost = add_body(bodies, body_here(ball(0.3), {0, 0, -1}));
    const BodyId solid = add_body(bodies, body_here(ball(0.3), {5, 0, -1}));
    bodies.find(ghost)->mask = 0;
    EXPECT_EQ(step(bodies, world, 1.0 / 60).stuck, 1u);
    EXPECT_FALSE(bodies.find(ghost)->stuck);
    EXPECT_TRUE(bodies.find(solid)->stuck);
    EXPECT_NEAR(bodies.find(ghost)->velocity.z, -9.81 / 60, 1e-12);
}

}  // namespace
}  // namespace firma

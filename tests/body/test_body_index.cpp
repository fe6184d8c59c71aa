// SPDX-License-Identifier: MIT
// Casts at bodies, beside each body by itself, and closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/body_index.h"
#include "firma/cast_set.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma {
namespace {

using scenes::Rng;
using test::ball;
using test::body_here;
using test::box_body;

/// Bodies all about, some of them asleep, some on another mask.
Bodies many_bodies(Rng& rng, int count) {
    Bodies bodies;
    for (int k = 0; k < count; ++k) {
        const double size = rng.uniform(0.1, 0.6);
        const BodyShape shape = rng.chance(0.3) ? ball(size) : box_body({size, size * 0.7, size * 0.4});
        Body body = body_here(shape, test::random_vector(rng, 0, 8));
        body.rotation = random_turn(rng.next());
        body.velocity = test::random_vector(rng, 0, 20);
        body.spin = test::random_vector(rng, 0, 15);
        body.asleep = rng.chance(0.2);
        body.mask = rng.chance(0.2) ? 2 : 1;
        add_body(bodies, body);
    }
    for (int k = 0; k < count / 10; ++k) {
        const std::uint32_t slot = rng.below(std::uint32_t(count));
        remove_body(bodies, {slot, bodies.slots[slot].use});
    }
    return bodies;
}

RigidMotion motion_of(const Body& body, double seconds) {
    const double moves = body.asleep ? 0 : seconds;
    return {body.position, body.rotation, body.velocity * moves, body.spin * moves};
}

/// The spheres of a body about its centre of mass, in its frame.
SphereSet spheres_about_centre(const Body& body) {
    SphereSet spheres;
    for (const Sphere& sphere : body.shape.spheres())
        spheres.push_back({sphere.centre - body.shape.centre(), sphere.radius});
    return spheres;
}

TEST(BodyIndex, TheFirstOfAllAsEachByItself) {
    Rng rng(21);
    int hits = 0, misses = 0, overlaps = 0;
    for (int scene = 0; scene < test::sample(60); ++scene) {
        const Bodies bodies = many_bodies(rng, 40);
        const double seconds = rng.chance(0.5) ? 0.0 : rng.uniform(0.01, 0.2);
        const BodyIndex index(bodies, seconds);
        for (int k = 0; k < 50; ++k) {
            SphereSet set{{{}, rng.chance(0.3) ? 0.0 : rng.uniform(0.01, 0.3)}};
            RigidMotion motion{test::random_vector(rng, 0, 10), {0, 0, 0, 1}, test::random_vector(rng, 0, 20), {}};
            if (rng.chance(0.3)) {
                set.push_back({test::random_vector(rng, 0, 0.5), 0.1});
                motion.turn = test::random_vector(rng, 0, 3);
            }
            BodyCastOptions options;
            options.mask = 1;
            const std::uint32_t except = rng.below(40);
            options.except = {except, bodies.slots[except].use};
            const BodyHit hit = index.cast(set, motion, options);
            double best = 2;
            BodyId who;
            for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
                const Body& body = bodies.slots[slot];
                if (!body.shape.valid() || !(body.mask & 1) || slot == except) continue;
                const SetPairHit one = cast(set, motion, spheres_about_centre(body), motion_of(body, seconds));
                if (one.touched() && one.fraction < best) best = one.fraction, who = {slot, body.use};
            }
            ASSERT_EQ(hit.touched(), best <= 1);
            ++(hit.touched() ? hits : misses);
            if (!hit.touched()) continue;
            // The library sees the spheres along the principal axes: other bits.
            // Another one only where both are met at one time.
            EXPECT_NEAR(hit.fraction, best, hit.body == who ? 1e-6 : 1e-9);
            EXPECT_LT(hit.body_sphere, bodies.find(hit.body)->shape.spheres().size());
            EXPECT_NEAR(length(hit.normal), 1, 1e-12);
            // It touches what it says; what begins in a sphere is told where that sphere's surface is.
            const Body& body = *bodies.find(hit.body);
            const Pose pose = pose_at(motion_of(body, seconds), hit.fraction);
            const Sphere met = spheres_about_centre(body)[hit.body_sphere];
            const Vec3 middle = pose.position + matrix_of(normalised(pose.rotation)) * met.centre;
            EXPECT_NEAR(length(hit.point - middle), met.radius, 2e-4);
            const double depth = met.radius + set[hit.sphere].radius - length(hit.centre - middle);
            if (hit.status == Status::kInitialOverlap) {
                ++overlaps;
                EXPECT_EQ(hit.fraction, 0);
                EXPECT_GT(depth, 0);
                EXPECT_NEAR(dot(hit.normal, hit.centre - middle), length(hit.centre - middle), 1e-9);
            } else {
                EXPECT_NEAR(depth, 0, 2e-4);
                EXPECT_NEAR(length(hit.point - hit.centre), set[hit.sphere].radius, 2e-4);
            }
        }
    }
    EXPECT_GT(hits, test::sample(200));
    EXPECT_GT(misses, test::sample(300));
    EXPECT_GT(overlaps, test::sample(10));
}

TEST(BodyIndex, ARayAndASphereMeetABallWhereTheyShould) {
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.5), {4, 0, 0}));
    bodies.find(id)->velocity = {0, 0, 3};
    bodies.find(id)->spin = {0, 0, 2};
    const BodyIndex index(bodies);
    const BodyHit ray = index.cast(Ray{{0, 0, 0}, {7, 0, 0}});
    EXPECT_EQ(ray.status, Status::kHit);
    EXPECT_EQ(ray.body, id);
    EXPECT_NEAR(ray.fraction, 0.5, 1e-12);
    EXPECT_NEAR(ray.normal.x, -1, 1e-12);
    // Of the spin, at half a metre from the axis, and of the velocity.
    EXPECT_NEAR(ray.surface_velocity.y, -1, 1e-12);
    EXPECT_NEAR(ray.surface_velocity.z, 3, 1e-12);
    const BodyHit sphere = index.cast(Sphere{{0, 0, 0}, 0.25}, {6.5, 0, 0});
    EXPECT_NEAR(sphere.fraction, 0.5, 1e-12);
    EXPECT_NEAR(sphere.centre.x, 3.25, 1e-12);
    EXPECT_NEAR(sphere.point.x, 3.5, 1e-12);
    EXPECT_FALSE(index.cast(Ray{{0, 0.51, 0}, {7, 0, 0}}).touched());
    EXPECT_FALSE(index.cast(Ray{{0, 0, 0}, {7, 0, 0}}, {.mask = ~0u, .except = id}).touched());
    EXPECT_FALSE(index.cast(Ray{{0, 0, 0}, {7, 0, 0}}, {.mask = 0}).touched());
    // It begins in it, and comes out.
    EXPECT_FALSE(index.cast(Ray{{4.25, 0, 0}, {7, 0, 0}}).touched());
    EXPECT_EQ(index.cast(Ray{{4.25, 0, 0}, {-7, 0, 0}}).status, Status::kInitialOverlap);
}

TEST(BodyIndex, BodiesGoOnMeanwhileAndTheIndexKeepsWhatItSaw) {
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.5), {4, 0, -3}));
    bodies.find(id)->velocity = {0, 0, 6};
    const BodyIndex stands(bodies), goes(bodies, 1);
    bodies.find(id)->position = {100, 0, 0};
    // After half a second it is at height 0, where the ray is at x = 3.5 then.
    const Ray ray{{0, 0, 0}, {7, 0, 0}};
    EXPECT_FALSE(stands.cast(ray).touched());
    const BodyHit hit = goes.cast(ray);
    ASSERT_TRUE(hit.touched());
    EXPECT_NEAR(length(hit.point - ray.path * hit.fraction), 0, 1e-9);
    EXPECT_NEAR(length(hit.point - Vec3{4, 0, -3 + 6 * hit.fraction}), 0.5, 1e-9);
}

TEST(BodyIndex, WhatMakesNoSenseIsToldOrLeftOut) {
    Bodies bodies;
    add_body(bodies, body_here(ball(0.5), {4, 0, 0}));
    Body bad = body_here(ball(0.5), {2, 0, 0});
    bad.position.y = NAN;
    add_body(bodies, bad);
    const BodyIndex index(bodies, NAN);
    EXPECT_EQ(index.cast(Ray{{0, NAN, 0}, {7, 0, 0}}).status, Status::kInvalid);
    EXPECT_EQ(index.cast(Ray{{0, 0, 0}, {INFINITY, 0, 0}}).status, Status::kInvalid);
    EXPECT_EQ(index.cast(Sphere{{0, 0, 0}, -1}, {7, 0, 0}).status, Status::kInvalid);
    EXPECT_EQ(index.cast(Ray{{0, 0, 0}, {7, 0, 0}}).body.slot, 0u);
    EXPECT_EQ(BodyIndex(Bodies()).cast(Ray{{0, 0, 0}, {7, 0, 0}}).status, Status::kMiss);
    EXPECT_FALSE(index.cast(std::span<const Sphere>{}, {{0, 0, 0}, {0, 0, 0, 1}, {7, 0, 0}, {}}).touched());
}

}  // namespace
}  // namespace firma

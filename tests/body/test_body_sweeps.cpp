// SPDX-License-Identifier: MIT
// Fast bodies meet each other within a step: none through another, what they have together is kept.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"

namespace firma {
namespace {

using scenes::Rng;
using test::ball;
using test::body_here;
using test::box_body;
using test::ground;
using test::run;

constexpr StepOptions kWeightless{.gravity = {0, 0, 0}};

struct Whole {
    Vec3 momentum, angular;
    double energy = 0;
};

Whole whole_of(const Bodies& bodies) {
    Whole sum;
    for (const Body& body : bodies.slots) {
        const Vec3 momentum = body.velocity * body.shape.mass();
        sum.momentum += momentum;
        sum.angular += angular_momentum(body) + cross(body.position, momentum);
        sum.energy += kinetic_energy(body);
    }
    return sum;
}

TEST(BodySweeps, TwoBallsHeadOnExchangeTheirSpeeds) {
    const World world = ground();
    for (const double speed : {1.0, 10.0, 100.0, 300.0, 1000.0}) {
        Bodies bodies;
        for (const double side : {-1.0, 1.0}) {
            Body one = body_here(ball(0.05), {side * 3, 0, 10});
            one.velocity = {-side * speed, 0, 0};
            one.restitution = 1;
            one.friction = 0;
            add_body(bodies, one);
        }
        const int steps = int(std::ceil(4.0 / speed * 60));
        run(bodies, world, steps, kWeightless);
        EXPECT_NEAR(bodies.slots[0].velocity.x, -speed, speed * 1e-9) << speed;
        EXPECT_NEAR(bodies.slots[1].velocity.x, speed, speed * 1e-9) << speed;
        EXPECT_LT(bodies.slots[0].position.x, -0.05);
        EXPECT_GT(bodies.slots[1].position.x, 0.05);
    }
}

/// Spheres in a plate across x, 2 m wide.
BodyShape plate(double density) {
    SphereSet spheres;
    for (int i = -10; i <= 10; ++i)
        for (int j = -10; j <= 10; ++j) spheres.push_back({{0, i * 0.1, j * 0.1}, 0.1});
    return make_body_shape(spheres, mass_of_box({0.1, 1, 1}, density)).value();
}

TEST(BodySweeps, NothingFliesThroughAPlate) {
    const World world = ground();
    Rng rng(11);
    for (int shot = 0; shot < 300; ++shot) {
        Bodies bodies;
        const BodyId wall = add_body(bodies, body_here(plate(20000), {0, 0, 50}));
        const double size = rng.uniform(0.02, 0.1);
        Body bullet = body_here(rng.chance(0.5) ? ball(size) : box_body({size, size / 2, size / 3}),
                                {rng.uniform(-4, -0.5), rng.uniform(-0.5, 0.5), 50 + rng.uniform(-0.5, 0.5)});
        bullet.velocity = {std::pow(10.0, rng.uniform(1, 3)), 0, 0};
        bullet.spin = test::random_vector(rng, 0, 200);
        if (rng.chance(0.5)) bodies.find(wall)->spin = {0, 0, rng.uniform(-0.5, 0.5)};
        const BodyId id = add_body(bodies, bullet);
        const Whole before = whole_of(bodies);
        const int steps = int(5 / bullet.velocity.x * 60) + 2;
        for (int k = 0; k < steps; ++k) {
            step(bodies, world, 1.0 / 60, kWeightless);
            EXPECT_LT(bodies.find(id)->position.x, bodies.find(wall)->position.x) << shot;
        }
        const Whole after = whole_of(bodies);
        EXPECT_NEAR(after.momentum.x, before.momentum.x, before.momentum.x * 1e-9) << shot;
        EXPECT_LE(after.energy, before.energy * (1 + 1e-9)) << shot;
    }
}

// As many as meet: some twice and more in one step. So high that none gets to the ground.
TEST(BodySweeps, ACrowdKeepsItsMomentum) {
    const World world = ground();
    for (int seed = 0; seed < 10; ++seed) {
        Rng rng{std::uint64_t(seed)};
        Bodies bodies;
        for (int k = 0; k < 60; ++k) {
            const Vec3 at = test::random_vector(rng, 2, 6);
            Body one = body_here(rng.chance(0.5) ? ball(rng.uniform(0.05, 0.3)) : box_body({0.3, 0.2, 0.1}),
                                 at + Vec3{0, 0, 600});
            one.velocity = at * -rng.uniform(10, 60);
            one.spin = rng.direction() * 50.0;
            add_body(bodies, one);
        }
        const Whole before = whole_of(bodies);
        std::size_t met = 0;
        for (int k = 0; k < 30; ++k) met += step(bodies, world, 1.0 / 60, kWeightless).bounces;
        EXPECT_GT(met, 20u);
        const Whole after = whole_of(bodies);
        const double much = std::sqrt(2 * before.energy * 1000);
        EXPECT_LT(length(after.momentum - before.momentum), much * 1e-9) << seed;
        EXPECT_LT(after.energy, before.energy) << seed;
    }
}

TEST(BodySweeps, AShotFromFarWakesASleeper) {
    const World world = ground();
    Bodies bodies;
    const BodyId sleeper = add_body(bodies, body_here(box_body({0.3, 0.3, 0.3}), {0, 0, 0.3}));
    run(bodies, world, 120);
    ASSERT_TRUE(bodies.find(sleeper)->asleep);
    Body shot = body_here(ball(0.05, 8000), {-6, 0.15, 0.3});  // between its spheres there is room
    shot.velocity = {400, 0, 0};
    const BodyId bullet = add_body(bodies, shot);
    EXPECT_GT(step(bodies, world, 1.0 / 60).woken, 0u);
    const Body& hit = *bodies.find(sleeper);
    EXPECT_FALSE(hit.asleep);
    // Of a push at the middle, all but what it kept and what the ground takes.
    const double momentum = shot.shape.mass() * 400;
    EXPECT_NEAR(hit.velocity.x * hit.shape.mass() + bodies.find(bullet)->velocity.x * shot.shape.mass(), momentum,
                momentum * 0.05);
}

TEST(BodySweeps, TheSameBitsEachTime) {
    const World world = ground();
    const auto hash = [&] {
        Rng rng(3);
        Bodies bodies;
        for (int k = 0; k < 40; ++k) {
            Body one = body_here(box_body({0.2, 0.1, 0.1}), rng.direction() * 4 + Vec3{0, 0, 6});
            one.velocity = (Vec3{0, 0, 6} - one.position) * 40.0;
            add_body(bodies, one);
        }
        run(bodies, world, 60);
        return hash_bodies(bodies);
    };
    EXPECT_EQ(hash(), hash());
}

}  // namespace
}  // namespace firma

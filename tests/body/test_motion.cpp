// SPDX-License-Identifier: MIT
// Motion beside closed forms: falling, bouncing, rolling, sliding, spinning.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/body/simple_bodies.h"

namespace firma {
namespace {

using test::ball;
using test::body_here;
using test::box_body;
using test::ground;
using test::run;

StepOptions never_asleep() {
    StepOptions options;
    options.sleep_after = INFINITY;
    return options;
}

TEST(Motion, AFallIsThatOfNewton) {
    const World world = ground();
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.5), {0, 0, 100}));
    bodies.find(id)->velocity = {3, 0, 2};
    run(bodies, world, 120);
    const Body& body = *bodies.find(id);
    EXPECT_NEAR(body.position.x, 6, 1e-12);
    EXPECT_NEAR(body.position.z, 100 + 2 * 2 - 0.5 * 9.81 * 4, 1e-11);
    EXPECT_NEAR(body.velocity.z, 2 - 9.81 * 2, 1e-12);
}

TEST(Motion, ABounceReachesItsHeight) {
    const World world = ground();
    for (const double restitution : {0.3, 0.5, 0.8, 0.95}) {
        Bodies bodies;
        const BodyId id = add_body(bodies, body_here(ball(0.5), {0, 0, 5.5}));
        bodies.find(id)->restitution = restitution;
        double top = 0;
        bool up = false;
        for (int k = 0; k < 300; ++k) {
            run(bodies, world, 1);
            const Body& body = *bodies.find(id);
            up = up || body.velocity.z > 0;
            if (up && body.velocity.z < 0) break;
            if (up) top = std::max(top, body.position.z - 0.5);
        }
        EXPECT_NEAR(top, 5 * restitution * restitution, 0.02) << restitution;
    }
}

TEST(Motion, ABallThatSlidesComesToRollAtFiveSeventhsOfItsSpeed) {
    const World world = ground();
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.5), {-100, 0, 0.5}));
    bodies.find(id)->velocity = {7, 0, 0};
    bodies.find(id)->rolling = 0;
    run(bodies, world, 300);
    const Body& body = *bodies.find(id);
    EXPECT_NEAR(body.velocity.x, 5, 1e-6);
    EXPECT_NEAR(body.spin.y, 10, 1e-6);
    EXPECT_NEAR(body.position.z, 0.5, 2e-4);
}

TEST(Motion, RollingResistanceBringsItToRest) {
    const World world = ground();
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.5), {0, 0, 0.5}));
    bodies.find(id)->velocity = {2, 0, 0};
    bodies.find(id)->spin = {0, 4, 0};
    run(bodies, world, 1200);
    EXPECT_TRUE(bodies.find(id)->asleep);
    // By a lever of 0.02 radii: v^2 / (2 a), a = 5/7 of 0.02 g.
    EXPECT_NEAR(bodies.find(id)->position.x, 4 / (2 * 0.02 * 9.81 * 5 / 7), 0.3);
}

TEST(Motion, ABoxSlidesFromTheFrictionAngleOn) {
    const World world = ground();
    for (const double slope : {0.3, 0.55, 0.59, 0.61, 0.7}) {
        Bodies bodies;
        const BodyId id = add_body(bodies, body_here(box_body({0.5, 0.5, 0.1}), {0, 0, 0.1}));
        bodies.find(id)->friction = 0.6;
        StepOptions options = never_asleep();
        const double cosine = 1 / std::sqrt(1 + slope * slope);
        options.gravity = {9.81 * slope * cosine, 0, -9.81 * cosine};
        run(bodies, world, 300, options);
        const double slides = slope > 0.6 ? 0.5 * 9.81 * cosine * (slope - 0.6) * 25 : 0;
        EXPECT_NEAR(bodies.find(id)->position.x, slides, 0.01 + slides * 0.01) << slope;
    }
}

TEST(Motion, AFreeSpinnerKeepsMomentumAndEnergy) {
    const World world = ground();
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(box_body({0.5, 0.3, 0.1}), {0, 0, 50}));
    bodies.find(id)->spin = {3, 5, 2};
    StepOptions options = never_asleep();
    options.gravity = {};
    const Vec3 momentum = angular_momentum(*bodies.find(id));
    const double energy = kinetic_energy(*bodies.find(id));
    for (int k = 0; k < 10000; ++k) {
        run(bodies, world, 1, options);
        ASSERT_LT(length(angular_momentum(*bodies.find(id)) - momentum), 1e-10 * length(momentum)) << k;
        ASSERT_NEAR(kinetic_energy(*bodies.find(id)), energy, 1e-3 * energy) << k;
    }
}

TEST(Motion, SpinAboutTheMiddleAxisTumbles) {
    const World world = ground();
    for (int axis = 0; axis < 3; ++axis) {
        Bodies bodies;
        const BodyId id = add_body(bodies, body_here(box_body({0.5, 0.3, 0.1}), {0, 0, 50}));
        Vec3 spin{0.01, 0.01, 0.01};
        spin[axis] = 5;
        bodies.find(id)->spin = spin;
        StepOptions options = never_asleep();
        options.gravity = {};
        int flips = 0;
        double before = 1;
        for (int k = 0; k < 3000; ++k) {
            run(bodies, world, 1, options);
            const Body& body = *bodies.find(id);
            const double along = matrix_of(body.rotation).back(body.spin)[axis];
            flips += along * before < 0;
            before = along;
        }
        // Moments rise with the axes here: the middle one is along y.
        EXPECT_EQ(flips > 3, axis == 1) << axis;
        EXPECT_TRUE(axis == 1 || flips == 0) << axis;
    }
}

TEST(Motion, AStackOfTenStandsForAMinute) {
    const World world = ground();
    Bodies bodies;
    std::vector<BodyId> ids;
    for (int k = 0; k < 10; ++k) ids.push_back(add_body(bodies, body_here(box_body({0.5, 0.5, 0.5}), {0, 0, 0.5 + k})));
    run(bodies, world, 3600, never_asleep());
    for (int k = 0; k < 10; ++k) {
        const Body& body = *bodies.find(ids[std::size_t(k)]);
        EXPECT_LT(length(body.position - Vec3{0, 0, 0.5 + k}), 0.005) << k;
        EXPECT_LT(length(body.velocity), 0.001) << k;
    }
}

TEST(Motion, SmallStacksDoNotSway) {
    const World world = ground();
    for (const double size : {0.2, 0.3, 0.5}) {
        Bodies bodies;
        const Vec3 half = Vec3{1, 1, 1} * (size / 2);
        for (int k = 0; k < 10; ++k) add_body(bodies, body_here(box_body(half), {0, 0, size * (k + 0.5)}));
        run(bodies, world, 600, never_asleep());
        for (const Body& body : bodies.slots) EXPECT_LT(length(body.velocity), 2e-5) << size;
    }
}

/// Eight spheres in the corners of a box of this height, 0.7 m wide.
BodyShape block(double half_height, double radius, double mass) {
    SphereSet spheres;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int axis) { return corner >> axis & 1 ? 1.0 : -1.0; };
        spheres.push_back({{side(0) * 0.25, side(1) * 0.25, side(2) * (half_height - radius)}, radius});
    }
    const Vec3 half{0.35, 0.35, half_height};
    return make_body_shape(spheres, mass_of_box(half, mass / (8 * half.x * half.y * half.z))).value();
}

TEST(Motion, AThousandTimesItsMassRestsOnABody) {
    const World world = ground();
    for (const double mass : {1.0, 30.0, 1000.0}) {
        Bodies bodies;
        const BodyId light = add_body(bodies, body_here(block(0.1, 0.1, 1), {0, 0, 0.1}));
        const BodyId heavy = add_body(bodies, body_here(block(0.5, 0.25, mass), {0, 0, 0.7}));
        run(bodies, world, 1200, never_asleep());
        EXPECT_LT(length(bodies.find(light)->position - Vec3{0, 0, 0.1}), 0.002) << mass;
        EXPECT_LT(length(bodies.find(heavy)->position - Vec3{0, 0, 0.7}), 0.004) << mass;
    }
}

/// Steps a second from long steps to short ones.
constexpr int kRates[] = {10, 30, 60, 144, 1000};

TEST(Motion, ABallComesToRollTheSameInStepsOfAnyLength) {
    const World world = ground();
    for (const int rate : kRates) {
        Bodies bodies;
        const BodyId id = add_body(bodies, body_here(ball(0.5), {-100, 0, 0.5}));
        bodies.find(id)->velocity = {7, 0, 0};
        bodies.find(id)->rolling = 0;
        for (int k = 0; k < 5 * rate; ++k) step(bodies, world, 1.0 / rate, never_asleep());
        const Body& body = *bodies.find(id);
        EXPECT_NEAR(body.velocity.x, 5, 1e-6) << rate;
        EXPECT_NEAR(body.spin.y, 10, 1e-6) << rate;
        // It slides until friction has taken two sevenths.
        const double slows = 0.6 * 9.81, slides = 2 / slows;
        EXPECT_NEAR(body.position.x + 100, 7 * slides - slows * slides * slides / 2 + 5 * (5 - slides), 0.005) << rate;
    }
}

TEST(Motion, ABoxSlidesTheSameInStepsOfAnyLength) {
    const World world = ground();
    for (const double slope : {0.5, 0.7})
        for (const int rate : kRates) {
            Bodies bodies;
            const BodyId id = add_body(bodies, body_here(box_body({0.5, 0.5, 0.1}), {0, 0, 0.1}));
            StepOptions options = never_asleep();
            const double cosine = 1 / std::sqrt(1 + slope * slope);
            options.gravity = {9.81 * slope * cosine, 0, -9.81 * cosine};
            for (int k = 0; k < 5 * rate; ++k) step(bodies, world, 1.0 / rate, options);
            const double speeds_up = std::max(slope - 0.6, 0.0) * 9.81 * cosine;
            const bool stays = slope < 0.6;
            EXPECT_NEAR(bodies.find(id)->velocity.x, speeds_up * 5, stays ? 1e-9 : 0.001) << rate;
            EXPECT_NEAR(bodies.find(id)->position.x, speeds_up * 25 / 2, stays ? 1e-4 : 0.015) << rate;
        }
}

TEST(Motion, ABoxThatTumblesLiesFlatInStepsOfAnyLength) {
    const World world = ground();
    for (const int rate : kRates) {
        Bodies bodies;
        const BodyId id = add_body(bodies, body_here(box_body({0.5, 0.3, 0.2}), {0, 0, 3}));
        bodies.find(id)->spin = {1, 2, 3};
        for (int k = 0; k < 5 * rate; ++k) step(bodies, world, 1.0 / rate);
        const Body& body = *bodies.find(id);
        EXPECT_TRUE(body.asleep) << rate;
        // On one of its three pairs of sides: as high as its half side along that axis, which is upright.
        const TurnMatrix turn = matrix_of(body.rotation);
        const Vec3 half{0.5, 0.3, 0.2};
        int upright = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (std::fabs(turn.column(axis).z) < 0.999) continue;
            ++upright;
            EXPECT_NEAR(body.position.z, half[axis], 1e-4) << rate;
        }
        EXPECT_EQ(upright, 1) << rate;
    }
}

TEST(Motion, NoTimeNoStep) {
    const World world = ground();
    Bodies bodies;
    add_body(bodies, body_here(ball(0.5), {0, 0, 5}));
    const std::uint64_t hash = hash_bodies(bodies);
    for (const double seconds : {0.0, -1.0, double(NAN), double(INFINITY)}) step(bodies, world, seconds);
    StepOptions options;
    options.gravity = {NAN, 0, 0};
    step(bodies, world, 0.01, options);
    EXPECT_EQ(hash_bodies(bodies), hash);
}

}  // namespace
}  // namespace firma

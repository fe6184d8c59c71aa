// SPDX-License-Identifier: MIT
// Closed forms of test_motion.cpp on floors of the blasted depot and of blasted maps, which are in many pieces, and of
// rubble in their air.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/body/level_floors.h"

namespace firma::test {
namespace {

StepOptions kept_awake() {
    StepOptions options;
    options.sleep_after = INFINITY;
    return options;
}

class MotionInLevels : public InBlastedLevels {
protected:
    /// For each place along its way and back.
    template <class Judge>
    void on_floors(double along, double across, double height, std::size_t count, const Judge& judge) {
        const std::vector<FloorPlace> places = floor_places(level().world, along, across, height, count);
        ASSERT_GE(places.size(), 2u);
        std::size_t most = 0;
        for (const FloorPlace& place : places) {
            most = std::max(most, place.faces);
            for (const double way : {1.0, -1.0}) {
                SCOPED_TRACE("at " + std::to_string(place.at.x) + ' ' + std::to_string(place.at.y) + ' ' +
                             std::to_string(place.at.z) + ", " + std::to_string(place.faces) + " faces");
                judge(place.at, place.along * way);
            }
        }
        EXPECT_GE(most, 2u) << "none has a seam";
    }
};
INSTANTIATE_TEST_SUITE_P(, MotionInLevels, testing::Values(0, 1, 2), name_of_blasted_level);

TEST_P(MotionInLevels, ABallThatSlidesComesToRollAtFiveSevenths) {
    on_floors(1.6, 0.5, 1, 4, [&](const Vec3& at, const Vec3& way) {
        Bodies bodies;
        Body body = body_here(ball(0.25), at - way * 1.25 + Vec3{0, 0, 0.25});
        body.velocity = way * 2.8;
        body.rolling = 0;
        const BodyId id = add_body(bodies, body);
        run(bodies, level().world, 60);
        const Body& rolls = *bodies.find(id);
        EXPECT_LT(length(rolls.velocity - way * 2), 1e-6);
        EXPECT_LT(length(rolls.spin - cross({0, 0, 1}, way) * 8), 4e-6);
        EXPECT_NEAR(rolls.position.z - at.z, 0.25, 2e-4);
        EXPECT_LT(std::fabs(dot(rolls.position - at, cross({0, 0, 1}, way))), 1e-6);
    });
}

TEST_P(MotionInLevels, ABounceReachesItsHeight) {
    on_floors(0.5, 0.5, 2.6, 3, [&](const Vec3& at, const Vec3&) {
        for (const double restitution : {0.5, 0.8}) {
            Bodies bodies;
            Body body = body_here(ball(0.25), at + Vec3{0, 0, 2.25});
            body.restitution = restitution;
            const BodyId id = add_body(bodies, body);
            double top = 0;
            bool up = false;
            for (int k = 0; k < 240; ++k) {
                run(bodies, level().world, 1);
                const Body& now = *bodies.find(id);
                up = up || now.velocity.z > 0;
                if (up && now.velocity.z < 0) break;
                if (up) top = std::max(top, now.position.z - at.z - 0.25);
            }
            EXPECT_NEAR(top, 2 * restitution * restitution, 0.01) << restitution;
        }
    });
}

TEST_P(MotionInLevels, ABoxSlidesFromTheFrictionAngleOn) {
    on_floors(1.5, 0.75, 1, 3, [&](const Vec3& at, const Vec3& way) {
        for (const double slope : {0.3, 0.59, 0.61, 0.65}) {
            Bodies bodies;
            const Vec3 start = at - way + Vec3{0, 0, 0.1};
            Body body = body_here(box_body({0.25, 0.25, 0.1}), start);
            body.friction = 0.6;
            const BodyId id = add_body(bodies, body);
            StepOptions options = kept_awake();
            const double cosine = 1 / std::sqrt(1 + slope * slope);
            options.gravity = way * (9.81 * slope * cosine) + Vec3{0, 0, -9.81 * cosine};
            run(bodies, level().world, 150, options);
            const double slides = slope > 0.6 ? 0.5 * 9.81 * cosine * (slope - 0.6) * 6.25 : 0;
            EXPECT_NEAR(dot(bodies.find(id)->position - start, way), slides, 0.01 + slides * 0.01) << slope;
        }
    });
}

TEST_P(MotionInLevels, AStackOfTenStandsForAMinute) {
    const std::vector<FloorPlace> places = floor_places(level().world, 0.4, 0.4, 3.2, 2);
    ASSERT_EQ(places.size(), 2u);
    Bodies bodies;
    for (const FloorPlace& place : places)
        for (int k = 0; k < 10; ++k)
            add_body(bodies, body_here(box_body({0.15, 0.15, 0.15}), place.at + Vec3{0, 0, 0.15 + 0.3 * k}));
    const Bodies start = bodies;
    run(bodies, level().world, 3600, kept_awake());
    for (std::size_t k = 0; k < bodies.slots.size(); ++k) {
        EXPECT_LT(length(bodies.slots[k].position - start.slots[k].position), 0.005) << k;
        // A tenth of what counts as still. How slow stacks on flat ground become: Motion.SmallStacksDoNotSway.
        EXPECT_LT(length(bodies.slots[k].velocity), 0.005) << k;
    }
}

/// Eight spheres in the corners of a box of this height, 0.7 m wide.
BodyShape heavy_block(double half_height, double radius, double mass) {
    SphereSet spheres;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int axis) { return corner >> axis & 1 ? 1.0 : -1.0; };
        spheres.push_back({{side(0) * 0.25, side(1) * 0.25, side(2) * (half_height - radius)}, radius});
    }
    const Vec3 half{0.35, 0.35, half_height};
    return make_body_shape(spheres, mass_of_box(half, mass / (8 * half.x * half.y * half.z))).value();
}

TEST_P(MotionInLevels, AThousandTimesItsMassRestsOnABody) {
    on_floors(0.5, 0.5, 1.5, 2, [&](const Vec3& at, const Vec3& way) {
        if (way.x + way.y < 0) return;  // it is one stack
        Bodies bodies;
        const Vec3 low = at + Vec3{0, 0, 0.1}, high = at + Vec3{0, 0, 0.7};
        const BodyId light = add_body(bodies, body_here(heavy_block(0.1, 0.1, 1), low));
        const BodyId heavy = add_body(bodies, body_here(heavy_block(0.5, 0.25, 1000), high));
        run(bodies, level().world, 600, kept_awake());
        EXPECT_LT(length(bodies.find(light)->position - low), 0.002);
        EXPECT_LT(length(bodies.find(heavy)->position - high), 0.004);
    });
}

TEST_P(MotionInLevels, RubbleThatSpinsFreelyKeepsMomentumAndEnergy) {
    const std::vector<FloorPlace> places = floor_places(level().world, 1, 1, 2.4, 1);
    ASSERT_EQ(places.size(), 1u);
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.9);
    ASSERT_GE(chunks.size(), 3u);
    StepOptions options = kept_awake();
    options.gravity = {};
    for (std::size_t k = 0; k < chunks.size(); k += std::max<std::size_t>(1, chunks.size() / 4)) {
        const Result<Body> made = chunk_over(*chunks[k], 12, places[0].at + Vec3{0, 0, 1.2}, k);
        if (!made) continue;  // no room for a sphere
        Bodies bodies;
        const BodyId id = add_body(bodies, made.value());
        bodies.find(id)->spin = {3, 5, 2};
        const Vec3 momentum = angular_momentum(*bodies.find(id));
        const double energy = kinetic_energy(*bodies.find(id));
        for (int tick = 0; tick < 10000; ++tick) step(bodies, level().world, kTick, options);
        EXPECT_LT(length(angular_momentum(*bodies.find(id)) - momentum), 1e-10 * length(momentum)) << k;
        EXPECT_NEAR(kinetic_energy(*bodies.find(id)), energy, 1e-3 * energy) << k;
    }
}

}  // namespace
}  // namespace firma::test

// SPDX-License-Identifier: MIT
// Rubble of real blasts on parts that move, in the blasted depot and in blasted maps: carried, taken along, pushed,
// crushed against walls with craters, never in the level.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "firma/moving_parts.h"
#include "tests/body/level_floors.h"
#include "tests/moving/part_worlds.h"
#include "tests/reference/judge_bodies.h"

namespace firma::test {
namespace {

constexpr double kDeepest = 1.0 / 1024 + 1e-6;  // metres

class PartsInLevels : public InBlastedLevels {
protected:
    std::vector<FloorPlace> places(double along, double across, double height) {
        return floor_places(level().world, along, across, height, 2);
    }
};
INSTANTIATE_TEST_SUITE_P(, PartsInLevels, testing::Values(0, 1, 2), name_of_blasted_level);

/// One part in a level, whose motion of each step a function of its number gives.
struct LevelRide {
    const World& level;
    std::vector<MovingPart> parts;
    std::function<RigidMotion(int step)> motion;
    Bodies bodies{};
    reference::BodyDepths depths{true};
    StepReport last{};
    int steps = 0;
    std::size_t crushed = 0, met = 0;  ///< met: contacts with the part, of all steps

    LevelRide(const World& world, const World& part) : level(world), parts{MovingPart(part)} {}
    /// Nothing of the level is entered, by crushed bodies neither.
    void tick() {
        parts[0].motion = motion(steps);
        last = step(bodies, Scene{level, parts}, kTick);
        crushed += last.crushed;
        for (const BodyContact& contact : bodies.contacts) met += contact.part == 0;
        ASSERT_EQ(depths.fault(level, bodies), "") << "step " << steps;
        ++steps;
    }
    /// How deep the deepest sphere is in the part, where it is at the end of the step.
    double deepest_in_part() const {
        const World nothing;
        const Scene alone{nothing, parts};
        double depth = 0;
        for (const Body& body : bodies.slots) {
            if (body.crushed || body.stuck) continue;
            const Pose pose = pose_of(body);
            for (const Sphere& sphere : body.shape.spheres()) {
                const Vec3 centre = pose.position + matrix_of(pose.rotation) * sphere.centre;
                const PartNear near = closest(alone, centre, sphere.radius, 1);
                if (near) depth = std::max(depth, sphere.radius - near.distance);
            }
        }
        return depth;
    }
};

RigidMotion goes_straight(const Vec3& from, const Vec3& velocity, int step) {
    RigidMotion motion;
    motion.position = from + velocity * (step * kTick);
    motion.path = velocity * kTick;
    return motion;
}

TEST_P(PartsInLevels, ALiftCarriesRubbleUpAndDown) {
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_GE(chunks.size(), 2u);
    std::size_t carried = 0;
    for (const FloorPlace& place : places(1, 1, 2.8)) {
        LevelRide ride(level().world, box_world({-0.875, -0.875, -0.125}, {0.875, 0.875, 0}));
        const Vec3 low = place.at + Vec3{0, 0, 0.25};
        const auto height = [](int step) { return step < 240 ? 0 : 0.4 - 0.4 * std::cos(1.5 * (step - 240) * kTick); };
        ride.motion = [&](int step) {
            RigidMotion motion;
            motion.position = low + Vec3{0, 0, height(step)};
            motion.path = {0, 0, height(step + 1) - height(step)};
            return motion;
        };
        const Result<Body> made = chunk_over(*chunks[carried % chunks.size()], 40, low + Vec3{0, 0, 0.7}, 3);
        if (!made) continue;
        const BodyId id = add_body(ride.bodies, made.value());
        for (int k = 0; k < 240; ++k) {
            ride.tick();
            if (HasFatalFailure()) return;
        }
        const double over = ride.bodies.find(id)->position.z - low.z;
        for (int k = 240; k < 740; ++k) {
            ride.tick();
            if (HasFatalFailure()) return;
            const double now = ride.bodies.find(id)->position.z - low.z - height(k + 1);
            ASSERT_NEAR(now, over, 0.004) << k;
            ASSERT_LT(ride.deepest_in_part(), kDeepest) << k;
        }
        EXPECT_EQ(ride.crushed, 0u);
        ++carried;
    }
    EXPECT_GE(carried, 1u);
}

TEST_P(PartsInLevels, APlatformTakesRubbleAlong) {
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_GE(chunks.size(), 2u);
    std::size_t taken = 0;
    for (const FloorPlace& place : places(2.2, 1, 1.8)) {
        LevelRide ride(level().world, box_world({-0.875, -0.875, -0.125}, {0.875, 0.875, 0}));
        const Vec3 from = place.at - place.along * 1.2 + Vec3{0, 0, 0.25};
        bool goes = false;
        int since = 0;
        ride.motion = [&](int) { return goes_straight(from, goes ? place.along : Vec3{}, goes ? since++ : 0); };
        const Result<Body> made = chunk_over(*chunks.back(), 40, from + Vec3{0, 0, 0.6}, 5);
        if (!made) continue;
        const BodyId id = add_body(ride.bodies, made.value());
        for (int k = 0; k < 240; ++k) ride.tick();
        const double start = dot(ride.bodies.find(id)->position, place.along);
        goes = true;
        for (int k = 0; k < 120; ++k) ride.tick();
        if (HasFatalFailure()) return;
        const double went = dot(ride.bodies.find(id)->position, place.along) - start;
        // It rolls or slides by no more than its own size, and moves along in the end.
        EXPECT_NEAR(went, 2, 0.4);
        EXPECT_NEAR(dot(ride.bodies.find(id)->velocity, place.along), 1, 0.02);
        ++taken;
    }
    EXPECT_GE(taken, 1u);
}

/// A wall across the place sweeps it from end to end and back, faster each time: 4 m in 120, 60, 40, ... steps.
TEST_P(PartsInLevels, ADoorThatPushesPutsNothingIntoTheLevel) {
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_GE(chunks.size(), 2u);
    std::size_t pushed = 0, bodies = 0;
    for (const FloorPlace& place : places(1.2, 1, 1.8)) {
        const bool along_x = place.along.x == 1;
        const Vec3 half = along_x ? Vec3{0.125, 0.75, 0.75} : Vec3{0.75, 0.125, 0.75};
        LevelRide ride(level().world, box_world(half * -1.0, half));
        // 4 m there and 4 m back, beyond the place: through walls, too.
        const Vec3 from = place.at - place.along * 2 + Vec3{0, 0, 0.875};
        std::vector<RigidMotion> motions;
        for (int round = 0; round < 6; ++round)
            for (int steps = 120 / (round + 1), step = 0; step < steps; ++step) {
                const double speed = (round % 2 ? -4 : 4) / (steps * kTick);
                motions.push_back(goes_straight(round % 2 ? from + place.along * 4 : from, place.along * speed, step));
            }
        ride.motion = [&](int step) { return motions[std::size_t(step)]; };
        for (std::size_t k = 0; k < 6; ++k) {
            const Vec3 at = place.at + place.along * (0.3 * double(k) - 0.75) + Vec3{0, 0, 0.6 + 0.12 * double(k)};
            if (const Result<Body> made = chunk_over(*chunks[chunks.size() - 1 - k % chunks.size()], 24, at, k))
                add_body(ride.bodies, made.value());
        }
        std::vector<Vec3> before;
        for (const Body& body : ride.bodies.slots) before.push_back(body.position);
        for (std::size_t k = 0; k < motions.size(); ++k) {
            ride.tick();
            if (HasFatalFailure()) return;
        }
        for (std::size_t k = 0; k < before.size(); ++k) pushed += length(ride.bodies.slots[k].position - before[k]) > 1;
        bodies += before.size();
    }
    EXPECT_GE(bodies, 4u);
    EXPECT_GE(pushed, 1u);
}

/// Rubble falls to the floor; a slab comes down on it to 2 cm above the floor, stays for a second, and goes up again.
TEST_P(PartsInLevels, APressThatCrushesPutsNothingIntoTheLevel) {
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_GE(chunks.size(), 2u);
    std::size_t pressed = 0, crushed = 0;
    for (const FloorPlace& place : places(1, 1, 2.4)) {
        LevelRide ride(level().world, box_world({-0.875, -0.875, 0}, {0.875, 0.875, 0.125}));
        constexpr double kHigh = 2.2, kLow = 0.02;  // metres above the floor
        const auto height = [&](int step) {
            const double down = std::clamp((step - 120) * kTick, 0.0, 1.0), up = std::clamp(step / 60.0 - 4, 0.0, 1.0);
            return kHigh - (kHigh - kLow) * (down - up);
        };
        ride.motion = [&](int step) {
            RigidMotion motion;
            motion.position = place.at + Vec3{0, 0, height(step)};
            motion.path = {0, 0, height(step + 1) - height(step)};
            return motion;
        };
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 at = place.at + Vec3{k % 2 ? 0.3 : -0.3, k / 2 ? 0.3 : -0.3, 0.9};
            if (const Result<Body> made = chunk_over(*chunks[chunks.size() - 1 - k % chunks.size()], 24, at, k))
                add_body(ride.bodies, made.value());
        }
        pressed += ride.bodies.slots.size();
        for (int k = 0; k < 360; ++k) {
            ride.tick();
            if (HasFatalFailure()) return;
        }
        crushed += ride.crushed;
        // The slab is up again: nothing is crushed any more, or in it.
        EXPECT_EQ(ride.last.crushed, 0u);
        EXPECT_EQ(ride.last.stuck, 0u);
        EXPECT_LT(ride.deepest_in_part(), kDeepest);
    }
    EXPECT_GE(pressed, 2u);
    EXPECT_GE(crushed, pressed * 15);
}

TEST_P(PartsInLevels, ABladeAmongRubbleIsNotEntered) {
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_GE(chunks.size(), 2u);
    const std::vector<FloorPlace> all = places(1.4, 1.4, 2.4);
    ASSERT_GE(all.size(), 1u);
    LevelRide ride(level().world, cross_world());
    const Vec3 middle = all[0].at + Vec3{0, 0, 1};
    ride.motion = [&](int step) {
        RigidMotion motion;
        motion.position = middle;
        motion.rotation = turn_by({0, 0, 6 * kTick * step});
        motion.turn = {0, 0, 6 * kTick};
        return motion;
    };
    for (std::size_t k = 0; k < 8; ++k) {
        const Vec3 at = middle + Vec3{0.4 * double(k % 3) - 0.4, 0.4 * double(k / 3) - 0.4, 0.8 + 0.05 * double(k)};
        if (const Result<Body> made = chunk_over(*chunks[chunks.size() - 1 - k % chunks.size()], 24, at, k))
            add_body(ride.bodies, made.value());
    }
    EXPECT_GE(ride.bodies.slots.size(), 4u);
    for (int k = 0; k < 300; ++k) {
        ride.tick();
        if (HasFatalFailure()) return;
        ASSERT_LT(ride.deepest_in_part(), kDeepest + 1e-4) << k;
    }
    EXPECT_GE(ride.met, 10u);
}

}  // namespace
}  // namespace firma::test

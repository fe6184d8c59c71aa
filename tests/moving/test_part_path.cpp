// SPDX-License-Identifier: MIT
// Motions by time: doors, lifts and trains between stops, spins and swings.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "firma/part_path.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

/// Opens in 2 s, waits 3, shuts in 2.
PartPath sliding_door() {
    PartPath path;
    path.stops = {{{1, 0, 0}, 0, 0, 2}, {{1, 0, 4}, 0, 3, 2}};
    return path;
}

TEST(PartPath, DoorOpensWaitsAndShuts) {
    const PartPath door = sliding_door();
    const auto height = [&](double seconds) { return part_pose(door, seconds).position.z; };
    for (const double seconds : {-5.0, 0.0, 7.0, 1000.0}) EXPECT_EQ(height(seconds), 0) << seconds;
    EXPECT_EQ(height(1), 2);
    for (const double seconds : {2.0, 3.5, 4.999}) EXPECT_EQ(height(seconds), 4) << seconds;
    EXPECT_EQ(height(6), 2);
    EXPECT_TRUE(at_first_stop(door, -1));
    EXPECT_FALSE(at_first_stop(door, 0.001));
    EXPECT_FALSE(at_first_stop(door, 6.999));
    EXPECT_TRUE(at_first_stop(door, 7));
    EXPECT_EQ(next_stop(door, -1), 0);
    EXPECT_EQ(next_stop(door, 0.5), 2);
    EXPECT_EQ(next_stop(door, 2), 5);
    EXPECT_EQ(next_stop(door, 5.5), 7);
    EXPECT_EQ(next_stop(door, 7), kForEver);
    PartPath stays = door;
    stays.stops[1].wait = kForEver;
    EXPECT_EQ(part_pose(stays, 1e9).position.z, 4);
    EXPECT_EQ(next_stop(stays, 2.5), kForEver);
}

TEST(PartPath, TrainGoesRoundForEver) {
    PartPath train;
    train.repeats = true;
    train.stops = {{{0, 0, 0}, 0, 1, 2}, {{4, 0, 0}, 0, 0, 1}, {{4, 2, 0}, 0, 0.5, 3}};
    const double whole = 7.5;
    for (int round = 0; round < 50; ++round) {
        const double at = whole * round;
        EXPECT_EQ(part_pose(train, at + 0.5).position, (Vec3{0, 0, 0}));
        EXPECT_EQ(part_pose(train, at + 2).position, (Vec3{2, 0, 0}));
        EXPECT_EQ(part_pose(train, at + 3.5).position, (Vec3{4, 1, 0}));
        EXPECT_EQ(part_pose(train, at + 4.25).position, (Vec3{4, 2, 0}));
        EXPECT_EQ(part_pose(train, at + 6).position, (Vec3{2, 1, 0}));
    }
    int stops = 0;
    for (double t = 0; t < 10 * whole; t = next_stop(train, t)) ++stops;
    EXPECT_EQ(stops, 10 * 5);  // of each round: leaves 0, 4 and 4, arrives at 4 and 0
}

TEST(PartPath, SpinKeepsItsPaceForDays) {
    PartPath blade;
    blade.spin = 3;
    blade.rotation = turn_by({0.4, 0, 0});
    for (const double seconds : {0.0, 0.7, 86400.0, -20.0, 3e7}) {
        const Pose pose = part_pose(blade, seconds);
        const Quaternion wanted = compose(
            turn_by({0, 0, double(remainderl(3.0L * seconds, 2 * std::numbers::pi_v<long double>))}), blade.rotation);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 unit;
            unit[axis] = 1;
            EXPECT_LT(length(matrix_of(pose.rotation) * unit - matrix_of(wanted) * unit), 1e-7) << seconds;
        }
        const RigidMotion tick = part_motion(blade, seconds, seconds + 0.01);
        EXPECT_NEAR(tick.turn.z, 0.03, 1e-7);
        EXPECT_EQ(tick.path, (Vec3{}));
    }
}

TEST(PartPath, SwingsAreSinesOfTheTime) {
    PartPath bob;
    bob.stops = {{{1, 2, 3}, 0, 0, 0}};
    bob.swing = {{0, 0, 0.5}, 0.25, 4, 0.125};
    for (int k = -40; k < 400; ++k) {
        const double seconds = k * 0.1, sine = std::sin(2 * std::numbers::pi * (seconds / 4 + 0.125));
        const Pose pose = part_pose(bob, seconds);
        EXPECT_LT(length(pose.position - Vec3{1, 2, 3 + 0.5 * sine}), 1e-12);
        EXPECT_LT(
            length(matrix_of(pose.rotation) * Vec3{1, 0, 0} - Vec3{std::cos(0.25 * sine), std::sin(0.25 * sine), 0}),
            1e-12);
    }
}

/// The motion of a tick begins and ends where the part is; on one leg it is the path.
TEST(PartPath, TicksAreThePathItself) {
    PartPath door;
    door.axis = {0, 0.6, 0.8};
    door.rotation = turn_by({0.3, 0.2, -1});
    door.stops = {{{0, 0, 0}, 0, 0, 1}, {{3, 1, 0}, 1.5, 2, 1.5}};
    door.swing = {{0.1, 0, 0}, 0, 0, 0};  // no period: none
    scenes::Rng rng(31);
    for (int k = 0; k < 2000; ++k) {
        const double from = rng.uniform(-1, 6), to = from + rng.uniform(0, 0.4);
        const RigidMotion motion = part_motion(door, from, to);
        const bool one_leg = next_stop(door, from) >= to;
        for (const double fraction : {0.0, 0.3, 1.0}) {
            if (!one_leg && fraction != 0 && fraction != 1) continue;
            const Pose got = pose_at(motion, fraction), wanted = part_pose(door, from + (to - from) * fraction);
            EXPECT_LT(length(got.position - wanted.position), 1e-12);
            for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}})
                EXPECT_LT(length(matrix_of(got.rotation) * axis - matrix_of(wanted.rotation) * axis), 1e-12);
        }
    }
}

TEST(PartPath, WhatMakesNoSenseEnds) {
    PartPath odd;
    odd.repeats = true;
    odd.stops = {{{1, 0, 0}, 0, 0, 0}, {{2, 0, 0}, 0, -3, NAN}};
    EXPECT_EQ(part_pose(odd, 5).position, (Vec3{1, 0, 0}));  // no time passes anywhere: it is back at once
    EXPECT_GT(next_stop(odd, 5), 5);
    for (const double seconds : {double(NAN), kForEver}) {
        EXPECT_FALSE(is_finite(part_pose(sliding_door(), seconds).position));
        EXPECT_FALSE(is_finite(part_motion(sliding_door(), 0, seconds).path));
    }
    PartPath spins;
    spins.spin = kForEver;
    EXPECT_FALSE(is_finite(part_pose(spins, 1).rotation[0]));
    EXPECT_FALSE(is_finite(part_motion(spins, 0, 1).turn.z));
    EXPECT_EQ(part_pose(PartPath{}, 3).position, (Vec3{}));
}

}  // namespace
}  // namespace firma

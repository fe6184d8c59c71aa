// SPDX-License-Identifier: MIT
// Moving sets of spheres: straight as their spheres alone, turning never late, against each other as sampled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/cast_set.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma {
namespace {

using scenes::Rng;

/// Spheres on a row, as a plank has them.
SphereSet plank() {
    SphereSet spheres;
    for (int k = -8; k <= 8; ++k) spheres.push_back({{k * 0.1, 0, 0}, 0.08});
    return spheres;
}

Vec3 centre_at(const RigidMotion& motion, double fraction, const Sphere& sphere) {
    const Pose pose = pose_at(motion, fraction);
    return pose.position + matrix_of(pose.rotation) * sphere.centre;
}

/// Metres between the nearest sphere and faces that bound solid; up to 0.2.
double gap_at(const World& world, const SphereSet& spheres, const RigidMotion& motion, double fraction) {
    double least = 0.2;
    for (const Sphere& sphere : spheres) {
        const NearFace near = closest(world, centre_at(motion, fraction, sphere), sphere.radius + least);
        if (near && world.face_info(near.face)->solid) least = std::min(least, near.distance - sphere.radius);
    }
    return least;
}

/// Random ways of a set that starts clear of all, in rooms.
template <class Use>
void for_motions(const World& world, const SphereSet& spheres, double turn, int count, const Use& use) {
    Rng rng(7);
    const Box box = world.bounds();
    for (int made = 0; made < count;) {
        RigidMotion motion;
        for (int axis = 0; axis < 3; ++axis) motion.position[axis] = rng.uniform(box.low[axis], box.high[axis]);
        if (locate(world, motion.position).where != Where::kAir) continue;
        motion.rotation = random_turn(rng.next());
        motion.path = test::random_vector(rng, 0, 3);
        motion.turn = rng.direction() * turn;
        if (gap_at(world, spheres, motion, 0) < 0.002) continue;
        ++made;
        use(motion);
    }
}

TEST(CastSet, StraightAsItsSpheresAlone) {
    const World world = test::depot_world();
    const SphereSet spheres = plank();
    std::size_t hits = 0;
    for_motions(world, spheres, 0, test::sample(1500), [&](const RigidMotion& motion) {
        const SetHit hit = cast(world, spheres, motion);
        Hit first;
        std::uint32_t which = ~0u;
        for (std::uint32_t k = 0; k < spheres.size(); ++k) {
            const Hit one = cast(world, {centre_at(motion, 0, spheres[k]), spheres[k].radius}, motion.path);
            if (one.touched() && (!first.touched() || one.fraction < first.fraction)) first = one, which = k;
        }
        ASSERT_EQ(hit.touched(), first.touched());
        EXPECT_EQ(hit.fraction, first.fraction);
        EXPECT_EQ(hit.sphere, which);
        EXPECT_EQ(hit.face, first.face);
        EXPECT_EQ(hit.centre, first.touched() ? first.centre : motion.position + motion.path);
        hits += hit.touched();
    });
    EXPECT_GT(hits, std::size_t(test::sample(100)));
}

TEST(CastSet, TurningIsNeverLateAndHardlyEarly) {
    const World world = test::depot_world();
    const SphereSet spheres = plank();
    for (const double turn : {0.3, 3.0, 20.0}) {
        std::size_t hits = 0;
        for_motions(world, spheres, turn, test::sample(300), [&](const RigidMotion& motion) {
            const SetHit hit = cast(world, spheres, motion);
            const double end = hit.touched() ? hit.fraction : 1;
            for (int k = 0; k <= 64; ++k)
                EXPECT_GT(gap_at(world, spheres, motion, end * k / 64), -1e-9) << "at " << k << " of 64";
            if (!hit.touched()) return;
            ++hits;
            const double early =
                length(centre_at(motion, end, spheres[hit.sphere]) - hit.point) - spheres[hit.sphere].radius;
            EXPECT_LE(early, 2 * kMaxBulge + 1e-9);
            EXPECT_LE(hit.safe_fraction, hit.fraction);
            EXPECT_LT(length(hit.centre - centre_at(motion, hit.fraction, spheres[hit.sphere])), 2 * kMaxBulge);
        });
        EXPECT_GT(hits, std::size_t(test::sample(20)));
    }
}

// Swings past the ground's plane within one piece: it dips 0.02 mm, from 0.01 mm above, and ends higher than it began.
TEST(CastSet, WhatDipsBeforeItRisesIsMet) {
    const World world = test::ground();
    constexpr double kRadius = 0.1, kArm = 1, kGap = 1e-5, kDip = 2e-5;
    const double before = std::sqrt(2 * kDip / kArm), all = 2.4 * before;  // radians to the lowest point, and in all
    ASSERT_LT(all * all / 8 * kArm, kMaxBulge);
    const Sphere sphere{{-kArm * std::sin(before), 0, -kArm * std::cos(before)}, kRadius};
    RigidMotion motion;
    motion.position = {0, 0, kGap + kRadius + kArm * std::cos(before)};
    motion.turn = {0, -all, 0};
    ASSERT_GT(gap_at(world, {sphere}, motion, 1), kGap);
    ASSERT_LT(gap_at(world, {sphere}, motion, before / all), -0.9 * (kDip - kGap));
    const SetHit hit = cast(world, {&sphere, 1}, motion);
    EXPECT_TRUE(hit.touched());
    EXPECT_LT(hit.fraction, before / all);
    const SetPartHit in_scene = cast(Scene{world}, {&sphere, 1}, motion);
    EXPECT_TRUE(in_scene.touched());
    EXPECT_LT(in_scene.fraction, before / all);
    motion.position.z += 2 * (kDip + kMaxBulge);
    EXPECT_FALSE(cast(world, {&sphere, 1}, motion).touched());
}

TEST(CastSet, OfNothingOrOfWhatIsNoNumber) {
    const World world = test::depot_world();
    const SphereSet spheres = plank();
    RigidMotion motion;
    motion.path = {1, 0, 0};
    EXPECT_EQ(cast(world, {}, motion).status, Status::kMiss);
    EXPECT_EQ(cast(World(), spheres, motion).status, Status::kMiss);
    for (int k = 0; k < 4; ++k) {
        RigidMotion bad = motion;
        if (k == 0) bad.position.y = NAN;
        if (k == 1) bad.path.z = INFINITY;
        if (k == 2) bad.turn.x = 2 * kMaxAngle;
        if (k == 3) bad.rotation[2] = NAN;
        const SetHit hit = cast(world, spheres, bad);
        EXPECT_EQ(hit.status, Status::kInvalid) << k;
        EXPECT_EQ(hit.fraction, 0);
        EXPECT_EQ(cast(spheres, bad, spheres, motion).status, Status::kInvalid) << k;
        EXPECT_EQ(cast(spheres, motion, spheres, bad).status, Status::kInvalid) << k;
    }
    const Sphere bad{{0, 0, 0}, -1};
    EXPECT_EQ(cast(world, {&bad, 1}, motion).status, Status::kInvalid);
}

TEST(CastSetPair, AsSampled) {
    Rng rng(11);
    const SphereSet spheres = plank();
    std::size_t hits = 0;
    for (int k = 0; k < test::sample(2000); ++k) {
        RigidMotion a, b;
        a.rotation = random_turn(rng.next());
        b.rotation = random_turn(rng.next());
        b.position = test::random_vector(rng, 0.3, 3);
        a.path = test::random_vector(rng, 0, 4);
        b.path = test::random_vector(rng, 0, 4);
        a.turn = test::random_vector(rng, 0, 6);
        if (k % 3) b.turn = test::random_vector(rng, 0, 6);
        const auto gap = [&](double fraction) {
            double least = INFINITY;
            for (const Sphere& one : spheres)
                for (const Sphere& other : spheres)
                    least = std::min(least, length(centre_at(a, fraction, one) - centre_at(b, fraction, other)) -
                                                one.radius - other.radius);
            return least;
        };
        if (gap(0) < 1e-3) continue;
        const SetPairHit hit = cast(spheres, a, spheres, b);
        const double end = hit.touched() ? hit.fraction : 1;
        for (int step = 0; step <= 32; ++step) EXPECT_GT(gap(end * step / 32), -1e-9);
        if (!hit.touched()) continue;
        ++hits;
        EXPECT_LE(gap(end), 4 * kMaxBulge + 1e-9);
        EXPECT_NEAR(length(hit.normal), 1, 1e-12);
        const Vec3 of_b = centre_at(b, end, spheres[hit.sphere_b]);
        EXPECT_NEAR(length(hit.point - of_b), spheres[hit.sphere_b].radius, 1e-9);
    }
    EXPECT_GT(hits, std::size_t(test::sample(200)));
}

TEST(CastSetPair, OverlapAtTheStart) {
    const Sphere ball{{0, 0, 0}, 1};
    RigidMotion a, b;
    b.position = {1.5, 0, 0};
    a.path = {1, 0, 0};
    EXPECT_EQ(cast({&ball, 1}, a, {&ball, 1}, b).status, Status::kInitialOverlap);
    EXPECT_EQ(cast({&ball, 1}, a, {&ball, 1}, b).normal, (Vec3{-1, 0, 0}));
    a.path = {-1, 0, 0};
    EXPECT_EQ(cast({&ball, 1}, a, {&ball, 1}, b).status, Status::kMiss);
    EXPECT_EQ(cast({}, a, {&ball, 1}, b).status, Status::kMiss);
}

}  // namespace
}  // namespace firma

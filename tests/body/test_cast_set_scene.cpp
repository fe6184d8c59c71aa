// SPDX-License-Identifier: MIT
// Moving sets of spheres against a level and parts that move and turn meanwhile: as against worlds, as sampled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/cast_set.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/moving/part_worlds.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma {
namespace {

using scenes::Rng;

/// Spheres on a row, as a bar has them.
SphereSet bar() {
    SphereSet spheres;
    for (int k = -4; k <= 4; ++k) spheres.push_back({{k * 0.2, 0, 0}, 0.1});
    return spheres;
}

Vec3 middle_of(const RigidMotion& motion, double fraction, const Sphere& sphere) {
    const Pose pose = pose_at(motion, fraction);
    return pose.position + matrix_of(pose.rotation) * sphere.centre;
}

/// Metres between the nearest sphere and what is nearest to it, level or part; up to 0.2.
double gap_in(const Scene& scene, const SphereSet& spheres, const RigidMotion& motion, double fraction) {
    double least = 0.2;
    for (const Sphere& sphere : spheres) {
        const PartNear near = closest(scene, middle_of(motion, fraction, sphere), sphere.radius + least, fraction);
        if (near.found()) least = std::min(least, near.distance - sphere.radius);
    }
    return least;
}

/// A way near parts that fly about the origin.
RigidMotion random_way(Rng& rng, double turn) {
    RigidMotion motion;
    motion.position = test::random_vector(rng, -3, 3);
    motion.rotation = random_turn(rng.next());
    motion.path = test::random_vector(rng, -4, 4);
    motion.turn = rng.direction() * turn;
    return motion;
}

TEST(CastSetScene, WithoutPartsIsThatOfTheWorld) {
    const World world = test::depot_world();
    const Box box = world.bounds();
    const SphereSet spheres = bar();
    Rng rng(3);
    std::size_t hits = 0;
    for (int k = 0; k < test::sample(1500); ++k) {
        RigidMotion motion = random_way(rng, k % 2 ? 3.0 : 0.0);
        for (int axis = 0; axis < 3; ++axis) motion.position[axis] = rng.uniform(box.low[axis], box.high[axis]);
        if (gap_in(Scene{world}, spheres, motion, 0) < 0.002) continue;
        const SetHit of_world = cast(world, spheres, motion);
        const SetPartHit of_scene = cast(Scene{world}, spheres, motion);
        ASSERT_EQ(of_scene.status, of_world.status) << k;
        EXPECT_EQ(of_scene.fraction, of_world.fraction) << k;
        EXPECT_EQ(of_scene.sphere, of_world.sphere) << k;
        EXPECT_EQ(of_scene.face, of_world.face) << k;
        EXPECT_EQ(of_scene.part, kNoPart);
        EXPECT_NEAR(of_scene.safe_fraction, of_world.safe_fraction, 1e-9) << k;
        hits += of_world.touched();
    }
    EXPECT_GT(hits, std::size_t(test::sample(40)));
}

TEST(CastSetScene, PartsThatTurnAreMetNeverLateAndHardlyEarly) {
    const World level = test::box_world({-20, -20, -9}, {20, 20, -8});
    const SphereSet spheres = bar();
    Rng rng(5);
    std::size_t hits = 0, of_parts = 0;
    for (int k = 0; k < test::sample(400); ++k) {
        const RigidMotion slides{test::random_vector(rng, -2, 2), {0, 0, 0, 1}, test::random_vector(rng, -3, 3), {}};
        RigidMotion spins{
            test::random_vector(rng, -2, 2), random_turn(rng.next()), test::random_vector(rng, -3, 3), {}};
        spins.turn = rng.direction() * 4.0;
        const std::vector<MovingPart> parts{MovingPart(test::box_world({-1, -0.25, -1}, {1, 0.25, 1}), slides),
                                            MovingPart(test::box_world({-2, -0.125, -0.5}, {2, 0.125, 0.5}), spins)};
        const Scene scene{level, parts};
        const RigidMotion motion = random_way(rng, k % 3 ? 2.5 : 0.0);
        if (gap_in(scene, spheres, motion, 0) < 0.002) continue;
        const SetPartHit hit = cast(scene, spheres, motion);
        ASSERT_NE(hit.status, Status::kInvalid) << k;
        const double end = hit.touched() ? hit.fraction : 1;
        for (int at = 0; at <= 64; ++at)
            ASSERT_GT(gap_in(scene, spheres, motion, end * at / 64), -1e-6) << k << " at " << at << " of 64";
        if (!hit.touched()) continue;
        ++hits;
        of_parts += hit.part != kNoPart;
        // Metres: of the arcs and of parts that turn.
        EXPECT_LE(gap_in(scene, spheres, motion, end), 2 * kMaxBulge + 2 * kPartTouch) << k;
        EXPECT_LE(hit.safe_fraction, hit.fraction);
        EXPECT_LT(length(hit.centre - middle_of(motion, end, spheres[hit.sphere])), 2 * kMaxBulge);
    }
    EXPECT_GT(hits, std::size_t(test::sample(60)));
    EXPECT_GT(of_parts, std::size_t(test::sample(50)));
}

TEST(CastSetScene, HalfAStretchIsHalfTheWayOfParts) {
    const World level = test::box_world({-20, -20, -9}, {20, 20, -8});
    const SphereSet spheres = bar();
    const RigidMotion falls{{0, 0, 6}, {0, 0, 0, 1}, {0, 0, -8}, {}};
    const std::vector<MovingPart> parts{MovingPart(test::box_world({-1, -1, 0}, {1, 1, 1}), falls)};
    const RigidMotion stands{{0, 0, 0}, {0, 0, 0, 1}, {}, {}};
    const SetPartHit whole = cast(Scene{level, parts}, spheres, stands);
    EXPECT_EQ(whole.part, 0u);
    EXPECT_NEAR(whole.fraction, 5.9 / 8, 1e-12);
    EXPECT_NEAR(whole.surface_velocity.z, -8, 1e-12);
    EXPECT_NEAR(whole.safe_fraction, (5.9 - 0.001) / 8, 1e-9);
    const SetPartHit later = cast(Scene{level, parts, 0.5, 1}, spheres, stands);
    EXPECT_NEAR(later.fraction, 1.9 / 4, 1e-12);
    EXPECT_EQ(cast(Scene{level, parts, 0, 0.5}, spheres, stands).status, Status::kMiss);
}

TEST(CastSetScene, WhatCannotBeCastIsInvalid) {
    const World level = test::box_world({-1, -1, -2}, {1, 1, -1});
    const SphereSet spheres = bar();
    RigidMotion motion;
    motion.path = {0, 0, 1};
    EXPECT_EQ(cast(Scene{level}, {}, motion).status, Status::kMiss);
    EXPECT_EQ(cast(Scene{level, {}, 0.5, 2}, spheres, motion).status, Status::kInvalid);
    motion.path.x = NAN;
    EXPECT_EQ(cast(Scene{level}, spheres, motion).status, Status::kInvalid);
    motion.path.x = 0;
    const Sphere bad{{0, 0, 0}, -1};
    EXPECT_EQ(cast(Scene{level}, {&bad, 1}, motion).status, Status::kInvalid);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Casts, overlaps and nearest points of a level with parts that move straight, or stand turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "firma/cast_set.h"
#include "tests/body/simple_bodies.h"
#include "tests/moving/part_worlds.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma {
namespace {

using scenes::Rng;

void expect_same_touch(const PartHit& got, const Hit& wanted) {
    ASSERT_EQ(got.status, wanted.status);
    EXPECT_EQ(got.fraction, wanted.fraction);
    EXPECT_EQ(got.safe_fraction, wanted.safe_fraction);
    EXPECT_EQ(got.normal, wanted.normal);
    EXPECT_EQ(got.face_normal, wanted.face_normal);
    EXPECT_EQ(got.feature, wanted.feature);
    EXPECT_EQ(got.feature_index, wanted.feature_index);
    EXPECT_EQ(got.face, wanted.face);
}

/// Its surface velocity is the part's path, its point that of the other cast, moved by the part.
void expect_place(const PartHit& got, const Hit& wanted, const RigidMotion& motion) {
    if (!wanted.touched()) {
        EXPECT_EQ(got.part, kNoPart);
        return;
    }
    EXPECT_EQ(got.part, 0u);
    EXPECT_EQ(got.surface_velocity, motion.path);
    EXPECT_LT(length(got.point - (wanted.point + motion.position + motion.path * wanted.fraction)), 1e-12);
}

TEST(MovingParts, StraightIsTheRelativeCastToTheBit) {
    const World empty, solid = test::cross_world();
    Rng rng(21);
    std::size_t hits = 0;
    for (int k = 0; k < test::sample(4000); ++k) {
        const MovingPart part(solid, test::random_motion(rng, 0, 0));
        const Scene scene{empty, {&part, 1}};
        const RigidMotion& motion = part.motion;
        const Vec3 at = test::random_vector(rng, 0, 3);
        const Vec3 path = k % 5 ? test::random_vector(rng, 0, 3) : Vec3{};
        const Vec3 there = at - motion.position, way = path - motion.path;
        const double radius = k % 3 ? rng.uniform(0, 0.4) : 0;
        const PartHit ball = cast(scene, Sphere{at, radius}, path);
        const Hit same = cast(solid, Sphere{there, radius}, way);
        expect_same_touch(ball, same);
        expect_place(ball, same, motion);
        EXPECT_EQ(ball.centre, at + path * ball.fraction);
        hits += ball.touched();

        const Vec3 half = rng.direction() * 0.5;
        const Capsule capsule{at - half, at + half, radius};
        const Capsule moved{capsule.from - motion.position, capsule.to - motion.position, radius};
        const PartHit pill = cast(scene, capsule, path);
        expect_same_touch(pill, cast(solid, moved, way));
        expect_place(pill, cast(solid, moved, way), motion);

        const Hull box = make_box({0.3, 0.2, 0.4}).value();
        const PartHit block = cast(scene, box, at, path);
        expect_same_touch(block, cast(solid, box, there, way));
        expect_place(block, cast(solid, box, there, way), motion);
        EXPECT_EQ(cast_any(scene, box, at, path) != Status::kMiss, block.touched());
        EXPECT_EQ(cast_any(scene, capsule, path) != Status::kMiss, pill.touched());
        EXPECT_EQ(cast_any(scene, Sphere{at, radius}, path) != Status::kMiss, ball.touched());
    }
    EXPECT_GT(hits, std::size_t(test::sample(400)));
}

TEST(MovingParts, TurnedIsTheCastTurnedBack) {
    const World empty, solid = test::cross_world();
    Rng rng(22);
    std::size_t hits = 0;
    for (int k = 0; k < test::sample(3000); ++k) {
        const MovingPart part(solid, test::random_motion(rng, 1, 0));
        const Scene scene{empty, {&part, 1}};
        const TurnMatrix rotation = matrix_of(normalised(part.motion.rotation));
        const Vec3 at = test::random_vector(rng, 0, 3), path = test::random_vector(rng, 0, 3);
        const Vec3 there = rotation.back(at - part.motion.position), way = rotation.back(path - part.motion.path);
        const PartHit got = cast(scene, Sphere{at, 0.25}, path);
        const Hit wanted = cast(solid, Sphere{there, 0.25}, way);
        ASSERT_EQ(got.status, wanted.status) << k;
        EXPECT_NEAR(got.fraction, wanted.fraction, 1e-9);
        EXPECT_NEAR(got.safe_fraction, wanted.safe_fraction, 1e-9);
        if (!got) continue;
        ++hits;
        EXPECT_LT(length(got.normal - rotation * wanted.normal), 1e-6);
        EXPECT_LT(length(got.face_normal - rotation * wanted.face_normal), 1e-12);
        const Vec3 point = part.motion.position + part.motion.path * got.fraction + rotation * wanted.point;
        EXPECT_LT(length(got.point - point), 1e-6);
    }
    EXPECT_GT(hits, std::size_t(test::sample(400)));
}

/// A hull against a turned part is a hull made anew, turned back, against the part's world: later by nothing, earlier
/// by as much as is promised.
TEST(MovingParts, HullsMeetTurnedPartsAsHullsTurnedBack) {
    const World empty, solid = test::cross_world();
    Rng rng(24);
    std::size_t hits = 0, grazes = 0;
    for (int k = 0; k < test::sample(4000); ++k) {
        const MovingPart part(solid, test::random_motion(rng, 1, 0));
        const Scene scene{empty, {&part, 1}};
        const TurnMatrix rotation = matrix_of(normalised(part.motion.rotation));
        const Vec3 at = test::random_vector(rng, 0, 3), path = test::random_vector(rng, 0, 3);
        const Vec3 there = rotation.back(at - part.motion.position), way = rotation.back(path - part.motion.path);
        const Vec3 half{0.3, k % 2 ? 0.2 : 0.01, 0.4};
        const Hull box = make_box(half).value();
        const Hull back =
            make_box(half, {rotation.back({1, 0, 0}), rotation.back({0, 1, 0}), rotation.back({0, 0, 1})}).value();
        std::vector<Overlap> found;
        if (overlap(solid, back, there, found) != Status::kMiss) continue;
        const PartHit got = cast(scene, box, at, path);
        const Hit wanted = cast(solid, back, there, way);
        if (!got) {
            EXPECT_FALSE(wanted.touched()) << k;
            continue;
        }
        ++hits;
        EXPECT_LE(got.fraction, wanted.fraction + 1e-12);
        if (!wanted.touched()) {
            ++grazes;
            continue;
        }
        const double early = (wanted.fraction - got.fraction) * -dot(way, wanted.normal);
        EXPECT_LE(early, kTurnedHullTouch + 1e-9) << k;
        if (length(got.normal - rotation * wanted.normal) > 1e-3) ++grazes;
    }
    EXPECT_GT(hits, std::size_t(test::sample(300)));
    EXPECT_LE(grazes, hits / 100);
}

TEST(MovingParts, OverlapsAndNearestAreThoseOfTheFrame) {
    const World empty, solid = test::cross_world();
    Rng rng(23);
    std::size_t overlaps = 0, ties = 0;
    for (int k = 0; k < test::sample(2000); ++k) {
        const MovingPart part(solid, test::random_motion(rng, k % 3, 3));
        const Scene scene{empty, {&part, 1}};
        const double fraction = rng.uniform(0, 1);
        const Pose pose = pose_at(part.motion, fraction);
        const TurnMatrix rotation = matrix_of(pose.rotation);
        const auto in = [&](const Vec3& p) { return rotation.back(p - pose.position); };
        const Vec3 at = test::random_vector(rng, 0, 2);
        const Hull box = make_box({0.3, 0.2, 0.4}).value();
        const Hull back =
            make_box({0.3, 0.2, 0.4}, {rotation.back({1, 0, 0}), rotation.back({0, 1, 0}), rotation.back({0, 0, 1})})
                .value();
        const Capsule capsule{at, at + Vec3{0, 0.3, 0.5}, 0.2};
        std::vector<Overlap> wanted;
        for (int shape = 0; shape < 3; ++shape) {
            std::vector<PartOverlap> got;
            const auto keep = [&](const PartOverlap& one) { return got.push_back(one), true; };
            const Status status = shape == 0   ? overlap_each(scene, Sphere{at, 0.3}, keep, fraction)
                                  : shape == 1 ? overlap_each(scene, capsule, keep, fraction)
                                               : overlap_each(scene, box, at, keep, fraction);
            const Status same = shape == 0   ? overlap(solid, Sphere{in(at), 0.3}, wanted)
                                : shape == 1 ? overlap(solid, Capsule{in(capsule.from), in(capsule.to), 0.2}, wanted)
                                             : overlap(solid, back, in(at), wanted);
            ASSERT_EQ(status, same);
            std::sort(got.begin(), got.end(),
                      [](const PartOverlap& a, const PartOverlap& b) { return a.face.id < b.face.id; });
            ASSERT_EQ(got.size(), wanted.size());
            for (std::size_t j = 0; j < got.size(); ++j) {
                ++overlaps;
                EXPECT_EQ(got[j].face, wanted[j].face);
                EXPECT_EQ(got[j].part, 0u);
                EXPECT_NEAR(got[j].depth, wanted[j].depth, 1e-9) << "shape " << shape;
                ties += length(got[j].direction - rotation * wanted[j].direction) > 1e-6;
                const NearFace on = closest(solid, in(got[j].point));
                EXPECT_LT(on.distance, 1e-9);
                EXPECT_EQ(got[j].surface_velocity, velocity_at(part.motion, fraction, got[j].point));
            }
        }
        const PartNear near = closest(scene, at, kEverywhere, fraction);
        const NearFace same = closest(solid, in(at));
        ASSERT_TRUE(near);
        EXPECT_NEAR(near.distance, same.distance, 1e-9);
        EXPECT_LT(length(near.point - (pose.position + rotation * same.point)), 1e-6);
    }
    EXPECT_GT(overlaps, std::size_t(test::sample(2000)));
    EXPECT_LE(ties, overlaps / 1000);
}

TEST(MovingParts, LevelAndPartsTogether) {
    const World ground = test::ground();
    RigidMotion falls;
    falls.position = {0, 0, 4};
    falls.path = {0, 0, -8};
    RigidMotion rises;
    rises.position = {0, 0, 2};
    const std::vector<MovingPart> parts{MovingPart(test::box_world({-1, -1, 0}, {1, 1, 1}), falls),
                                        MovingPart(test::box_world({-1, -1, 0}, {1, 1, 1}), rises)};
    const Scene scene{ground, parts};
    // The falling box reaches a ball that stands, before the ball is reached by anything else.
    const PartHit hit = cast(scene, Sphere{{0, 0, 1}, 0.5}, {});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.part, 0u);
    EXPECT_EQ(hit.fraction, 2.5 / 8);
    EXPECT_EQ(hit.point, (Vec3{0, 0, 1.5}));
    EXPECT_EQ(hit.surface_velocity, (Vec3{0, 0, -8}));
    // One that falls ahead of it meets the ground first; one beside the boxes nothing else.
    EXPECT_EQ(cast(scene, Sphere{{0, 0, 1}, 0.5}, {0, 0, -8}).part, kNoPart);
    EXPECT_EQ(cast(scene, Sphere{{0, 0, 1}, 0.5}, {0, 0, -8}).fraction, 0.5 / 8);
    // One that goes with a part never meets it.
    EXPECT_EQ(cast(scene, Sphere{{0, 0, 1.25}, 0.5}, {0, 0, -0.5}).part, 0u);
    CastOptions options;
    EXPECT_EQ(cast(Scene{ground, std::span(parts).subspan(1)}, Sphere{{0, 0, 1.25}, 0.5}, {}, options).status,
              Status::kMiss);
    // Equal fractions: the level, then the lower index.
    const PartHit tie = cast(scene, Ray{{0, 0, 1}, {0, 0, 4}});
    EXPECT_EQ(tie.part, 0u);
    EXPECT_EQ(tie.fraction, 3.0 / 12);
    const std::vector<MovingPart> twice{parts[1], parts[1]};
    EXPECT_EQ(cast(Scene{ground, twice}, Ray{{0, 0, 1}, {0, 0, 4}}).part, 0u);
    RigidMotion level_with_ground;
    const std::vector<MovingPart> flush{MovingPart(test::box_world({-1, -1, -1}, {1, 1, 0}), level_with_ground)};
    EXPECT_EQ(cast(Scene{ground, flush}, Ray{{0, 0, 1}, {0, 0, -2}}).part, kNoPart);
    // Masks of parts.
    std::vector<MovingPart> masked = parts;
    masked[0].mask = 2;
    options.mask = 1;
    EXPECT_FALSE(cast(Scene{ground, std::span(masked).first(1)}, Sphere{{0, 0, 1}, 0.5}, {}, options));
}

TEST(MovingParts, BadNumbersAreInvalid) {
    const World ground = test::ground();
    const Hull box = make_box({0.3, 0.2, 0.4}).value();
    const auto all_invalid = [&](const MovingPart& part, const Vec3& at, const Vec3& path, double radius) {
        const Scene scene{ground, {&part, 1}};
        const PartHit hit = cast(scene, Sphere{at, radius}, path);
        EXPECT_EQ(hit.status, Status::kInvalid);
        EXPECT_EQ(hit.fraction, 0);
        EXPECT_EQ(hit.part, kNoPart);
        EXPECT_EQ(cast(scene, Capsule{at, at + Vec3{0, 0, 1}, radius}, path).status, Status::kInvalid);
        EXPECT_EQ(cast_any(scene, Sphere{at, radius}, path), Status::kInvalid);
        if (radius < 0) return;
        EXPECT_EQ(cast(scene, box, at, path).status, Status::kInvalid);
    };
    const MovingPart good(test::leaf_world());
    const Vec3 at{0, 0, 3}, path{1, 0, 0};
    all_invalid(good, {NAN, 0, 0}, path, 1);
    all_invalid(good, at, {0, INFINITY, 0}, 1);
    all_invalid(good, at, path, -1);
    for (int k = 0; k < 6; ++k) {
        MovingPart bad = good;
        if (k == 0) bad.motion.position.y = NAN;
        if (k == 1) bad.motion.path.z = INFINITY;
        if (k == 2) bad.motion.turn.x = 1.001 * kMaxPartTurn;
        if (k == 3) bad.motion.rotation[2] = NAN;
        if (k == 4) bad.motion.turn.x = NAN;
        if (k == 5) bad.motion.position.x = 1e300;
        all_invalid(bad, at, path, 1);
        const Scene scene{ground, {&bad, 1}};
        const auto none = [](const PartOverlap&) { return true; };
        EXPECT_EQ(overlap_each(scene, Sphere{at, 1}, none), Status::kInvalid) << k;
        EXPECT_EQ(closest(scene, at).status, Status::kInvalid) << k;
    }
    MovingPart turning = good;
    turning.motion.turn = {0, 0, 1};
    all_invalid(turning, {2 * kMaxPartReach, 0, 3}, path, 1);
    all_invalid(turning, at, {0, 0, 2 * kMaxPartReach}, 1);
    const Scene scene{ground, {&good, 1}};
    EXPECT_EQ(cast(scene, Sphere{{-2 * kMaxPartReach, 0, 1}, 0}, {4 * kMaxPartReach, 0, 0}).part, 0u);
    EXPECT_EQ(cast(scene, Hull(), at, path).status, Status::kInvalid);
    const auto none = [](const PartOverlap&) { return true; };
    EXPECT_EQ(overlap_each(scene, Hull(), at, none), Status::kInvalid);
    for (const double fraction : {-0.1, 1.1, double(NAN)}) {
        EXPECT_EQ(overlap_each(scene, Sphere{at, 1}, none, fraction), Status::kInvalid);
        EXPECT_EQ(closest(scene, at, kEverywhere, fraction).status, Status::kInvalid);
    }
    const MovingPart nothing;
    EXPECT_FALSE(cast(Scene{World(), {&nothing, 1}}, Sphere{at, 1}, path));
}

}  // namespace
}  // namespace firma

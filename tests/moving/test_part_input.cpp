// SPDX-License-Identifier: MIT
// Whatever numbers motions, movers and times have, the answer is a number, or the question is refused.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iterator>

#include "firma/capsule.h"
#include "firma/hull.h"
#include "firma/part_path.h"
#include "tests/moving/part_worlds.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma::test {
namespace {

/// Mostly as usual.
class OddNumbers {
public:
    explicit OddNumbers(std::uint64_t seed) : rng(seed) {}

    double number(double usual) {
        static constexpr double kOdd[] = {0,     1,     -1,       1e-300,   5e-324, 50,    -300, -1e30,
                                          1e160, 1e300, 0x1p+200, 0x1p+199, 8,      7.999, 1e308};
        if (!rng.chance(0.08)) return usual;
        if (rng.chance(0.15)) return rng.chance(0.5) ? NAN : INFINITY;
        return kOdd[rng.below(std::uint32_t(std::size(kOdd)))];
    }
    Vec3 vector(const Vec3& usual) { return {number(usual.x), number(usual.y), number(usual.z)}; }
    RigidMotion motion() {
        RigidMotion made;
        made.position = vector(random_vector(rng, 0, 1));
        made.path = vector(random_vector(rng, 0, 2));
        if (rng.chance(0.5)) made.rotation = random_turn(rng.next());
        for (double& part : made.rotation) part = number(part);
        if (rng.chance(0.5)) made.turn = vector(random_vector(rng, 0, 6));
        return made;
    }
    scenes::Rng rng;
};

void judge(const Hit& hit, int k) {
    if (hit.status == Status::kInvalid) return;
    ASSERT_GE(hit.fraction, 0) << k;
    ASSERT_LE(hit.fraction, 1) << k;
    ASSERT_GE(hit.safe_fraction, 0) << k;
    ASSERT_LE(hit.safe_fraction, hit.fraction) << k;
    if (!hit.touched()) return;
    ASSERT_TRUE(is_finite(hit.point) && is_finite(hit.normal) && is_finite(hit.face_normal)) << k;
    ASSERT_NEAR(length(hit.normal), 1, 1e-6) << k;
}

TEST(PartInput, CastsAnswerWithNumbersOrRefuse) {
    OddNumbers odd(31);
    const World level = box_world({-8, -8, -3}, {8, 8, -2});
    const World solids[] = {cross_world(), leaf_world()};
    const Hull box = make_box({0.2, 0.3, 0.1}).value();
    std::size_t asked = 0, touched = 0;
    for (int k = 0; k < sample(10'000); ++k) {
        MovingPart part(solids[k % 2], odd.motion());
        const double from = odd.number(0), to = odd.number(1);
        const Scene scene{level, {&part, 1}, from, to};
        const Vec3 at = odd.vector(odd.rng.direction() * 2), path = odd.vector(odd.rng.direction() * 4);
        const double radius = odd.number(0.2);
        const PartHit hits[] = {cast(scene, Sphere{at, radius}, path),
                                cast(scene, Capsule{at, odd.vector(at + Vec3{0, 0, 1}), radius}, path),
                                cast(scene, box, at, path)};
        for (const PartHit& hit : hits) {
            judge(hit, k);
            if (testing::Test::HasFatalFailure()) return;
            ASSERT_TRUE(hit.part == kNoPart || hit.part == 0) << k;
            asked += hit.status != Status::kInvalid;
            touched += hit.touched();
        }
        const PartNear near = closest(scene, at, odd.number(4), odd.number(0.5));
        if (near.status == Status::kHit) {
            ASSERT_TRUE(is_finite(near.point) && is_finite(near.distance)) << k;
        }
        overlap_each(
            scene, Sphere{at, radius},
            [&](const PartOverlap& overlap) {
                EXPECT_TRUE(is_finite(overlap.depth) && is_finite(overlap.direction)) << k;
                return true;
            },
            odd.number(0.5));
    }
    EXPECT_GT(asked, std::size_t(sample(10'000)));
    EXPECT_GT(touched, std::size_t(sample(1'000)));
}

TEST(PartInput, PathsGiveMotionsThatCanBeUsedOrAreRefused) {
    OddNumbers odd(32);
    const World level = box_world({-8, -8, -3}, {8, 8, -2}), leaf = leaf_world();
    std::size_t used = 0;
    for (int k = 0; k < sample(5'000); ++k) {
        PartPath path;
        for (std::uint32_t stop = odd.rng.below(4); stop > 0; --stop)
            path.stops.push_back({.position = odd.vector(odd.rng.direction()),
                                  .angle = odd.number(odd.rng.uniform(-2, 2)),
                                  .wait = odd.number(0.5),
                                  .seconds = odd.number(1)});
        path.repeats = odd.rng.chance(0.5);
        path.spin = odd.number(odd.rng.chance(0.5) ? 0 : 2);
        path.swing.period = odd.number(odd.rng.chance(0.5) ? 0 : 2);
        path.swing.reach = odd.vector({0, 0, 1});
        path.swing.phase = odd.number(0);
        const double from = odd.number(odd.rng.uniform(0, 9)), to = odd.number(from + 1.0 / 60);
        MovingPart part(leaf, part_motion(path, from, to));
        const PartHit hit = cast(Scene{level, {&part, 1}}, Sphere{{0.5, -2, 1}, 0.2}, {0, 4, 0});
        judge(hit, k);
        if (testing::Test::HasFatalFailure()) return;
        used += hit.status != Status::kInvalid;
        if (is_finite(from)) {
            // Whoever steps from stop to stop comes on.
            ASSERT_FALSE(next_stop(path, from) <= from) << k;
        }
    }
    EXPECT_GT(used, std::size_t(sample(2'000)));
}

TEST(PartInput, MoversLongerThanTheWorldTakeNoHours) {
    const World level = box_world({-8, -8, -3}, {8, 8, -2});
    MovingPart part(cross_world());
    part.motion.turn = {0.5, 0.3, 6};
    part.motion.path = {0, 1, 0};
    const Scene scene{level, {&part, 1}};
    for (const double far : {1e4, 1e6, 1e8}) {
        const auto start = std::chrono::steady_clock::now();
        judge(cast(scene, Capsule{{far, 0, 3}, {-far, 1, 2.5}, 0.2}, {0, 0, -2}), 0);
        judge(cast(scene, Sphere{{0, far, 0}, far - 1.5}, {0, -1, 0}), 0);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        EXPECT_LT(took.count(), 20) << far;
    }
}

}  // namespace
}  // namespace firma::test

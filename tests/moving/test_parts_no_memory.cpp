// SPDX-License-Identifier: MIT
// Questions to a scene take no memory. A program of its own, as operator new is for the whole process.
#include "tests/failing_new.h"

#include <gtest/gtest.h>

#include "tests/moving/part_worlds.h"

namespace firma {
namespace {

TEST(PartsNoMemory, QuestionsTakeNone) {
    scenes::Rng rng(5);
    const World level = test::box_world({-4, -4, -2}, {4, 4, -1}), solid = test::cross_world();
    const Hull box = make_box({0.3, 0.2, 0.4}).value();
    bool all_met[4] = {};
    for (int k = 0; k < 60; ++k) {
        const std::vector<MovingPart> parts{MovingPart(solid, test::random_motion(rng, 0, 0)),
                                            MovingPart(solid, test::random_motion(rng, 1, 0)),
                                            MovingPart(solid, test::random_motion(rng, 2, 3))};
        const Scene scene{level, std::span(parts).subspan(std::size_t(k % 3), 1)};
        const Vec3 at = rng.direction() * 2, path = rng.direction() * 2;
        const auto count = [](const PartOverlap&) { return true; };
        const bool allocated = tests::runs_out(0, [&] {
            all_met[0] |= cast(scene, Sphere{at, 0.2}, path).part == 0;
            all_met[1] |= cast(scene, Capsule{at, at + Vec3{0, 0, 0.5}, 0.2}, path).part == 0;
            all_met[2] |= cast(scene, box, at, path).part == 0;
            overlap_each(scene, Sphere{at, 0.5}, count, 0.5);
            overlap_each(scene, Capsule{at, at + Vec3{0, 0, 0.5}, 0.5}, count, 0.5);
            overlap_each(scene, box, at, count, 0.5);
            all_met[3] |= closest(scene, at).part == 0;
        });
        EXPECT_FALSE(allocated) << k;
    }
    for (const bool met : all_met) EXPECT_TRUE(met);
}

}  // namespace
}  // namespace firma

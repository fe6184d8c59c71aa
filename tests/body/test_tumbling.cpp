// SPDX-License-Identifier: MIT
// Spin about the middle axis tumbles, at the times that the closed form tells; about the other two it stays: a box, and
// rubble of real blasts in the air of the levels that these left.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/body/free_spin_period.h"
#include "tests/body/level_floors.h"

namespace firma::test {
namespace {

constexpr int kSteps = 3000;

/// Seconds at which the spin about the middle axis changes its sign.
std::vector<double> tumbles(const World& world, Body body) {
    StepOptions options;
    options.gravity = {};
    options.sleep_after = INFINITY;
    Bodies bodies;
    const BodyId id = add_body(bodies, std::move(body));
    std::vector<double> times;
    double before = principal_spin(*bodies.find(id)).y;
    for (int k = 1; k <= kSteps; ++k) {
        step(bodies, world, kTick, options);
        const double now = principal_spin(*bodies.find(id)).y;
        if (now * before < 0) times.push_back((k - now / (now - before)) * kTick);
        before = now;
    }
    return times;
}

/// Spins mostly about one principal axis, a twentieth of it about each of the others.
Body spun(Body body, int axis) {
    Vec3 spin{0.25, 0.25, 0.25};
    spin[axis] = 5;
    body.spin = matrix_of(normalised(body.rotation)) * (matrix_of(body.shape.axes()) * spin);
    return body;
}

void judge_tumbling(const World& world, const Body& body) {
    const double expected = half_period(body.shape.moments(), principal_spin(spun(body, 1)));
    const std::vector<double> times = tumbles(world, spun(body, 1));
    ASSERT_GE(times.size(), 3u) << expected;
    // From the first to the last: the start is within a tumble.
    const double mean = (times.back() - times.front()) / double(times.size() - 1);
    EXPECT_NEAR(mean, expected, 0.01 * expected) << times.size();
    for (std::size_t k = 1; k < times.size(); ++k) EXPECT_NEAR(times[k] - times[k - 1], expected, 0.02 * expected) << k;
}

/// Where the other axes are far enough from the middle one for a spin of a twentieth to stay about its own.
bool stays(const Vec3& moments) {
    return moments.x > 1.1 * moments.y && moments.y > 1.1 * moments.z;
}

void judge_steady(const World& world, const Body& body) {
    for (const int axis : {0, 2}) {
        StepOptions options;
        options.gravity = {};
        options.sleep_after = INFINITY;
        Bodies bodies;
        const BodyId id = add_body(bodies, spun(body, axis));
        for (int k = 0; k < kSteps; ++k) {
            step(bodies, world, kTick, options);
            ASSERT_GT(principal_spin(*bodies.find(id))[axis], 4) << axis << ' ' << k;
        }
    }
}

TEST(Tumbling, OfABoxTakesAsLongAsTheClosedFormTells) {
    const World world = ground();
    const Body box = body_here(box_body({0.5, 0.3, 0.1}), {0, 0, 50});
    judge_tumbling(world, box);
    judge_steady(world, box);
}

class TumblingInLevels : public InBlastedLevels {};
INSTANTIATE_TEST_SUITE_P(, TumblingInLevels, testing::Values(0, 1, 2), name_of_blasted_level);

TEST_P(TumblingInLevels, OfRubbleTakesAsLongAsTheClosedFormTells) {
    const std::vector<FloorPlace> places = floor_places(level().world, 1, 1, 2.4, 1);
    ASSERT_EQ(places.size(), 1u);
    int judged = 0;
    for (const Chunk* chunk : chunks_of_size(level().chunks, 0.1, 0.9)) {
        if (judged == 4) break;
        const Result<Body> made = chunk_over(*chunk, 12, places[0].at + Vec3{0, 0, 1.2}, std::uint64_t(judged));
        if (!made || !stays(made.value().shape.moments())) continue;
        ++judged;
        SCOPED_TRACE(judged);
        judge_tumbling(level().world, made.value());
        judge_steady(level().world, made.value());
    }
    EXPECT_GE(judged, 2);  // not all levels have as many as four
}

}  // namespace
}  // namespace firma::test

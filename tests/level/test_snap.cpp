// SPDX-License-Identifier: MIT
// The snap: nearest multiple of 1/4096 m, halves to even, and the rim of the world.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "firma/grid.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr double kStep = 1 / kInputSteps;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The first coordinate in input steps, from a point whose others are 0.
std::optional<int> steps_of(double x) {
    const auto point = snap({x, 0, 0});
    if (!point) return std::nullopt;
    EXPECT_EQ(point->x % kSurfacePerInput, 0);
    return point->x / kSurfacePerInput;
}

TEST(Snap, KeepsWhatLiesOnTheGrid) {
    for (int steps : {0, 1, -1, 4096, -4097, 33554431, -33554432}) EXPECT_EQ(steps_of(steps * kStep), steps);
}

TEST(Snap, TakesHalvesToEven) {
    EXPECT_EQ(steps_of(0.5 * kStep), 0);
    EXPECT_EQ(steps_of(1.5 * kStep), 2);
    EXPECT_EQ(steps_of(2.5 * kStep), 2);
    EXPECT_EQ(steps_of(-0.5 * kStep), 0);
    EXPECT_EQ(steps_of(-1.5 * kStep), -2);
    EXPECT_EQ(steps_of(-2.5 * kStep), -2);
    EXPECT_EQ(steps_of(std::nextafter(0.5 * kStep, 1)), 1);
    EXPECT_EQ(steps_of(std::nextafter(0.5 * kStep, 0)), 0);
    EXPECT_EQ(steps_of(std::nextafter(-0.5 * kStep, -1)), -1);
}

TEST(Snap, JudgesTheRimAfterRounding) {
    EXPECT_EQ(steps_of(8192 - kStep), 33554431);
    EXPECT_EQ(steps_of(std::nextafter(8192 - 0.5 * kStep, 0)), 33554431);
    EXPECT_FALSE(steps_of(8192 - 0.5 * kStep));  // a half goes to even: 8192
    EXPECT_FALSE(steps_of(8192));
    EXPECT_EQ(steps_of(-8192), -33554432);
    EXPECT_EQ(steps_of(-8192 - 0.5 * kStep), -33554432);
    EXPECT_FALSE(steps_of(std::nextafter(-8192 - 0.5 * kStep, -9000)));
    EXPECT_EQ(snap({-8192, -8192, -8192})->z, std::numeric_limits<std::int32_t>::min());
}

TEST(Snap, RefusesWhatIsNoPlaceInTheWorld) {
    for (const double bad : {std::nan(""), kInfinity, -kInfinity, 1e300, -1e300, 1.7e308, 8193.0, -8193.0}) {
        EXPECT_FALSE(snap({bad, 0, 0}));
        EXPECT_FALSE(snap({0, bad, 0}));
        EXPECT_FALSE(snap({0, 0, bad}));
    }
    EXPECT_EQ(snap({5e-324, -5e-324, -0.0}), (GridPoint{0, 0, 0}));
}

TEST(Snap, AgreesWithTheProcessorsOwnRounding) {
    scenes::Rng rng(1);
    for (int k = 0; k < 200'000; ++k) {
        const double x = rng.chance(0.5) ? rng.uniform(-8191, 8191) : (double(rng.below(2000)) - 1000) * 0.25 * kStep;
        ASSERT_EQ(steps_of(x), int(std::nearbyint(x * kInputSteps))) << x;
    }
}

}  // namespace
}  // namespace firma

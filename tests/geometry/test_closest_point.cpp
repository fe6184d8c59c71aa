// SPDX-License-Identifier: MIT
// The nearest point of a polygon: hand-worked cases, and against sampling.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "firma/polygon.h"
#include "scenes/rng.h"

namespace firma {
namespace {

const std::vector<Vec3> kSquare{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

TEST(ClosestPoint, FaceEdgeAndVertex) {
    ClosestPoint c = closest_point({1, 1, 3}, kSquare);
    EXPECT_EQ(c.feature, Feature::kFace);
    EXPECT_EQ(c.point, (Vec3{1, 1, 0}));
    EXPECT_EQ(c.distance, 3);
    c = closest_point({1, 1, -3}, kSquare);
    EXPECT_EQ(c.distance, 3) << "from behind as well";
    c = closest_point({5, 1, 4}, kSquare);
    EXPECT_EQ(c.feature, Feature::kEdge);
    EXPECT_EQ(c.feature_index, 1u);
    EXPECT_EQ(c.point, (Vec3{2, 1, 0}));
    EXPECT_EQ(c.distance, 5);
    c = closest_point({-2, -1, 2}, kSquare);
    EXPECT_EQ(c.feature, Feature::kVertex);
    EXPECT_EQ(c.feature_index, 0u);
    EXPECT_EQ(c.distance, 3);
    c = closest_point({2, 2, 0}, kSquare);
    EXPECT_EQ(c.distance, 0);
}

TEST(ClosestPoint, NonsenseIsInfinitelyFar) {
    EXPECT_EQ(closest_point({0, 0, 0}, {}).distance, INFINITY);
    EXPECT_EQ(closest_point({0, 0, 0}, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}).distance, INFINITY);
    EXPECT_EQ(closest_point({0, 0, 0}, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}).distance, INFINITY);
    EXPECT_EQ(closest_point({0, 0, 0}, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1e300, 0}}).distance, INFINITY);
}

TEST(ClosestPoint, NoSampleIsNearer) {
    scenes::Rng rng(31);
    for (int k = 0; k < 2000; ++k) {
        const auto corner = [&] {
            const double x = std::floor(rng.uniform(-4096, 4096)), y = std::floor(rng.uniform(-4096, 4096)),
                         z = std::floor(rng.uniform(-4096, 4096));
            return Vec3{x, y, z} * (1 / 4096.0);
        };
        const std::vector<Vec3> triangle{corner(), corner(), corner()};
        if (check_polygon(triangle) != PolygonFault::kNone) continue;
        const Vec3 point{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
        const ClosestPoint c = closest_point(point, triangle);
        EXPECT_NEAR(length(point - c.point), c.distance, 1e-14);
        for (int s = 0; s < 50; ++s) {
            double a = rng.uniform(), b = rng.uniform();
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const Vec3 sample = triangle[0] + (triangle[1] - triangle[0]) * a + (triangle[2] - triangle[0]) * b;
            ASSERT_GE(length(point - sample), c.distance - 1e-14);
        }
    }
}

TEST(Overlap, CountsTouchAndRefusesNonsense) {
    EXPECT_TRUE(overlap({{1, 1, 3}, 3}, kSquare)) << "touching counts";
    EXPECT_FALSE(overlap({{1, 1, 3}, 2.999}, kSquare));
    EXPECT_TRUE(overlap({{5, 1, 4}, 5}, kSquare));
    EXPECT_FALSE(overlap({{1, 1, NAN}, 3}, kSquare));
    EXPECT_FALSE(overlap({{1, 1, 1}, -3}, kSquare));
    EXPECT_FALSE(overlap({{1, 1, 1}, NAN}, kSquare));
}

}  // namespace
}  // namespace firma

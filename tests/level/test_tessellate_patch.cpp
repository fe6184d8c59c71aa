// SPDX-License-Identifier: MIT
#include "level/tessellate_patch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/rng.h"

namespace firma {
namespace {

TEST(TessellatePatch, CurveIsTheSameFromBothEnds) {
    scenes::Rng rng(4);
    for (int round = 0; round < 1000; ++round) {
        BezierCurve curve;
        for (Vec3& p : curve) p = {rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)};
        const BezierCurve back = {curve[2], curve[1], curve[0]};
        const std::uint32_t n = 1 + rng.below(64);
        for (std::uint32_t k = 0; k <= n; ++k) ASSERT_EQ(point_on(curve, k, n), point_on(back, n - k, n));
    }
}

// z = x y, whose every point is known exactly.
TEST(TessellatePatch, PointsLieOnTheSurface) {
    Patch patch{5, 3, {}};
    for (const double y : {0.0, 2.0, 4.0}) {
        for (const double x : {0.0, 4.0, 8.0, 10.0, 12.0}) patch.control.push_back({x, y, x * y});
    }
    const PatchDivision division = {{4, 2}, {2}};
    EXPECT_EQ(division.columns(), 7u);
    EXPECT_EQ(division.rows(), 3u);
    EXPECT_EQ(division.cells(), 12u);
    const std::vector<Vec3> points = tessellate_patch(patch, division);
    ASSERT_EQ(points.size(), 21u);
    std::size_t k = 0;
    for (const double y : {0.0, 2.0, 4.0}) {
        for (const double x : {0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0}) EXPECT_EQ(points[k++], (Vec3{x, y, x * y}));
    }
}

TEST(TessellatePatch, CurvesBendTowardTheirMiddleControlPoint) {
    Patch patch{3, 3, {}};
    for (const double y : {0.0, 1.0, 2.0}) {
        for (const double x : {0.0, 1.0, 2.0}) patch.control.push_back({x, y, x == 1 ? 4.0 : 0.0});
    }
    const std::vector<Vec3> points = tessellate_patch(patch, {{2}, {1}});
    ASSERT_EQ(points.size(), 6u);
    EXPECT_EQ(points[1], (Vec3{1, 0, 2}));
    EXPECT_EQ(points[4], (Vec3{1, 2, 2}));
}

}  // namespace
}  // namespace firma

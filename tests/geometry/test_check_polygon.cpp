// SPDX-License-Identifier: MIT
// What may be cast against and what may not, to a grid step.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "firma/grid.h"
#include "firma/polygon.h"

namespace firma {
namespace {

constexpr double kStep = 1 / kSurfaceSteps;

using Corners = std::vector<Vec3>;

TEST(CheckPolygon, TakesConvexPlanarOnes) {
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), PolygonFault::kNone);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}), PolygonFault::kNone);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}}), PolygonFault::kNone)
        << "a corner along a side";
    EXPECT_EQ(check_polygon(Corners{{-8192, -8192, 0}, {8191, -8192, 0}, {8191, 8191, 0}, {-8192, 8191, 0}}),
              PolygonFault::kNone);
}

TEST(CheckPolygon, NamesWhatIsWrong) {
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}}), PolygonFault::kTooFewCorners);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {0, kStep / 2, 0}}), PolygonFault::kOffGrid);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {8192, 0, 0}, {0, 1, 0}}), PolygonFault::kOffGrid)
        << "outside the world";
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}), PolygonFault::kOffGrid);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {INFINITY, 0, 0}, {0, 1, 0}}), PolygonFault::kOffGrid);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), PolygonFault::kNoArea);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, kStep}, {0, 1, 0}}), PolygonFault::kNotPlanar);
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}}), PolygonFault::kNotConvex)
        << "reflex";
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}), PolygonFault::kNotConvex)
        << "a corner twice";
    EXPECT_EQ(check_polygon(Corners{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}), PolygonFault::kNotConvex)
        << "a side that turns back";
}

TEST(CheckPolygon, RefusesAPentagram) {
    Corners star;
    for (const int k : {0, 2, 4, 1, 3}) {
        const double angle = k * 2 * 3.14159265358979 / 5;
        star.push_back({std::floor(std::cos(angle) * kInputSteps) / kInputSteps,
                        std::floor(std::sin(angle) * kInputSteps) / kInputSteps, 0});
    }
    EXPECT_EQ(check_polygon(star), PolygonFault::kNotConvex) << "every turn goes left, but it winds twice";
}

}  // namespace
}  // namespace firma

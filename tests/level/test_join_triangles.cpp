// SPDX-License-Identifier: MIT
#include "level/join_triangles.h"

#include <gtest/gtest.h>

namespace firma {
namespace {

using Corners = std::vector<std::uint32_t>;

TEST(JoinTriangles, SquareAroundItsMiddle) {
    const std::vector<GridPoint> points = {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}, {32, 32, 0}};
    const Corners fan = {4, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0};
    const auto joined = join_triangles(fan, points);
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_EQ(joined[0], (Corners{0, 1, 2, 3}));
}

TEST(JoinTriangles, MiddleOffThePlaneStays) {
    const std::vector<GridPoint> points = {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}, {32, 32, 1}};
    const Corners fan = {4, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0};
    const auto joined = join_triangles(fan, points);
    ASSERT_EQ(joined.size(), 4u);
    EXPECT_EQ(joined[2], (Corners{4, 2, 3}));
}

// Corner 1 was moved inward by a step: the triangle that closed the gap faces backward now, but the outline is still
// right.
TEST(JoinTriangles, FoldedSliverGoesIntoTheOutline) {
    const std::vector<GridPoint> points = {{0, 0, 0}, {32, 1, 0}, {64, 0, 0}, {64, 64, 0}};
    const auto joined = join_triangles(Corners{0, 2, 3, 0, 1, 2}, points);
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_EQ(joined[0], (Corners{0, 1, 2, 3}));
}

TEST(JoinTriangles, CornerAlongASideStays) {
    const std::vector<GridPoint> points = {{0, 0, 0}, {32, 0, 0}, {64, 0, 0}, {64, 64, 0}};
    const auto joined = join_triangles(Corners{0, 2, 3, 0, 1, 2}, points);  // the second has no area
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_EQ(joined[0], (Corners{0, 1, 2, 3}));
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// From metres to the page, and lines cut off at its border.
#include <gtest/gtest.h>

#include "draw/view.h"

namespace firma::draw {
namespace {

View ten_metres() {
    View view;  // x to the right, y up, seen along -z
    view.region = {{0, 0, 0}, {10, 10, 10}};
    view.scale = 20;
    view.corner = {100, 300};
    return view;
}

TEST(View, PlacesPointsWithYUp) {
    const View view = ten_metres();
    EXPECT_EQ(view.place({0, 0, 5}).x, 100);
    EXPECT_EQ(view.place({0, 0, 5}).y, 300);
    EXPECT_EQ(view.place({10, 5, 5}).x, 300);
    EXPECT_EQ(view.place({10, 5, 5}).y, 200);
}

TEST(View, LinesInsideStayWhole) {
    const PageLine line = cut_to_view(ten_metres(), {1, 1, 99}, {9, 1, -99});
    EXPECT_TRUE(line.visible);
    EXPECT_FALSE(line.from_cut);
    EXPECT_FALSE(line.to_cut);
    EXPECT_EQ(line.from.x, 120);
    EXPECT_EQ(line.to.x, 280);
}

TEST(View, LinesAreCutAtTheBorder) {
    const PageLine line = cut_to_view(ten_metres(), {5, 5, 0}, {1e12, 5, 0});
    EXPECT_TRUE(line.visible);
    EXPECT_FALSE(line.from_cut);
    EXPECT_TRUE(line.to_cut);
    EXPECT_NEAR(line.to.x, 300, 1e-2);
    EXPECT_TRUE(cut_to_view(ten_metres(), {-1, 5, 0}, {11, 5, 0}).from_cut);
}

TEST(View, LinesOutsideAreNotSeen) {
    EXPECT_FALSE(cut_to_view(ten_metres(), {-1, 0, 0}, {-1, 10, 0}).visible);
    EXPECT_FALSE(cut_to_view(ten_metres(), {-5, 1, 0}, {5, 21, 0}).visible);
    EXPECT_FALSE(cut_to_view(ten_metres(), {1e300, 0, 0}, {1e300, 1, 0}).visible);
}

TEST(View, APointIsALine) {
    EXPECT_TRUE(cut_to_view(ten_metres(), {5, 5, 0}, {5, 5, 0}).visible);
    EXPECT_FALSE(cut_to_view(ten_metres(), {5, 11, 0}, {5, 11, 0}).visible);
}

}  // namespace
}  // namespace firma::draw

// SPDX-License-Identifier: MIT
#include "level/find_islands.h"

#include <gtest/gtest.h>

namespace firma {
namespace {

using Corners = std::vector<std::uint32_t>;

TEST(FindIslands, FanIsOneOutline) {
    const auto islands = find_islands(Corners{0, 1, 2, 0, 2, 3, 0, 3, 4});
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_EQ(islands[0].outline, (Corners{0, 1, 2, 3, 4}));
    EXPECT_TRUE(islands[0].inner.empty());
    EXPECT_EQ(islands[0].triangles.size(), 9u);
}

TEST(FindIslands, KeepsTheOrderOfFirstTriangles) {
    const auto islands = find_islands(Corners{10, 11, 12, 0, 1, 2, 10, 12, 13});
    ASSERT_EQ(islands.size(), 2u);
    EXPECT_EQ(islands[0].outline, (Corners{10, 11, 12, 13}));
    EXPECT_EQ(islands[1].outline, (Corners{0, 1, 2}));
}

TEST(FindIslands, NamesCornersInside) {
    const auto islands = find_islands(Corners{9, 0, 1, 9, 1, 2, 9, 2, 3, 9, 3, 0});
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_EQ(islands[0].outline, (Corners{0, 1, 2, 3}));
    EXPECT_EQ(islands[0].inner, (Corners{9}));
}

TEST(FindIslands, LeavesOutTrianglesThatNameACornerTwice) {
    const auto islands = find_islands(Corners{0, 0, 1, 0, 1, 2, 2, 3, 2, 4, 5, 5});
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_EQ(islands[0].outline, (Corners{0, 1, 2}));
    EXPECT_TRUE(find_islands(Corners{0, 0, 0}).empty());
    EXPECT_TRUE(find_islands(Corners{}).empty());
}

TEST(FindIslands, TouchingAtACornerIsNotHangingTogether) {
    const auto islands = find_islands(Corners{0, 1, 2, 2, 3, 4});
    ASSERT_EQ(islands.size(), 2u);
    EXPECT_FALSE(islands[0].outline.empty());
    EXPECT_FALSE(islands[1].outline.empty());
}

// A square ring: four corners outside, four inside.
TEST(FindIslands, RingHasNoOneOutline) {
    Corners ring;
    for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t next = (k + 1) % 4;
        for (const std::uint32_t corner : {k, next, next + 4, k, next + 4, k + 4}) ring.push_back(corner);
    }
    const auto islands = find_islands(ring);
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_TRUE(islands[0].outline.empty());
    EXPECT_EQ(islands[0].triangles, ring);
}

// Five triangles around, the last pinched back to a corner of the first.
TEST(FindIslands, RimThatTouchesItselfIsNoOutline) {
    const auto islands = find_islands(Corners{0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 1});
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_TRUE(islands[0].outline.empty());
}

TEST(FindIslands, ClosedSurfaceHasNoRim) {
    const auto islands = find_islands(Corners{0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2});
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_TRUE(islands[0].outline.empty());
}

TEST(FindIslands, SheetsAreLeftAlone) {
    const Corners twice = {0, 1, 2, 0, 1, 2, 5, 6, 7};
    const auto islands = find_islands(twice);
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_TRUE(islands[0].outline.empty());
    EXPECT_EQ(islands[0].triangles, twice);
}

// A torus with one triangle missing has one rim, as a disc has, but more triangles than a disc of its corners.
TEST(FindIslands, HandleIsNoDisc) {
    Corners torus;
    const auto at = [](std::uint32_t i, std::uint32_t j) { return i % 3 + 3 * (j % 3); };
    for (std::uint32_t i = 0; i < 3; ++i) {
        for (std::uint32_t j = 0; j < 3; ++j) {
            for (const std::uint32_t corner :
                 {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
                torus.push_back(corner);
            }
        }
    }
    torus.resize(torus.size() - 3);
    const auto islands = find_islands(torus);
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_TRUE(islands[0].outline.empty());
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Projected loops: area, what they enclose, whether they are convex; ears of rings with and without permission for
// more.
#include "geometry/flat_loop.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/clip_ears.h"
#include "geometry/convex_loop.h"

namespace firma {
namespace {

using Loop = std::vector<FlatPoint>;

const Loop kFlatSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Loop kNotched{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}};
const Loop kBowTie{{0, 0}, {4, 4}, {4, 0}, {0, 4}};

bool convex(const Loop& loop) {
    return convex_loop<Int128>(loop.size(), [&](std::size_t k) { return loop[k]; });
}

/// @return whether all went; the corners of the triangles
bool clip(const Loop& loop, EarClipper::Takes takes, std::vector<std::uint32_t>& corners) {
    std::vector<GridPoint> points;
    for (const FlatPoint& p : loop) points.push_back({std::int32_t(p.u), std::int32_t(p.v), 0});
    std::vector<RingCorner> ring(loop.size());
    link_ring(loop, 0, std::uint32_t(loop.size()), ring);
    Triangles triangles;
    const bool done = EarClipper().clip(points, ring, takes, triangles);
    corners = triangles.corners;
    return done;
}

TEST(FlatLoop, AreaHasTheSignOfTheWayAround) {
    EXPECT_TRUE(twice_area(kFlatSquare) == 32);
    EXPECT_TRUE(twice_area(Loop(kFlatSquare.rbegin(), kFlatSquare.rend())) == -32);
    EXPECT_TRUE(twice_area(kNotched) == 24);
    EXPECT_TRUE(twice_area(kBowTie) == 0);
}

TEST(FlatLoop, EnclosesByCrossings) {
    EXPECT_TRUE(encloses(kNotched, {1, 2}));
    EXPECT_TRUE(encloses(kNotched, {3, 2})) << "at the height of a corner";
    EXPECT_FALSE(encloses(kNotched, {2, 3}));
    EXPECT_FALSE(encloses(kNotched, {5, 2}));
    EXPECT_FALSE(encloses(kNotched, {-1, 2}));
}

TEST(FlatLoop, Convex) {
    EXPECT_TRUE(convex(kFlatSquare));
    EXPECT_TRUE(convex({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})) << "a corner along a side";
    EXPECT_FALSE(convex(Loop(kFlatSquare.rbegin(), kFlatSquare.rend())));
    EXPECT_FALSE(convex(kNotched));
    EXPECT_FALSE(convex(kBowTie));
    EXPECT_FALSE(convex({{0, 0}, {4, 0}, {2, 0}})) << "no area";
    EXPECT_FALSE(convex({{0, 0}, {4, 0}, {4, 0}, {4, 4}})) << "a corner twice";
    EXPECT_FALSE(convex({{0, 0}, {4, 0}, {4, 4}, {0, 0}, {4, 0}, {4, 4}})) << "twice around";
    EXPECT_FALSE(convex({{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}})) << "a fold";
}

TEST(ClipEars, TakesWhatItMay) {
    std::vector<std::uint32_t> corners;
    EXPECT_TRUE(clip(kNotched, EarClipper::Takes::kEars, corners));
    EXPECT_EQ(corners.size(), 9u);
    EXPECT_FALSE(clip(kBowTie, EarClipper::Takes::kEars, corners));
    EXPECT_TRUE(clip(kBowTie, EarClipper::Takes::kAnything, corners));
    EXPECT_EQ(corners.size(), 6u);
    EXPECT_TRUE(clip({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}, EarClipper::Takes::kAnything, corners)) << "a spike";
    EXPECT_EQ((std::vector<std::uint32_t>{corners[0], corners[1], corners[2]}), (std::vector<std::uint32_t>{1, 2, 3}))
        << "goes first";
}

}  // namespace
}  // namespace firma

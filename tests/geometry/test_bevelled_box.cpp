// SPDX-License-Identifier: MIT
// A bevelled box never says that something is clear of points that it touches, also once both have moved; and is
// tighter than a box.
#include "geometry/bevelled_box.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

using scenes::Rng;

GridPoint random_point(Rng& rng, std::int32_t size) {
    GridPoint p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::int32_t(rng.below(std::uint32_t(size)));
    return p;
}

GridBox box_around(const std::vector<GridPoint>& points) {
    GridBox box;
    for (const GridPoint& p : points) box.add(p);
    return box;
}

BevelledBox bevel(const std::vector<GridPoint>& points) {
    return {box_around(points), points.size(), [&](std::size_t k) { return points[k]; }};
}

bool clear(const BevelledBox& box, const std::vector<GridPoint>& points, std::int32_t steps) {
    return box.clear_of(box_around(points), points.size(), [&](std::size_t k) { return points[k]; }, steps);
}

std::vector<GridPoint> ball(Rng& rng, const GridPoint& middle, double radius) {
    std::vector<GridPoint> points;
    for (int k = 0; k < 200; ++k) {
        const Vec3 d = rng.direction() * radius;
        points.push_back({middle.x + std::int32_t(d.x), middle.y + std::int32_t(d.y), middle.z + std::int32_t(d.z)});
    }
    return points;
}

TEST(BevelledBox, WhatTouchesAPointIsNeverClear) {
    Rng rng(1);
    int near = 0;
    for (int round = 0; round < 20'000; ++round) {
        const std::int32_t size = 1 << (4 + rng.below(24));
        std::vector<GridPoint> points, polygon;
        for (std::uint32_t k = 1 + rng.below(20); k-- > 0;) points.push_back(random_point(rng, size));
        const BevelledBox box = bevel(points);
        // A polygon of which a corner lies less than `steps` beside one of the points, and others anywhere.
        const std::int32_t steps = std::int32_t(rng.below(std::uint32_t(size)));
        GridPoint touching = points[rng.below(std::uint32_t(points.size()))];
        for (int axis = 0; axis < 3; ++axis)
            touching[axis] += std::int32_t(rng.below(2 * std::uint32_t(steps) + 1)) - steps;
        polygon.push_back(touching);
        for (std::uint32_t k = 2 + rng.below(4); k-- > 0;) polygon.push_back(random_point(rng, size));
        EXPECT_FALSE(clear(box, polygon, steps));
        near += !clear(box, polygon, 0);
    }
    EXPECT_GT(near, 10'000);
}

TEST(BevelledBox, ABoxIsAsClearAsItsCorners) {
    Rng rng(3);
    const std::vector<GridPoint> points = ball(rng, {0, 0, 0}, 400'000);
    const BevelledBox round = bevel(points);
    const GridBox around = box_around(points);
    GridPoint middle;
    for (int axis = 0; axis < 3; ++axis) middle[axis] = (around.low[axis] + around.high[axis]) >> 1;
    int told = 0;
    for (int tries = 0; tries < 20'000; ++tries) {
        const GridPoint low = random_point(rng, 800'000), size = random_point(rng, 200'000);
        std::vector<GridPoint> corners(8);
        for (int k = 0; k < 8; ++k)
            for (int axis = 0; axis < 3; ++axis)
                corners[std::size_t(k)][axis] = low[axis] - 400'000 + (k >> axis & 1) * size[axis];
        const GridBox box = box_around(corners);
        bool one_octant = true;
        for (int axis = 0; axis < 3; ++axis)
            one_octant &= (box.low[axis] < middle[axis]) == (box.high[axis] < middle[axis]);
        EXPECT_EQ(round.clear_of(box, 100), one_octant && clear(round, corners, 100));
        told += round.clear_of(box, 100);
    }
    EXPECT_GT(told, 1'000);
    EXPECT_LT(told, 19'000);
}

TEST(BevelledBox, WhatLiesInAClearBoxIsClearByItself) {
    // Or else what a cut gathers would depend on the boxes that an index has around faces.
    Rng rng(4);
    const BevelledBox round = bevel(ball(rng, {0, 0, 0}, 400'000));
    int told = 0;
    for (int tries = 0; tries < 50'000; ++tries) {
        const GridPoint low = random_point(rng, 800'000), size = random_point(rng, 600'000);
        std::vector<GridPoint> inside(3);
        GridBox box;
        for (GridPoint& point : inside)
            for (int axis = 0; axis < 3; ++axis)
                point[axis] = low[axis] - 400'000 + std::int32_t(rng.below(std::uint32_t(std::abs(size[axis])) + 1));
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = low[axis] - 400'000;
            box.high[axis] = low[axis] - 400'000 + std::abs(size[axis]);
        }
        if (!round.clear_of(box, 100)) continue;
        EXPECT_TRUE(clear(round, inside, 100));
        ++told;
    }
    EXPECT_GT(told, 1'000);
}

TEST(BevelledBox, TellsMoreThanABox) {
    Rng rng(2);
    const std::vector<GridPoint> points = ball(rng, {0, 0, 0}, 400'000);
    const BevelledBox box = bevel(points);
    int told = 0, beyond = 0;
    for (int round = 0; round < 20'000; ++round) {
        GridPoint at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = std::int32_t(rng.uniform(-4e5, 4e5));
        const Vec3 p{double(at.x), double(at.y), double(at.z)};
        beyond += dot(p, p) > 4e5 * 4e5;
        told += clear(box, {at}, 0);
    }
    EXPECT_GT(told, beyond / 2);
    EXPECT_LT(told, 10'000);
}

TEST(BevelledBox, HasTwentyPlanesThatTouch) {
    Rng rng(3);
    const std::vector<GridPoint> points = ball(rng, {1'000'000, -2'000'000, 3'000'000}, 300'000);
    std::set<std::tuple<int, int, int>> seen;
    bevel(points).for_each_plane(0, [&](const GridPoint& outward, std::int64_t bound) {
        std::int64_t most = INT64_MIN;
        for (const GridPoint& p : points) {
            std::int64_t at = 0;
            for (int axis = 0; axis < 3; ++axis) at += std::int64_t(outward[axis]) * p[axis];
            most = std::max(most, at);
        }
        EXPECT_EQ(most, bound);
        seen.insert({outward.x, outward.y, outward.z});
    });
    EXPECT_EQ(seen.size(), 20u);
    for (const auto& [x, y, z] : seen) EXPECT_GE(std::abs(x) + std::abs(y) + std::abs(z), 2);
}

TEST(BevelledBox, HoldsAtTheRimOfTheWorld) {
    const std::vector<GridPoint> corners{{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MIN, INT32_MIN, INT32_MIN + 10}};
    const BevelledBox box = bevel(corners);
    EXPECT_FALSE(clear(box, corners, INT32_MAX));
    EXPECT_TRUE(clear(box, {{INT32_MAX, INT32_MAX, INT32_MAX}}, 1000));
}

}  // namespace
}  // namespace firma

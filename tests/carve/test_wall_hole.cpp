// SPDX-License-Identifier: MIT
// Where a wall's plane meets a cutter, and prisms over the hole: one where its outline is sound on the input grid, else
// one over each part.
#include "carve/wall_hole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "carve/place_solid.h"
#include "carve/wall_section.h"
#include "scenes/rng.h"
#include "tests/carve/winding.h"

namespace firma {
namespace {

constexpr double kStep = 1 / kInputSteps;

WallOutlines outlines_of(const std::vector<std::vector<Vec3>>& loops) {
    WallOutlines outlines;
    for (const std::vector<Vec3>& loop : loops) {
        outlines.points.insert(outlines.points.end(), loop.begin(), loop.end());
        outlines.ends.push_back(std::uint32_t(outlines.points.size()));
    }
    return outlines;
}

/// In the plane z = 0.
std::vector<Vec3> square(double x, double y, double size) {
    return {{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}};
}

std::vector<Vec3> reversed(std::vector<Vec3> loop) {
    return {loop.rbegin(), loop.rend()};
}

bool hold(const std::vector<Cutter>& columns, const Vec3& p) {
    for (const Cutter& column : columns)
        if (test::winding(column, {}, p) > 0.5) return true;
    return false;
}

/// By the outlines themselves: sums of the angles under which a point in the plane sees them.
bool lies_within(const WallOutlines& outlines, const Vec3& p, const Vec3& normal) {
    double sum = 0;
    std::uint32_t first = 0;
    for (const std::uint32_t end : outlines.ends) {
        for (std::uint32_t k = first; k < end; ++k) {
            const Vec3 a = outlines.points[k] - p, b = outlines.points[k + 1 < end ? k + 1 : first] - p;
            sum += std::atan2(dot(normal, cross(a, b)), dot(a, b));
        }
        first = end;
    }
    return sum > 3;
}

double distance_to(const WallOutlines& outlines, const Vec3& p) {
    double nearest = INFINITY;
    std::uint32_t first = 0;
    for (const std::uint32_t end : outlines.ends) {
        for (std::uint32_t k = first; k < end; ++k) {
            const Vec3 a = outlines.points[k], way = outlines.points[k + 1 < end ? k + 1 : first] - a;
            const double square = dot(way, way);
            const double share = square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
            nearest = std::min(nearest, length(p - (a + way * share)));
        }
        first = end;
    }
    return nearest;
}

CutterSolid placed(const Cutter& cutter, const Pose& pose) {
    CutterSolid solid;
    EXPECT_FALSE(place_any_cutter(cutter, pose, solid));
    return solid;
}

const WallPlane kFloor = wall_plane({0, 0, 1}, {0, 0, 0});

TEST(WallHole, OneColumnStraightOut) {
    const std::vector<Cutter> columns =
        WallHole(outlines_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}}), kFloor).raise(2);
    ASSERT_EQ(columns.size(), 1u);
    EXPECT_EQ(columns[0].triangles().size(), 12u) << "the corner in the middle of a side is left out";
    for (const double x : {kStep / 2, 0.5, 1.0, 1.5, 2 - kStep / 2}) {
        EXPECT_TRUE(hold(columns, {x, 0.5, 1})) << x;
        EXPECT_TRUE(hold(columns, {x, 0.5, -4 * kStep})) << x;
        EXPECT_FALSE(hold(columns, {x, 0.5, 2 + kStep})) << x;
        EXPECT_FALSE(hold(columns, {x, 0.5, -9 * kStep})) << x;
    }
    EXPECT_FALSE(hold(columns, {-kStep / 2, 0.5, 1}));
    EXPECT_FALSE(hold(columns, {2 + kStep / 2, 0.5, 1}));
}

TEST(WallHole, OutlinesWithinOutlines) {
    const std::vector<Cutter> columns =
        WallHole(outlines_of({square(0, 0, 8), reversed(square(1, 1, 6)), square(2, 2, 4), reversed(square(3, 3, 1)),
                              square(10, 0, 1)}),
                 kFloor)
            .raise(2);
    ASSERT_EQ(columns.size(), 1u);
    for (const double at : {0.5, 2.5, 5.5, 7.5}) EXPECT_TRUE(hold(columns, {at, at, 1})) << at;
    for (const double at : {-0.5, 1.5, 3.5, 6.5, 8.5}) EXPECT_FALSE(hold(columns, {at, at, 1})) << at;
    EXPECT_TRUE(hold(columns, {10.5, 0.5, 1}));
}

TEST(WallHole, AnOutlineThatMeetsItselfGivesColumnsThatOverlap) {
    // Corner on corner, from both sides; and a spike that, snapped, reaches through the side it ends at.
    for (const double way : {-1.0, 1.0}) {
        const WallPlane wall = wall_plane({0, 0, way}, {0, 0, 0});
        std::vector<std::vector<Vec3>> squares = {square(0, 0, 1), square(1, 1, 1)};
        if (way < 0)
            for (std::vector<Vec3>& loop : squares) loop = reversed(loop);
        const std::vector<Cutter> touching = WallHole(outlines_of(squares), wall).raise(2);
        ASSERT_EQ(touching.size(), 2u);
        for (const Vec3& p : {Vec3{0.5, 0.5, way}, {1.5, 1.5, way}, {1, 1, way}, {-kStep / 2, 0.5, way}, {1, 0.5, way}})
            EXPECT_TRUE(hold(touching, p)) << p.x;
        EXPECT_FALSE(hold(touching, {1 + 2 * kStep, 1 - 2 * kStep, way}));
    }
    const WallHole spike(
        outlines_of({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1.01, 2, 0}, {1, -2 * kStep, 0}, {0.99, 2, 0}, {0, 2, 0}}}),
        kFloor);
    const std::vector<Cutter> crossed = spike.raise(2);
    EXPECT_GT(crossed.size(), 1u);
    for (const Vec3& p : {Vec3{0.3, 0.3, 1}, {1.7, 0.3, 1}, {0.3, 1.7, 1}, {1.7, 1.7, 1}})
        EXPECT_TRUE(hold(crossed, p)) << p.x;
    EXPECT_FALSE(hold(crossed, {1, 1.5, 1}));
}

TEST(WallHole, WhatIsNoMoreThanALineIsNone) {
    EXPECT_TRUE(WallHole().empty());
    EXPECT_TRUE(WallHole(outlines_of({square(0, 0, kStep / 8)}), kFloor).empty());
    EXPECT_TRUE(WallHole(outlines_of({{{0, 0, 0}, {1, 0, 0}, {1, kStep / 8, 0}}}), kFloor).empty());
}

TEST(WallHole, TellsWhatItTakesOf) {
    const WallHole hole(outlines_of({{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}}}), kFloor);
    EXPECT_TRUE(hole.takes_of(square(0.5, 0.5, 1)));
    EXPECT_TRUE(hole.takes_of(square(-9, -9, 20))) << "the hole lies within it";
    EXPECT_TRUE(hole.takes_of(reversed(square(0.25, 0.25, 0.5)))) << "it lies within the hole";
    EXPECT_FALSE(hole.takes_of(square(2, 2, 1))) << "beside it, in its box";
    EXPECT_FALSE(hole.takes_of(square(-1, 0, 1))) << "side by side";
    EXPECT_FALSE(hole.takes_of(square(1 - kStep / 8, 1 - kStep / 8, 2)));

    const auto over = [&](std::vector<Vec3> polygon, double height) {
        for (Vec3& p : polygon) p.z += height;
        return hole.may_be_over(polygon);
    };
    EXPECT_TRUE(over(square(0.5, 0.5, 1), 0));
    EXPECT_TRUE(over(square(0.5, 0.5, 1), 5));
    EXPECT_FALSE(over(square(0.5, 0.5, 1), -1)) << "behind the wall";
    EXPECT_FALSE(over(square(-1.01, 0, 1), 1));
    EXPECT_TRUE(over(square(-1, 0, 1), 1)) << "side by side";
    EXPECT_TRUE(hole.may_be_over(std::vector<Vec3>{{0.5, 0.5, 1}, {0.6, 0.5, 1}, {0.6, 0.5, 2}})) << "from its side";
    EXPECT_FALSE(hole.may_be_over(std::vector<Vec3>{{5, 0.5, 1}, {6, 0.5, 1}, {6, 0.5, 2}}));
}

TEST(WallSection, ABoxLeavesExactlyItsOutline) {
    const CutterSolid box = placed(make_crater(CutterShape::kBox, 1), {{1, 2, 3}, {0, 0, 0, 1}, 0.5});
    for (const double way : {-1.0, 1.0})
        for (const double level : {2.5, 2.7, 3.0, 3.5}) {
            const WallPlane wall = wall_plane({0, 0, way}, {0, 0, std::int32_t(std::lround(level * kSurfaceSteps))});
            const std::vector<Cutter> columns = WallHole(section_of(box, wall), wall).raise(1);
            // Its bottom and its top take of walls that look the same way.
            const bool flush = (level == 2.5 && way > 0) || (level == 3.5 && way < 0);
            ASSERT_EQ(columns.size(), flush ? 0u : 1u) << level;
            if (flush) continue;
            EXPECT_EQ(columns[0].vertices().size(), 8u);
            for (const Vec3& p : columns[0].vertices()) {
                EXPECT_EQ(std::fabs(p.x - 1), 0.5);
                EXPECT_EQ(std::fabs(p.y - 2), 0.5);
            }
        }
    const WallPlane beside = wall_plane({0, 0, 1}, {0, 0, std::int32_t(3.5 * kSurfaceSteps) + 1});
    EXPECT_TRUE(section_of(box, beside).ends.empty());
}

/// Points of the plane lie in the section where they lie in the cutter; and in a column over it, but for its rim.
TEST(WallSection, AgreesWithTheCutter) {
    scenes::Rng rng(5);
    std::size_t within = 0, outside = 0, columns_made = 0;
    for (int round = 0; round < 60; ++round) {
        const CutterShape shape = CutterShape(rng.below(5));
        const Cutter cutter = make_crater(shape, std::uint32_t(rng.next()));
        Pose pose{{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)}, {0, 0, 0, 1}, rng.uniform(0.3, 2)};
        if (round % 3 != 0)
            pose.rotation = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1)};
        const CutterSolid solid = placed(cutter, pose);
        Vec3 normal{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
        if (round % 2 == 0) {
            const int axis = int(rng.below(3));
            const double way = rng.below(2) ? 1 : -1;
            normal = {};
            normal[axis] = way;
        }
        normal = normal * (1 / length(normal));
        GridPoint at;
        for (int axis = 0; axis < 3; ++axis)
            at[axis] = std::int32_t((pose.position[axis] + pose.scale * rng.uniform(-0.6, 0.6)) * kSurfaceSteps);
        const WallPlane wall = wall_plane(normal, at);
        const WallOutlines section = section_of(solid, wall);
        const std::vector<Cutter> columns = WallHole(section, wall).raise(2);
        const test::PlacedWinding winding(cutter, pose);
        columns_made += columns.size();
        const Vec3 side = [&] {
            const Vec3 way = cross(normal, std::fabs(normal.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
            return way * (1 / length(way));
        }();
        const Vec3 up = cross(normal, side);
        for (int k = 0; k < 60; ++k) {
            const Vec3 p = to_metres(at) + side * (pose.scale * rng.uniform(-1.5, 1.5)) +
                           up * (pose.scale * rng.uniform(-1.5, 1.5)) - normal * (4 / kSurfaceSteps);
            if (distance_to(section, p) < 4 * kStep) continue;
            const bool in = winding.holds(p);
            (in ? within : outside) += 1;
            EXPECT_EQ(lies_within(section, p, normal), in) << round << " " << k;
            EXPECT_EQ(hold(columns, p + normal), in) << round << " " << k;
        }
    }
    EXPECT_GT(within, 500u);
    EXPECT_GT(outside, 500u);
    EXPECT_GT(columns_made, 40u);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// What has come loose becomes ground again where it rests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "carve/mend_mesh.h"
#include "firma/brush_world.h"
#include "firma/chunk.h"
#include "geometry/grid_orient.h"
#include "scenes/rng.h"
#include "tests/brush/depot_level.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

/// What is left of a cube of 2 m after so many craters into it.
Solid boulder(int craters, std::uint64_t seed) {
    scenes::Rng rng(seed);
    Solid solid = make_solid(test::box_level({-1, -1, -1}, {1, 1, 1})).value();
    for (int k = 0; k < craters; ++k) {
        const Pose pose{rng.direction() * 1.7, random_turn(rng.next()), rng.uniform(0.5, 0.9)};
        const SolidResult cut = subtract(solid, make_crater(CutterShape::kRocky, rng.next()), pose);
        if (cut.done()) solid = cut.solid;
    }
    return solid;
}

TEST(RestingSolid, IsExactByQuarterTurns) {
    const Solid solid = boulder(6, 1);
    const double half = std::sqrt(0.5);
    const Pose pose{{100.25, -3, 7}, {half, 0, 0, half}, 1};
    const RestingSolid resting = resting_solid(solid, pose).value();
    EXPECT_EQ(resting.volume_change, 0);
    EXPECT_EQ(resting.mended, 0);
    const SolidResult placed = unite(Solid(), resting.cutter, resting.pose);
    ASSERT_TRUE(placed.done());
    EXPECT_NEAR(measure_solid(placed.solid).volume, measure_solid(solid).volume, 1e-12);
    EXPECT_EQ(measure_solid(placed.solid).faces, measure_solid(solid).faces);
}

TEST(RestingSolid, SaysByHowMuchItsVolumeChanged) {
    const Solid solid = boulder(4, 2);
    const Pose pose{{3, 4, 5}, random_turn(3), 1};
    const RestingSolid resting = resting_solid(solid, pose).value();
    const SolidResult placed = unite(Solid(), resting.cutter, resting.pose);
    ASSERT_TRUE(placed.done());
    EXPECT_NE(resting.volume_change, 0);
    EXPECT_LT(std::fabs(resting.volume_change), 0.005);
    EXPECT_NEAR(-placed.report.volume, measure_solid(solid).volume + resting.volume_change, 1e-12);
    const RestingSolid half = resting_solid(solid, {{3, 4, 5}, random_turn(3), 0.5}).value();
    EXPECT_LT(std::fabs(half.volume_change), 0.005) << "beside what the scale makes of it";
}

TEST(RestingSolid, RefusesWhatItCannotPlace) {
    const Solid solid = boulder(2, 3);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(resting_solid(Solid(), {}));
    EXPECT_FALSE(resting_solid(make_solid(test::box_level({0, 0, 0}, {1, 1, 1}, true)).value(), {}));
    EXPECT_FALSE(resting_solid(solid, {{nan, 0, 0}, random_turn(1), 1}));
    EXPECT_FALSE(resting_solid(solid, {{0, 0, 0}, {0, 0, 0, 0}, 1}));
    EXPECT_EQ(resting_solid(solid, {{8192, 0, 0}, random_turn(1), 1}, "rock").error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(resting_solid(solid, {{0, 0, 0}, random_turn(1), 1e-6}, "rock").error().code, ErrorCode::kInvalid)
        << "nothing is left of it on the grid";
}

/// Craggy ones at any turn: nearly all, and where triangles were mended the volume hardly tells.
TEST(RestingSolid, MendsWhatSnappingFolds) {
    int mended = 0, refused = 0, tried = 0;
    for (std::uint64_t seed = 0; seed < std::uint64_t(test::sample(10)); ++seed) {
        const Solid solid = boulder(20, 100 + seed);
        for (std::uint64_t k = 0; k < 4; ++k, ++tried) {
            const Pose pose{{double(k), 2.5, -7}, random_turn(10 * seed + k), 1};
            const Result<RestingSolid> resting = resting_solid(solid, pose);
            refused += !resting;
            if (!resting) continue;
            mended += resting.value().mended > 0;
            EXPECT_LT(std::fabs(resting.value().volume_change), 0.005);
            const SolidResult placed = unite(Solid(), resting.value().cutter, resting.value().pose);
            ASSERT_TRUE(placed.done());
            EXPECT_FALSE(check_solid(placed.solid));
        }
    }
    EXPECT_GT(mended, test::sample(5));
    EXPECT_LE(refused, tried / 20);
}

/// The depot's bridge with its rails: long edges with many corners in a row.
TEST(RestingSolid, TheDepotsBridge) {
    World world = with_anchors(make_world(test::depot_level()).value());
    CarveOptions options;
    options.chunks = ChunkOptions{};
    const Cutter rocky = make_crater(CutterShape::kRocky, 3);
    world = carve(world, rocky, test::pose_at(14, 2, 3.75, 2.2), options).world;
    const CarveResult shot = carve(world, rocky, test::pose_at(14, 12, 3.75, 2.2), options);
    ASSERT_FALSE(shot.chunks.empty());
    const Solid& bridge = std::max_element(shot.chunks.begin(), shot.chunks.end(), [](const Chunk& a, const Chunk& b) {
                              return a.mass.volume < b.mass.volume;
                          })->solid;
    ASSERT_GT(bridge.face_count(), 300u);
    int refused = 0;
    const int turns = int(test::sample(10));
    for (int k = 0; k < 2 * turns; ++k) {
        const double half = 0.3 * (k + 1);
        Pose pose{{14, 6.5, 1.25}, random_turn(std::uint64_t(k)), 1};
        if (k < turns) pose.rotation = {0, 0, std::sin(half), std::cos(half)};
        const Result<RestingSolid> resting = resting_solid(bridge, pose);
        refused += !resting;
        if (!resting) continue;
        EXPECT_LT(std::fabs(resting.value().volume_change), 0.005);
        const SolidResult placed = unite(Solid(), resting.value().cutter, resting.value().pose);
        ASSERT_TRUE(placed.done());
        EXPECT_FALSE(check_solid(placed.solid));
    }
    EXPECT_LE(refused, turns / 4) << "of " << 2 * turns;
}

TEST(RestingSolid, BecomesGround) {
    World world = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    const double air = -measure_solid(world).volume;
    double sum = 0;
    for (std::uint64_t k = 0; k < 5; ++k) {
        const Solid solid = boulder(8, 50 + k);
        const Pose pose{{4.0 + 2.5 * double(k), 6, 0.75}, random_turn(k), 1};
        const RestingSolid resting = resting_solid(solid, pose).value();
        const CarveResult result = fill(world, resting.cutter, resting.pose);
        ASSERT_TRUE(result.done()) << result.error.reason;
        test::expect_sound_world(result.world);
        EXPECT_EQ(locate(result.world.solid(), pose.position), Where::kSolid);
        sum -= result.report.volume;
        world = result.world;
    }
    EXPECT_NEAR(-measure_solid(world).volume, air - sum, 1e-9);
    // And it is carved like any ground, with nothing loose below it.
    CarveOptions options;
    options.chunks = ChunkOptions{};
    const CarveResult cut =
        carve(with_anchors(world), make_crater(CutterShape::kRocky, 1), test::pose_at(6.5, 6, 1, 0.5), options);
    ASSERT_TRUE(cut.done());
    test::expect_sound_world(cut.world);
}

/// A tetrahedron with a sliver: one corner of it came to lie beyond the opposite edge.
TEST(MendMesh, TurnsAnEdgeAndMergesCorners) {
    const std::vector<InputPoint> points{{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, {0, 0, 1000}, {500, 0, 0}};
    // The side from 0 to 1 is divided at 4 in one of its two triangles: the other is joined to that by a flat one.
    std::vector<CutterTriangle> triangles{{0, 2, 4}, {4, 2, 1}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    EXPECT_EQ(mend_mesh(points, triangles), 1);
    EXPECT_EQ(triangles.size(), 6u);
    for (const auto& [a, b, c] : triangles) EXPECT_FALSE(on_one_line(points[a], points[b], points[c]));
    // Nothing to mend.
    EXPECT_EQ(mend_mesh(points, triangles), 0);
    EXPECT_EQ(triangles.size(), 6u);
    // Triangles of no extent go without being mended; so do pairs that look at each other.
    triangles.push_back({0, 0, 1});
    triangles.push_back({0, 1, 2});
    triangles.push_back({2, 1, 0});
    EXPECT_EQ(mend_mesh(points, triangles), 0);
    EXPECT_EQ(triangles.size(), 6u);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Cutters of very many triangles, some of which always touch a wall exactly: cut, or refused, in bounded work.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "base/random.h"
#include "carve/check_shells.h"
#include "carve/cutter_solid.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

using namespace test;

/// A room of 8 m in rock, its walls along the axes and on the grid.
World plain_room(const CarveRules& rules = {}) {
    const Level level = read_obj(
                            "v -4 -4 -4\nv 4 -4 -4\nv 4 4 -4\nv -4 4 -4\nv -4 -4 4\nv 4 -4 4\nv 4 4 4\nv -4 4 4\n"
                            "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n",
                            "room")
                            .value();
    return make_world(level, {{}, {}, rules}).value();
}

/// Six grids of n x n squares on the faces of the cube from -1 to 1, closed: 12 n^2 triangles.
TriangleMesh gridded_cube(int n) {
    TriangleMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    const auto vertex = [&](const std::array<int, 3>& p) {
        const auto [it, fresh] = numbers.insert({p, std::uint32_t(mesh.vertices.size())});
        if (fresh) mesh.vertices.push_back(Vec3{double(p[0]), double(p[1]), double(p[2])} * (1.0 / n));
        return it->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {-n, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> p{};
                        p[axis] = side;
                        p[(axis + 1) % 3] = 2 * (i + di) - n;
                        p[(axis + 2) % 3] = 2 * (j + dj) - n;
                        return vertex(p);
                    };
                    std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    if (side < 0) std::swap(b, d);
                    mesh.triangles.push_back({a, b, c});
                    mesh.triangles.push_back({a, c, d});
                }
    return mesh;
}

/// The same, blown up to a ball of radius 1.
TriangleMesh ball(int n) {
    TriangleMesh mesh = gridded_cube(n);
    for (Vec3& v : mesh.vertices) v = v * (1 / length(v));
    return mesh;
}

/// Two flat cones, base to base, of 2 * spokes triangles that are as long as the whole; the rim is a square at z = 0.
TriangleMesh two_cones(int spokes) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0.25}, {0, 0, -0.25}};
    const Vec3 corners[] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
    for (int k = 0; k < spokes; ++k) {
        const double along = 4.0 * k / spokes;
        const int side = int(along);
        mesh.vertices.push_back(corners[side] + (corners[side + 1] - corners[side]) * (along - side));
        const auto a = std::uint32_t(2 + k), b = std::uint32_t(2 + (k + 1) % spokes);
        mesh.triangles.push_back({0, a, b});
        mesh.triangles.push_back({1, b, a});
    }
    return mesh;
}

constexpr double kPi = 3.14159265358979;

TEST(LargeCutters, ABallOfAHundredThousandTrianglesGoesThroughAWall) {
    const World world = plain_room();
    const Cutter cutter = ball(92).cutter().value();
    ASSERT_GT(cutter.triangles().size(), 100'000u);
    const CarveResult result = carve(world, cutter, pose_at(4, 0.125, -0.25, 1.5));
    ASSERT_TRUE(result.done()) << result.error.text();
    EXPECT_GE(result.report.retries, 1);
    EXPECT_LE(result.report.retries, 8);
    EXPECT_NEAR(result.report.volume, 2.0 / 3 * kPi * 1.5 * 1.5 * 1.5, 0.01);
    expect_sound_world(result.world);
}

TEST(LargeCutters, ABallOfAMillionTrianglesGoesThroughAWall) {
    const World world = plain_room();
    const Cutter cutter = ball(288).cutter().value();
    ASSERT_GT(cutter.triangles().size(), 990'000u);
    const CarveResult result = carve(world, cutter, pose_at(4, 0.125, -0.25, 3));
    ASSERT_TRUE(result.done()) << result.error.text();
    EXPECT_NEAR(result.report.volume, 2.0 / 3 * kPi * 27, 0.01);
    EXPECT_FALSE(check_world(result.world));
}

TEST(LargeCutters, TheSamePlaceCanBeCutAgain) {
    const Cutter cutter = ball(20).cutter().value();
    const CarveResult first = carve(plain_room(), cutter, pose_at(4, 0, 0, 1.5));
    ASSERT_TRUE(first.done()) << first.error.text();
    // Nearly all of the surface touches.
    const CarveResult second = carve(first.world, cutter, pose_at(4, 0, 0, 1.5));
    ASSERT_TRUE(second.done()) << second.error.text();
    EXPECT_GT(second.report.volume, 0);
    EXPECT_LT(second.report.volume, 0.05);
    expect_sound_world(second.world);
    // What was moved outward then leaves nothing to take.
    const CarveResult third = carve(second.world, cutter, pose_at(4, 0, 0, 1.5));
    EXPECT_NE(third.status, CarveStatus::kRefused) << third.error.text();
}

TEST(LargeCutters, InSlicesAsInOneGo) {
    const World world = plain_room();
    for (const TriangleMesh& mesh : {ball(20), ring_mesh(64, 40)})
        for (const CarveKind kind : {CarveKind::kCarve, CarveKind::kFill}) {
            const Cutter cutter = mesh.cutter().value();
            CarveJob job(world, cutter, pose_at(4, 0, 0, 0.75), {}, kind);
            while (!job.run(0)) {
            }
            const CarveResult sliced = job.result();
            const CarveResult whole =
                (kind == CarveKind::kCarve ? carve : fill)(world, cutter, pose_at(4, 0, 0, 0.75), {});
            ASSERT_TRUE(whole.done()) << whole.error.text();
            EXPECT_GE(whole.report.retries, 1);
            EXPECT_EQ(sliced.report.retries, whole.report.retries);
            EXPECT_EQ(hash_world(sliced.world), hash_world(whole.world));
            expect_sound_world(whole.world);
        }
}

TEST(LargeCutters, TheSameBitsOnEveryMachine) {
    const CarveResult first = carve(plain_room(), ball(20).cutter().value(), pose_at(4, 0, 0, 0.75));
    ASSERT_TRUE(first.done()) << first.error.text();
    const CarveResult second = carve(first.world, ring_mesh(64, 40).cutter().value(), pose_at(4, 0, 0.5, 0.25));
    ASSERT_TRUE(second.done()) << second.error.text();
    EXPECT_GE(second.report.retries, 1);
    EXPECT_EQ(hash_world(second.world), 0x3CB3019921B173BAull);
}

TEST(LargeCutters, ARingThatIsNoStarGoesThroughAWall) {
    const World world = plain_room();
    const CarveResult result = carve(world, ring_mesh(320, 160).cutter().value(), pose_at(4, 0, 0, 0.75));
    ASSERT_TRUE(result.done()) << result.error.text();
    EXPECT_GE(result.report.retries, 1);
    EXPECT_NEAR(result.report.volume, kPi * kPi * 3 * 0.75 * 0.75 * 0.75, 0.1);  // half of 2 pi^2 R r^2
    expect_sound_world(result.world);
}

TEST(LargeCutters, OneFlushWithAWallOpensIt) {
    // All vertices of one of its faces, some thousand, touch.
    const World world = plain_room();
    const Cutter cutter = gridded_cube(92).cutter().value();
    const CarveResult result = carve(world, cutter, pose_at(5.5, 0, 0, 1.5));
    ASSERT_TRUE(result.done()) << result.error.text();
    EXPECT_NEAR(result.report.volume, 27, 0.1);
    expect_sound_world(result.world);
}

TEST(LargeCutters, LongTrianglesThatAllTouchTakeBoundedWork) {
    const World world = plain_room();
    const Cutter cutter = two_cones(50'000).cutter().value();
    const CarveResult result = carve(world, cutter, pose_at(0, 0, 4, 3.5));

    if (result.done())
        expect_sound_world(result.world);
    else
        EXPECT_EQ(result.status, CarveStatus::kRefused);
    EXPECT_LE(result.report.retries, 20) << "as many moves as the budget of pairs has room for";
}

TEST(LargeCutters, AllTriesShareOneBudget) {
    const Cutter cutter = ball(20).cutter().value();
    CarveRules rules;
    rules.max_pairs = cutter.triangles().size() - 1;  // one move counts each triangle
    const World hasty = plain_room(rules);
    const CarveResult result = carve(hasty, cutter, pose_at(4, 0, 0, 1.5));
    EXPECT_EQ(result.status, CarveStatus::kRefused);
    EXPECT_EQ(result.error.code, ErrorCode::kTooLarge);
    EXPECT_EQ(result.report.retries, 1);
    EXPECT_NE(result.error.text().find("more than 4799 pairs"), std::string::npos) << result.error.text();
    EXPECT_NE(result.error.text().find("in 1 move out of"), std::string::npos) << result.error.text();
    EXPECT_EQ(&result.world.data(), &hasty.data());
    // Where nothing touches, it is enough.
    EXPECT_TRUE(carve(hasty, cutter, pose_at(4.00071, 0.00013, 0.00057, 0.2)).done());
}

/// Some vertices, in rising order.
std::vector<std::uint32_t> some_of(std::size_t count, std::uint32_t every, Random& random) {
    std::vector<std::uint32_t> some;
    for (std::uint32_t v = 0; v < count; ++v)
        if (random.next() % every == 0) some.push_back(v);
    return some;
}

TEST(LargeCutters, MovedVerticesGoOutwardAndTheRestStays) {
    const PlacedCutter placed = place_cutter(ball(8).cutter().value(), pose_at(1, 2, 3)).value();
    Random random(7);
    PlacedCutter before = placed;
    for (int tries = 1; tries <= 64; tries += 3) {
        const auto vertices = some_of(placed.vertices.size(), 9, random);
        const PlacedCutter moved = move_vertices(placed, before, vertices, tries).value();
        std::size_t next = 0;
        for (std::uint32_t v = 0; v < placed.vertices.size(); ++v) {
            if (next == vertices.size() || vertices[next] != v) {
                EXPECT_EQ(moved.vertices[v], before.vertices[v]);
                continue;
            }
            ++next;
            for (int axis = 0; axis < 3; ++axis) {
                const int by = moved.vertices[v][axis] - placed.vertices[v][axis];
                EXPECT_LE(std::abs(by), std::min(1 + tries / 2, int(kFarthestMove)));
                const double out = placed.vertices[v][axis] / double(kInputSteps) - (axis + 1);
                if (std::fabs(out) > 0.5) {
                    EXPECT_GE(out > 0 ? by : -by, 1);
                }
            }
        }
        before = moved;
    }
}

bool same(const GridBox& a, const GridBox& b) {
    return a.low == b.low && a.high == b.high;
}

void expect_same_solid(const CutterSolid& mended, const CutterSolid& anew) {
    EXPECT_TRUE(same(mended.box, anew.box));
    for (std::size_t t = 0; t < anew.boxes.size(); ++t) {
        EXPECT_TRUE(same(mended.boxes[t], anew.boxes[t]));
        EXPECT_EQ(mended.planes[t]->plane, anew.planes[t]->plane);
    }
    for (std::size_t e = 0; e < anew.edges.size(); ++e)
        for (int k = 0; k < 2; ++k) EXPECT_EQ(mended.edges[e].plane[k]->plane, anew.edges[e].plane[k]->plane);
    for (std::size_t v = 0; v < anew.points.size(); ++v)
        EXPECT_EQ(mended.points[v].rounded(), anew.points[v].rounded());
}

/// Judging only what moved comes to the same as judging the whole, and so does mending the solid only there.
TEST(LargeCutters, JudgedAroundWhatMovedAsAWhole) {
    Random random(11);
    TriangleMesh shells = ring_mesh(24, 12);
    TriangleMesh hollow = box_mesh({2.95, -0.05, -0.05}, {3.05, 0.05, 0.05});
    hollow.turn_over();
    shells.add(hollow);
    const PlacedCutter placed = place_cutter(shells.cutter().value(), pose_at(1, 2, 3, 0.0625)).value();
    ASSERT_FALSE(check_cutter(placed));
    int sound = 0, unsound = 0;
    for (int round = 0; round < 200; ++round) {
        CutterSolid solid, anew;
        make_cutter_solid(placed, solid);
        const auto vertices = some_of(placed.vertices.size(), round % 2 ? 20 : 100, random);
        PlacedCutter moved = placed;
        const std::int64_t reach = 1 + std::int64_t(random.next() % (round % 4 < 2 ? 400 : 60));
        for (const std::uint32_t v : vertices)
            for (int axis = 0; axis < 3; ++axis) {
                const std::uint64_t draw = random.next() % std::uint64_t(2 * reach + 1);
                moved.vertices[v][axis] += std::int32_t(std::int64_t(draw) - reach);
            }
        bool flat = false;
        for (const auto& [a, b, c] : moved.triangles)
            flat |= !plane_through(moved.vertices[a], moved.vertices[b], moved.vertices[c]).valid();
        if (flat) continue;
        const auto triangles = update_cutter_solid(moved, vertices, solid);
        const bool fault = check_cutter(moved).has_value();
        EXPECT_EQ(check_moved_cutter(moved, triangles, solid.tree).has_value(), fault) << round;
        (fault ? unsound : sound)++;
        make_cutter_solid(moved, anew);
        expect_same_solid(solid, anew);
    }
    EXPECT_GT(sound, 40);
    EXPECT_GT(unsound, 40);
}

}  // namespace
}  // namespace firma

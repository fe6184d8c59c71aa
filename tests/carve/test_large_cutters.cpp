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
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

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
    // All of the surface touches, and nothing is left to take.
    const CarveResult second = carve(first.world, cutter, pose_at(4, 0, 0, 1.5));
    EXPECT_EQ(second.status, CarveStatus::kNothing) << second.error.text();
    // Filled and carved again, it is the same.
    const CarveResult filled = fill(first.world, cutter, pose_at(4, 0, 0, 1.5), {});
    ASSERT_TRUE(filled.done()) << filled.error.text();
    expect_sound_world(filled.world);
    const CarveResult again = carve(filled.world, cutter, pose_at(4, 0, 0, 1.5), {});
    ASSERT_TRUE(again.done()) << again.error.text();
    expect_sound_world(again.world);
    EXPECT_TRUE(same_solid(again.world, first.world));
    EXPECT_EQ(hash_solid(again.world), hash_solid(first.world));
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
            EXPECT_EQ(hash_world(sliced.world), hash_world(whole.world));
            expect_sound_world(whole.world);
        }
}

TEST(LargeCutters, TheSameBitsOnEveryMachine) {
    const CarveResult first = carve(plain_room(), ball(20).cutter().value(), pose_at(4, 0, 0, 0.75));
    ASSERT_TRUE(first.done()) << first.error.text();
    const CarveResult second = carve(first.world, ring_mesh(64, 40).cutter().value(), pose_at(4, 0, 0.5, 0.25));
    ASSERT_TRUE(second.done()) << second.error.text();
    EXPECT_EQ(hash_world(second.world), 1382553526145316922ull);
}

TEST(LargeCutters, ARingThatIsNoStarGoesThroughAWall) {
    const World world = plain_room();
    const CarveResult result = carve(world, ring_mesh(320, 160).cutter().value(), pose_at(4, 0, 0, 0.75));
    ASSERT_TRUE(result.done()) << result.error.text();
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
}

TEST(LargeCutters, ThePairsOfAnEditAreLimited) {
    const Cutter cutter = ball(20).cutter().value();
    CarveRules rules;
    rules.max_pairs = 100;
    const World hasty = plain_room(rules);
    const CarveResult result = carve(hasty, cutter, pose_at(4, 0, 0, 1.5));
    EXPECT_EQ(result.status, CarveStatus::kRefused);
    EXPECT_EQ(result.error.code, ErrorCode::kTooLarge);
    EXPECT_NE(result.error.text().find("more than 100 pairs"), std::string::npos) << result.error.text();
    EXPECT_EQ(&result.world.data(), &hasty.data());
}

/// Whose size is not that of the work: the limits leave room for a few faces alone.
TEST(LargeCutters, TheWholeLevelTwice) {
    CarveRules rules;
    rules.max_new_faces = 200;
    rules.max_pairs = 20'000;
    const Level level = read_level(FIRMA_ROOT "/levels/first.obj").value();
    for (const auto& [first, second] : {std::pair{3000.0, 3010.0}, {4000.0, 4010.0}, {4000.0, 4000.0}}) {
        World world = make_world(level, {{}, {}, rules}).value();
        const Cutter box = make_crater(CutterShape::kBox, 1);
        const CarveResult once = carve(world, box, pose_at(35, 29, 0, first));
        ASSERT_TRUE(once.done()) << once.error.text();
        EXPECT_LE(once.report.faces_added, 100u);
        const CarveResult twice = carve(once.world, box, pose_at(35, 29, 0, second));
        if (first == second) {
            EXPECT_EQ(twice.status, CarveStatus::kNothing) << twice.error.text();
            continue;
        }
        ASSERT_TRUE(twice.done()) << twice.error.text();
        EXPECT_LE(twice.report.faces_added + twice.report.faces_removed, 200u);
        expect_sound_world(twice.world);
    }
}

/// A prism over a zigzag: two caps of `teeth` triangles and more, each cap in one plane.
TriangleMesh saw(int teeth) {
    TriangleMesh mesh;
    const auto count = std::uint32_t(2 * teeth);
    for (const double z : {-1.0, 1.0})
        for (std::uint32_t k = 0; k < count; ++k) {
            const double x = -3 + 6.0 * (k / 2) / teeth;
            mesh.vertices.push_back(k % 2 == 0 ? Vec3{x, -0.5, z} : Vec3{x + 1.5 / teeth, 0.5, z});
        }
    const std::uint32_t last = count - 2;
    for (std::uint32_t k = 0; k < last; ++k) {
        const std::uint32_t a = k, b = k % 2 == 0 ? k + 2 : k + 1, c = k % 2 == 0 ? k + 1 : k + 2;
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({a + count, b + count, c + count});
    }
    const auto side = [&](std::uint32_t a, std::uint32_t b) {
        mesh.triangles.push_back({a, b, b + count});
        mesh.triangles.push_back({a, b + count, a + count});
    };
    for (std::uint32_t k = 0; k < last; k += 2) side(k, k + 2);
    for (std::uint32_t k = 1; k + 2 < count; k += 2) side(k + 2, k);
    side(1, 0);
    side(last, last + 1);
    return mesh;
}

/// So many corners as one face may not have: the cap stays several.
TEST(LargeCutters, CapsOfManyCorners) {
    for (const int teeth : {3, sample(12'000)}) {
        const Cutter cutter = saw(teeth).cutter().value();
        const SolidResult made = subtract(make_solid(box_level({-4, -4, -4}, {4, 4, 4})).value(), cutter, Pose());
        ASSERT_TRUE(made.done()) << made.error.text();
        EXPECT_FALSE(check_solid(made.solid));
        EXPECT_GT(made.report.volume, 7.9);
    }
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Placing: turned, scaled, moved and snapped as told; refused with the reason; moved a little, by its own hash.
#include "carve/place_cutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "base/random.h"
#include "carve/cutter_data.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

using test::box_mesh;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 metres(const InputPoint& p) {
    return to_metres(to_surface(p));
}

void expect_refused(const Result<PlacedCutter>& placed, ErrorCode code, const std::string& words) {
    ASSERT_FALSE(placed.ok()) << words;
    EXPECT_EQ(int(placed.error().code), int(code)) << placed.error().text();
    EXPECT_NE(placed.error().text().find(words), std::string::npos) << placed.error().text();
}

TEST(PlaceCutter, PutsABoxWhereItIsTold) {
    const Cutter box = make_crater(CutterShape::kBox, 0);
    const PlacedCutter placed = place_cutter(box, {.position = {10, 20, -30}, .scale = 2}).value();
    ASSERT_EQ(placed.vertices.size(), 8u);
    for (std::size_t k = 0; k < 8; ++k) {
        const Vec3 expected = box.vertices()[k] * 2 + Vec3{10, 20, -30};
        EXPECT_EQ(metres(placed.vertices[k]), expected);
    }
    EXPECT_EQ(placed.name, "box");
    EXPECT_EQ(placed.topology.get(), &box.data()->topology);
}

TEST(PlaceCutter, TurnsTheRightWayRound) {
    const Cutter box = box_mesh({1, 2, 4}, {2, 3, 5}).cutter().value();
    // A quarter turn around z takes x to y; any length of the quaternion will do.
    for (const double size : {1.0, 1e-310, 1e300, -3.0}) {
        const PlacedCutter placed = place_cutter(box, {.rotation = {0, 0, size, size}}).value();
        for (std::size_t k = 0; k < 8; ++k) {
            const Vec3 v = box.vertices()[k];
            EXPECT_EQ(metres(placed.vertices[k]), (Vec3{-v.y, v.x, v.z})) << size;
        }
    }
}

TEST(PlaceCutter, KeepsTheShape) {
    scenes::Rng rng(2);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Cutter rock = make_crater(CutterShape::kRocky, seed);
        Pose pose{.rotation = random_turn(seed), .scale = rng.uniform(0.1, 40)};
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(-8000, 8000);
        const PlacedCutter placed = place_cutter(rock, pose).value();
        double volume = 0, expected = 0;
        for (const auto& [a, b, c] : placed.triangles) {
            const auto at = [&](std::uint32_t v) { return metres(placed.vertices[v]) - pose.position; };
            volume += dot(at(a), cross(at(b), at(c)));
            expected += dot(rock.vertices()[a], cross(rock.vertices()[b], rock.vertices()[c]));
        }
        EXPECT_NEAR(std::cbrt(volume / expected), pose.scale, 1 / kInputSteps);
        for (std::size_t k = 0; k < placed.vertices.size(); ++k) {
            const double radius = length(metres(placed.vertices[k]) - pose.position);
            EXPECT_NEAR(radius, pose.scale * length(rock.vertices()[k]), 0.9 / kInputSteps);
        }
    }
}

TEST(PlaceCutter, HoldsItsPromisesForEveryShapeAndSize) {
    for (const CutterShape shape :
         {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill, CutterShape::kWedge, CutterShape::kBox})
        for (const double radius : {0.05, 0.3, 1.6, 50.0})
            for (std::uint64_t seed = 0; seed < 20; ++seed) {
                const Pose pose{.position = {1.1, 2.2, 3.3}, .rotation = random_turn(seed), .scale = radius};
                const auto placed = place_cutter(make_crater(shape, seed), pose);
                EXPECT_TRUE(placed.ok()) << placed.error().text();
            }
}

TEST(PlaceCutter, RefusesPosesThatMakeNoSense) {
    const Cutter rock = make_crater(CutterShape::kRocky, 1);
    for (const double scale : {0.0, -1.0, kInfinity, -kInfinity, double(NAN)})
        expect_refused(place_cutter(rock, {.scale = scale}), ErrorCode::kInvalid, "rocky: the scale");
    for (const Quaternion& q : {Quaternion{0, 0, 0, 0}, {0, 0, NAN, 1}, {kInfinity, 0, 0, 1}})
        expect_refused(place_cutter(rock, {.rotation = q}), ErrorCode::kInvalid, "rocky: the rotation");
    for (const double bad : {kInfinity, -kInfinity, double(NAN)})
        expect_refused(place_cutter(rock, {.position = {0, bad, 0}}), ErrorCode::kOutOfRange, "position");
    expect_refused(place_cutter(Cutter(), {}), ErrorCode::kInvalid, "empty cutter");
}

TEST(PlaceCutter, RefusesWhatLeavesTheWorld) {
    const Cutter box = make_crater(CutterShape::kBox, 0);
    // Vertex 1 is the first with x = 1.
    expect_refused(place_cutter(box, {.position = {8191, 0, 0}}), ErrorCode::kOutOfRange,
                   "box: vertex 1: lies outside");
    EXPECT_TRUE(place_cutter(box, {.position = {8191 - 1 / kInputSteps, 0, 0}}).ok());
    EXPECT_TRUE(place_cutter(box, {.position = {-8191, -8191, -8191}}).ok());
    expect_refused(place_cutter(box, {.position = {0, 0, -8191.5}}), ErrorCode::kOutOfRange, "vertex 0");
    for (const double scale : {1e4, 1e300, 1.7e308})
        expect_refused(place_cutter(box, {.scale = scale}), ErrorCode::kOutOfRange, "vertex 0: lies outside");
    const Cutter huge = box_mesh({-1e60, -1e60, -1e60}, {1e60, 1e60, 1e60}).cutter().value();
    expect_refused(place_cutter(huge, {.scale = 1e300}), ErrorCode::kOutOfRange, "outside");
    EXPECT_TRUE(place_cutter(huge, {.scale = 1e-60}).ok());
}

TEST(PlaceCutter, RefusesWhatCollapsesOnTheGrid) {
    expect_refused(place_cutter(make_crater(CutterShape::kRocky, 1), {.scale = 1e-4}), ErrorCode::kInvalid,
                   "has no area on the grid of 1/4096 m");
    expect_refused(place_cutter(make_crater(CutterShape::kBox, 1), {.scale = 5e-324}), ErrorCode::kInvalid,
                   "box: triangle 0: has no area");
    // A flat box: its sides vanish, its top and bottom do not.
    const Cutter flat = box_mesh({0, 0, 0}, {1, 1, 1e-4}).cutter().value();
    expect_refused(place_cutter(flat, {}), ErrorCode::kInvalid, "mesh: triangle ");
    // A tetrahedron whose top snaps into the plane of its base, away from every edge: only its volume is gone.
    test::TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-4}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    expect_refused(place_cutter(tetrahedron.cutter().value(), {}), ErrorCode::kInvalid, "encloses no volume");
    EXPECT_TRUE(place_cutter(tetrahedron.cutter().value(), {.scale = 2}).ok());
}

TEST(PlaceCutter, GivesTheSameBitsEverywhere) {
    std::uint64_t hash = 0;
    for (const CutterShape shape :
         {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill, CutterShape::kWedge, CutterShape::kBox})
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Pose pose{.position = {1.1, 2.2, 3.3}, .rotation = random_turn(seed), .scale = 1.6};
            const PlacedCutter placed = place_cutter(make_crater(shape, seed), pose).value();
            for (const InputPoint& v : placed.vertices)
                for (int axis = 0; axis < 3; ++axis) hash = mix_bits(hash ^ std::uint32_t(v[axis]));
        }
    EXPECT_EQ(hash, 2122297222067773103u) << "as g++ 12 and clang 19 have it";
}

}  // namespace
}  // namespace firma

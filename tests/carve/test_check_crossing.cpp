// SPDX-License-Identifier: MIT
// Whether a cutter crosses itself: known ones by hand, and random triangles against clipping in rational numbers.
#include "carve/check_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/polygons_cross.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

using test::box_mesh;
using test::placed_by_hand;
using test::TriangleMesh;

// The oracle. What two triangles share is one of them clipped by the other: by its plane from both sides, and by the
// planes that stand on its sides. It may be no more than the shared vertices span.

using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;

Point point_of(const InputPoint& p) {
    return {Rational(p.x), Rational(p.y), Rational(p.z)};
}
Point minus(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational dot_product(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross_product(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What of a convex outline lies where normal . (p - at) >= 0.
std::vector<Point> clipped(const std::vector<Point>& outline, const Point& at, const Point& normal) {
    std::vector<Point> kept;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point &p = outline[k], &q = outline[(k + 1) % outline.size()];
        const Rational hp = dot_product(normal, minus(p, at)), hq = dot_product(normal, minus(q, at));
        if (hp >= 0) kept.push_back(p);
        if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) {
            const Rational part = hp / (hp - hq);
            Point meet;
            for (std::size_t axis = 0; axis < 3; ++axis) meet[axis] = p[axis] + part * (q[axis] - p[axis]);
            kept.push_back(meet);
        }
    }
    return kept;
}

bool on_segment(const Point& p, const Point& a, const Point& b) {
    return cross_product(minus(p, a), minus(b, a)) == Point{} && dot_product(minus(p, a), minus(p, b)) <= 0;
}

bool oracle_cross(const std::vector<InputPoint>& vertices, const CutterTriangle& t, const CutterTriangle& u) {
    std::vector<Point> shape;
    for (const std::uint32_t corner : t) shape.push_back(point_of(vertices[corner]));
    const Point a = point_of(vertices[u[0]]), b = point_of(vertices[u[1]]), c = point_of(vertices[u[2]]);
    const Point normal = cross_product(minus(b, a), minus(c, a));
    shape = clipped(shape, a, normal);
    shape = clipped(shape, a, minus({}, normal));
    shape = clipped(shape, a, cross_product(normal, minus(b, a)));
    shape = clipped(shape, b, cross_product(normal, minus(c, b)));
    shape = clipped(shape, c, cross_product(normal, minus(a, c)));
    std::vector<Point> shared;
    for (const std::uint32_t corner : t)
        if (std::find(u.begin(), u.end(), corner) != u.end()) shared.push_back(point_of(vertices[corner]));
    if (shared.size() == 3) return true;
    return std::any_of(shape.begin(), shape.end(),
                       [&](const Point& p) { return shared.empty() || !on_segment(p, shared.front(), shared.back()); });
}

bool has_area(const std::vector<InputPoint>& vertices, const CutterTriangle& t) {
    const AreaVector area = area_vector(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return (area.x | area.y | area.z) != 0;
}

/// Two triangles of up to six vertices that share `shared` of them, in any order of corners.
struct Pair {
    std::vector<InputPoint> vertices;
    CutterTriangle t{}, u{};
};

std::optional<Pair> random_pair(scenes::Rng& rng, std::uint32_t shared, const std::function<InputPoint()>& draw) {
    Pair pair;
    for (std::uint32_t k = 0; k < 6 - shared; ++k) pair.vertices.push_back(draw());
    for (std::uint32_t k = 0; k < 3; ++k) {
        pair.t[k] = k;
        pair.u[k] = 3 - shared + k;
    }
    for (CutterTriangle* triangle : {&pair.t, &pair.u})
        for (std::size_t k = 2; k > 0; --k) std::swap((*triangle)[k], (*triangle)[rng.below(std::uint32_t(k) + 1)]);
    if (!has_area(pair.vertices, pair.t) || !has_area(pair.vertices, pair.u)) return std::nullopt;
    return pair;
}

bool cross(const std::vector<InputPoint>& vertices, const CutterTriangle& t, const CutterTriangle& u) {
    return polygons_cross(vertices, {t, polygon_normal(vertices, t)}, {u, polygon_normal(vertices, u)});
}

/// Compares with the oracle; returns how many pairs crossed.
int compare_pairs(std::uint64_t seed, int count, const std::function<InputPoint(scenes::Rng&)>& draw) {
    scenes::Rng rng(seed);
    int crossed = 0;
    for (int k = 0; k < count; ++k) {
        const auto pair = random_pair(rng, std::uint32_t(k) % 4, [&] { return draw(rng); });
        if (!pair) continue;
        const bool expected = oracle_cross(pair->vertices, pair->t, pair->u);
        crossed += expected;
        EXPECT_EQ(cross(pair->vertices, pair->t, pair->u), expected) << "pair " << k;
        EXPECT_EQ(cross(pair->vertices, pair->u, pair->t), expected) << "pair " << k;
    }
    return crossed;
}

InputPoint on_grid(scenes::Rng& rng, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    InputPoint p;
    p.x = std::int32_t(rng.below(x));
    p.y = std::int32_t(rng.below(y));
    p.z = std::int32_t(rng.below(z));
    return p;
}

TEST(TrianglesCross, AgreesWithClippingWhereMuchTouches) {
    EXPECT_GT(compare_pairs(1, 4000, [](scenes::Rng& rng) { return on_grid(rng, 3, 3, 3); }), 1000);
    EXPECT_GT(compare_pairs(2, 4000, [](scenes::Rng& rng) { return on_grid(rng, 6, 6, 6); }), 500);
}

TEST(TrianglesCross, AgreesWithClippingInOnePlane) {
    EXPECT_GT(compare_pairs(3, 3000, [](scenes::Rng& rng) { return on_grid(rng, 5, 5, 1); }), 1000);
    // A slanted one, far out: x + 2 y - 3 z is the same for all.
    EXPECT_GT(compare_pairs(4, 3000,
                            [](scenes::Rng& rng) {
                                const InputPoint p = on_grid(rng, 5, 5, 1);
                                return InputPoint{33'000'000 - 2 * p.x + 3 * p.y, -33'000'000 + p.x, p.y};
                            }),
              1000);
}

TEST(TrianglesCross, AgreesWithClippingAcrossTheWholeWorld) {
    const auto anywhere = [](scenes::Rng& rng) {
        InputPoint p = on_grid(rng, 1u << 26, 1u << 26, 1u << 26);
        for (int axis = 0; axis < 3; ++axis) p[axis] -= 1 << 25;
        return p;
    };
    EXPECT_GT(compare_pairs(5, 2000, anywhere), 500);
    // Corners of the world, a step aside: the largest determinants, and the least sides.
    EXPECT_GT(compare_pairs(6, 3000,
                            [](scenes::Rng& rng) {
                                InputPoint p;
                                for (int axis = 0; axis < 3; ++axis) {
                                    const std::uint32_t side = rng.below(3), step = rng.below(2);
                                    const std::int32_t places[3] = {-(1 << 25), 0, (1 << 25) - 2};
                                    p[axis] = places[side] + std::int32_t(step);
                                }
                                return p;
                            }),
              500);
}

TEST(TrianglesCross, SoupsOfTriangles) {
    scenes::Rng rng(7);
    int clean = 0;
    for (int k = 0; k < 300; ++k) {
        std::vector<InputPoint> vertices;
        std::vector<CutterTriangle> triangles;
        for (int v = 0; v < 14; ++v) vertices.push_back(on_grid(rng, 9, 9, 9));
        while (triangles.size() < 6) {
            CutterTriangle t{};
            for (std::uint32_t& corner : t) corner = rng.below(14);
            if (has_area(vertices, t)) triangles.push_back(t);
        }
        bool expected = false;
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (std::size_t u = 0; u < t; ++u) expected |= oracle_cross(vertices, triangles[t], triangles[u]);
        const auto found = find_crossing_pair(placed_by_hand(vertices, triangles));
        ASSERT_EQ(found.has_value(), expected);
        if (found) {
            EXPECT_LT(found->first, found->second);
            EXPECT_TRUE(oracle_cross(vertices, triangles[found->first], triangles[found->second]));
        }
        clean += !expected;
    }
    EXPECT_GT(clean, 10);
}

// Whole cutters.

PlacedCutter placed(const TriangleMesh& mesh, const Pose& pose = {}) {
    return place_cutter(mesh.cutter().value(), pose).value();
}

/// Both ways agree; returns whether it crosses.
bool crosses(const PlacedCutter& cutter) {
    const bool found = find_crossing_pair(cutter).has_value();
    EXPECT_EQ(find_crossing(cutter).has_value(), found);
    EXPECT_FALSE(is_star_shaped(cutter) && found);
    return found;
}

TEST(FindCrossing, OurShapesDoNotAtAnySize) {
    int stars = 0, all = 0;
    for (const CutterShape shape :
         {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill, CutterShape::kWedge, CutterShape::kBox})
        for (const double radius : {0.05, 0.2, 1.6, 50.0})
            for (std::uint64_t seed = 0; seed < 12; ++seed) {
                const Pose pose{.position = {5, 6, 7}, .rotation = random_turn(seed), .scale = radius};
                const PlacedCutter cutter = place_cutter(make_crater(shape, seed), pose).value();
                EXPECT_FALSE(crosses(cutter)) << cutter.name << seed;
                stars += is_star_shaped(cutter);
                ++all;
            }
    EXPECT_EQ(stars, all) << "the quick way settles them";
}

TEST(FindCrossing, TwoBoxesThroughEachOther) {
    TriangleMesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
    mesh.add(box_mesh({1, 1, 1}, {3, 3, 3}));
    EXPECT_TRUE(crosses(placed(mesh)));
    EXPECT_TRUE(crosses(placed(mesh, {.rotation = random_turn(1)})));
}

TEST(FindCrossing, BoxesBesideEachOtherAndInEachOther) {
    TriangleMesh apart = box_mesh({0, 0, 0}, {2, 2, 2});
    apart.add(box_mesh({2.001, 0, 0}, {3, 1, 1}));
    EXPECT_FALSE(crosses(placed(apart)));
    TriangleMesh hollow = box_mesh({0, 0, 0}, {3, 3, 3}), core = box_mesh({1, 1, 1}, {2, 2, 2});
    core.turn_over();
    hollow.add(core);
    EXPECT_FALSE(is_star_shaped(placed(hollow)));
    EXPECT_FALSE(crosses(placed(hollow)));
}

TEST(FindCrossing, TouchingIsCrossing) {
    const TriangleMesh box = box_mesh({0, 0, 0}, {2, 2, 2});
    for (const auto& [low, high] : {std::pair(Vec3{2, 2, 2}, Vec3{3, 3, 3}),      // at a vertex
                                    std::pair(Vec3{2, 2, 0.5}, Vec3{3, 3, 1}),    // along an edge
                                    std::pair(Vec3{2, 0.5, 0.5}, Vec3{3, 1, 1}),  // at a face
                                    std::pair(Vec3{0.5, 0.5, 0.5}, Vec3{1, 1, 2})}) {
        TriangleMesh mesh = box;
        mesh.add(box_mesh(low, high));
        EXPECT_TRUE(crosses(placed(mesh)));
    }
}

TEST(FindCrossing, OneVertexOfTwoShellsIsAllowed) {
    TriangleMesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
    mesh.add(box_mesh({2, 2, 2}, {3, 3, 3}));
    for (CutterTriangle& corners : mesh.triangles)
        for (std::uint32_t& corner : corners)
            if (corner == 8) corner = 7;
    EXPECT_FALSE(crosses(placed(mesh)));
}

TEST(FindCrossing, ASpikeOfItsOwnThroughABox) {
    // The middle of the top is drawn down: a dent at first, then out through the bottom.
    TriangleMesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
    std::erase_if(mesh.triangles, [](const CutterTriangle& t) { return t[0] >= 4 && t[1] >= 4 && t[2] >= 4; });
    ASSERT_EQ(mesh.triangles.size(), 10u);
    for (const CutterTriangle& t : {CutterTriangle{4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}})
        mesh.triangles.push_back(t);
    mesh.vertices.push_back({0.9, 1.05, 3});
    EXPECT_FALSE(crosses(placed(mesh)));
    mesh.vertices[8].z = 0.001;
    EXPECT_FALSE(is_star_shaped(placed(mesh)));
    EXPECT_FALSE(crosses(placed(mesh)));
    mesh.vertices[8].z = 0;
    EXPECT_TRUE(crosses(placed(mesh))) << "touches the bottom";
    mesh.vertices[8].z = -1;
    EXPECT_TRUE(crosses(placed(mesh)));
}

TEST(FindCrossing, NeighboursFoldedOntoEachOther) {
    const std::vector<InputPoint> vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {3, 4, 0}, {5, -9, 0}, {3, 4, 1}};
    EXPECT_TRUE(find_crossing_pair(placed_by_hand(vertices, {{0, 1, 2}, {1, 0, 3}})));
    EXPECT_FALSE(find_crossing_pair(placed_by_hand(vertices, {{0, 1, 2}, {1, 0, 4}})));
    EXPECT_FALSE(find_crossing_pair(placed_by_hand(vertices, {{0, 1, 2}, {1, 0, 5}})));
    EXPECT_TRUE(find_crossing_pair(placed_by_hand(vertices, {{0, 1, 2}, {0, 2, 1}})));
}

TEST(FindCrossing, WindingTwiceAroundIsNoStar) {
    // A double pyramid whose rim goes around twice: every triangle faces away from the middle.
    std::vector<InputPoint> vertices = {{0, 0, 1000}, {0, 0, -1000}};
    const int rim[8][2] = {{1000, 0}, {0, 1000}, {-1000, 0}, {0, -1000}, {1100, 0}, {0, 1200}, {-1300, 0}, {0, -1400}};
    std::vector<CutterTriangle> triangles;
    for (std::uint32_t k = 0; k < 8; ++k) {
        vertices.push_back({rim[k][0], rim[k][1], 0});
        const std::uint32_t at = 2 + k, next = 2 + (k + 1) % 8;
        triangles.push_back({0, at, next});
        triangles.push_back({1, next, at});
    }
    const PlacedCutter cutter = placed_by_hand(vertices, triangles);
    EXPECT_FALSE(is_star_shaped(cutter));
    EXPECT_TRUE(crosses(cutter));
}

TEST(FindCrossing, SeenEdgeOnIsNoStar) {
    // The middle of the bottom is drawn up into the middle of all: its triangles lie in planes through it.
    TriangleMesh mesh = box_mesh({-2, -2, -2}, {2, 2, 2});
    std::erase_if(mesh.triangles, [](const CutterTriangle& t) { return t[0] < 4 && t[1] < 4 && t[2] < 4; });
    for (const CutterTriangle& t : {CutterTriangle{1, 0, 8}, {3, 1, 8}, {2, 3, 8}, {0, 2, 8}})
        mesh.triangles.push_back(t);
    mesh.vertices.push_back({0, 0, 0});
    EXPECT_FALSE(is_star_shaped(placed(mesh)));
    EXPECT_FALSE(crosses(placed(mesh)));
    mesh.vertices[8].z = -0.5;
    EXPECT_TRUE(is_star_shaped(placed(mesh)));
}

TEST(FindCrossing, ARingIsNoStarButClean) {
    const TriangleMesh ring = test::ring_mesh(40, 20);
    const PlacedCutter cutter = placed(ring, {.rotation = random_turn(3), .scale = 0.7});
    EXPECT_FALSE(is_star_shaped(cutter));
    EXPECT_FALSE(crosses(cutter));
    TriangleMesh two = ring;
    two.add(box_mesh({-1, -1, -1}, {1, 1, 1}));
    EXPECT_FALSE(crosses(placed(two)));
    two.add(box_mesh({-9, 0.1, 0.1}, {-1.5, 0.2, 0.2}));
    EXPECT_TRUE(crosses(placed(two)));
}

TEST(FindCrossing, NothingAtAll) {
    EXPECT_FALSE(find_crossing({}));
}

}  // namespace
}  // namespace firma

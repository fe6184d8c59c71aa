// SPDX-License-Identifier: MIT
// Where a point lies that no crossing tells about: exactly, however near it lies to the surface and to the world's rim.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "carve/cutter_solid.h"
#include "carve/place_solid.h"
#include "carve/side_of_solid.h"
#include "firma/carve.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using namespace test;

Vec3 in_metres(const InputPoint& p) {
    return to_metres(to_surface(p));
}

InputPoint random_corner(scenes::Rng& rng, int reach) {
    const auto steps = [&] { return int(rng.below(2 * std::uint32_t(reach) + 1)) - reach; };
    const int x = steps(), y = steps(), z = steps();
    return {x, y, z};
}

/// Four corners, turned so that they enclose; none where they lie in one plane.
using Tetrahedron = std::array<InputPoint, 4>;
constexpr std::array<std::array<std::size_t, 3>, 4> kSides{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};

std::optional<Tetrahedron> tetrahedron(scenes::Rng& rng, int reach) {
    Tetrahedron it{random_corner(rng, reach), random_corner(rng, reach), random_corner(rng, reach),
                   random_corner(rng, reach)};
    const Plane plane = plane_through(it[0], it[1], it[2]);
    const int side = plane.valid() ? exact_side(plane, ExactPoint(it[3])) : 0;
    if (side == 0) return std::nullopt;
    if (side > 0) std::swap(it[1], it[2]);
    return it;
}

Cutter cutter_of(const Tetrahedron& it) {
    TriangleMesh mesh;
    for (const InputPoint& p : it) mesh.vertices.push_back(in_metres(p));
    for (const auto& [a, b, c] : kSides)
        mesh.triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
    return mesh.cutter().value();
}

/// 1 within, 0 on its surface, -1 outside.
int side_of(const Tetrahedron& it, const ExactPoint& point) {
    int inside = 1;
    for (const auto& [a, b, c] : kSides) {
        const int side = exact_side(plane_through(it[a], it[b], it[c]), point);
        if (side > 0) return -1;
        if (side == 0) inside = 0;
    }
    return inside;
}

/// A point of the grid near a side, mostly within a step of it.
InputPoint point_beside(const Tetrahedron& it, scenes::Rng& rng) {
    const auto& side = kSides[rng.below(4)];
    double u = rng.uniform(), v = rng.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    InputPoint p;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = it[side[0]][axis], b = it[side[1]][axis], c = it[side[2]][axis];
        p[axis] = std::int32_t(std::floor(a + (b - a) * u + (c - a) * v)) + int(rng.below(2));
    }
    return p;
}

TEST(SideOfSolid, PointsBesideSlopes) {
    scenes::Rng rng(41);
    int counts[3] = {0, 0, 0};
    for (int k = 0; k < sample(300); ++k) {
        const std::optional<Tetrahedron> it = tetrahedron(rng, 2000);
        if (!it) continue;
        const Cutter cutter = cutter_of(*it);
        const Solid solid = unite(Solid(), cutter, Pose()).solid;
        ASSERT_GT(solid.face_count(), 0u);
        CutterSolid mesh, turned;
        ASSERT_FALSE(place_any_cutter(cutter, Pose(), mesh));
        ASSERT_FALSE(place_any_cutter(cutter_from_solid(solid).value(), Pose(), turned));
        for (int tries = 0; tries < 40; ++tries) {
            const ExactPoint point(tries < 4        ? (*it)[std::size_t(tries)]
                                   : tries % 4 == 0 ? random_corner(rng, 2000)
                                                    : point_beside(*it, rng));
            const int side = side_of(*it, point);
            ++counts[side + 1];
            ASSERT_EQ(side_of_solid(solid, point), side) << k << " " << tries;
            ASSERT_EQ(side_of_cutter(mesh, point), side) << k << " " << tries;
            ASSERT_EQ(side_of_cutter(turned, point), side) << k << " " << tries;
        }
    }
    for (const int count : counts) EXPECT_GT(count, sample(100));
}

/// Points of three planes, which are none of the grid, beside what cuts left.
TEST(SideOfSolid, PointsOfThreePlanes) {
    scenes::Rng rng(42);
    int asked = 0;
    for (int k = 0; k < sample(300); ++k) {
        const std::optional<Tetrahedron> rock = tetrahedron(rng, 2000), bite = tetrahedron(rng, 2000);
        if (!rock || !bite) continue;
        const SolidResult bitten = subtract(unite(Solid(), cutter_of(*rock), Pose()).solid, cutter_of(*bite), Pose());
        if (!bitten.done()) continue;
        for (int tries = 0; tries < 20; ++tries) {
            Plane planes[3];
            const InputPoint near = point_beside(tries % 2 == 0 ? *rock : *bite, rng);
            for (Plane& plane : planes) {
                const InputPoint a = near, b = random_corner(rng, 2000), c = random_corner(rng, 2000);
                plane = plane_through(a, b, c);
            }
            if (!planes[0].valid() || !planes[1].valid() || !planes[2].valid()) continue;
            // Near it, not at it.
            planes[2] = plane_through({near.x + 1, near.y, near.z}, random_corner(rng, 2000), random_corner(rng, 2000));
            if (!planes[2].valid() || exact_turn(planes[0], planes[1], planes[2]) == 0) continue;
            if (!meet_in_world(planes[0], planes[1], planes[2])) continue;
            const ExactPoint point(planes[0], planes[1], planes[2]);
            const int in_rock = side_of(*rock, point), in_bite = side_of(*bite, point);
            if (in_rock == 0 || in_bite == 0) continue;
            ++asked;
            ASSERT_EQ(side_of_solid(bitten.solid, point), in_rock > 0 && in_bite < 0 ? 1 : -1) << k << " " << tries;
        }
    }
    EXPECT_GT(asked, sample(1000));
}

/// Touching nothing, and nearer to a slope than facets are sure.
TEST(SideOfSolid, CutsWithinMicrometresOfASlope) {
    const auto at = [](int x, int y, int z) { return in_metres({x, y, z}); };
    TriangleMesh tool;
    tool.vertices = {at(0, 0, 0), at(0, 100, 0), at(10, 50, 0), at(4096, 50, 1)};
    tool.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
    const auto volume = [&] {
        const auto& v = tool.vertices;
        return dot(cross(v[1] - v[0], v[2] - v[0]), v[3] - v[0]);
    };
    if (volume() > 0) tool.turn_over();
    for (const bool above : {true, false}) {
        // The plane z = (x - 400) / 4096, and rock on one side of it.
        TriangleMesh rock;
        for (const int y : {-8192, 8192})
            for (const Vec3& corner : {at(400 - 16384, y, -4), at(400 + 16384, y, 4), at(0, y, above ? 8192 : -8192)})
                rock.vertices.push_back(corner);
        rock.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
        if (!above) rock.turn_over();
        const Solid solid = unite(Solid(), rock.cutter().value(), Pose()).solid;
        ASSERT_GT(solid.face_count(), 0u);
        const Cutter cutter = tool.cutter().value();
        const SolidResult carved = subtract(solid, cutter, Pose()), filled = unite(solid, cutter, Pose());
        EXPECT_NE(carved.status, CarveStatus::kRefused) << carved.error.text();
        EXPECT_NE(filled.status, CarveStatus::kRefused) << filled.error.text();
        EXPECT_EQ(carved.done(), above);
        EXPECT_EQ(filled.done(), !above);
    }
}

TEST(SideOfSolid, CuttersToTheRim) {
    const Solid crater = unite(Solid(), make_crater(CutterShape::kRocky, 3), Pose()).solid;
    for (const double rim : {8191.0, 8191.99, 8191.999, 8192 - 1 / kInputSteps}) {
        const TriangleMesh box = box_mesh({-rim, -rim, -rim}, {rim, rim, rim});
        const Solid as_solid = unite(Solid(), box.cutter().value(), Pose()).solid;
        for (const Cutter& cutter : {box.cutter().value(), cutter_from_solid(as_solid).value()}) {
            const SolidResult gone = subtract(crater, cutter, Pose()), filled = unite(crater, cutter, Pose());
            ASSERT_TRUE(gone.done()) << rim << gone.error.text();
            EXPECT_EQ(gone.solid.face_count(), 0u);
            ASSERT_TRUE(filled.done()) << rim << filled.error.text();
            EXPECT_TRUE(same_solid(filled.solid, as_solid));
        }
    }
}

}  // namespace
}  // namespace firma

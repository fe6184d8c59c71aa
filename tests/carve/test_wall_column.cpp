// SPDX-License-Identifier: MIT
// Prisms over polygons in a wall: one where their outline is sound on the input grid, else one for each; and polygons
// that cover where a wall's plane meets a box.
#include "carve/wall_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/carve/winding.h"

namespace firma {
namespace {

constexpr double kStep = 1 / kInputSteps;

/// In the plane z = 0; corners in metres.
FaceSet polygons_of(const std::vector<std::vector<Vec3>>& polygons) {
    FaceSet set;
    for (const std::vector<Vec3>& polygon : polygons) {
        FaceSet::Entry face;
        face.first_corner = std::uint32_t(set.corners.size());
        face.corner_count = std::uint32_t(polygon.size());
        for (const Vec3& p : polygon) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back({std::int32_t(std::lround(p.x * kSurfaceSteps)),
                                    std::int32_t(std::lround(p.y * kSurfaceSteps)),
                                    std::int32_t(std::lround(p.z * kSurfaceSteps))});
        }
        set.faces.push_back(face);
    }
    return set;
}

std::vector<Vec3> square(double x, double y, double size) {
    return {{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}};
}

bool hold(const std::vector<Cutter>& columns, const Vec3& p) {
    for (const Cutter& column : columns)
        if (test::winding(column, {}, p) > 0.5) return true;
    return false;
}

const WallPlane kFloor = wall_plane({0, 0, 1}, {0, 0, 0});

TEST(WallColumn, PolygonsSideBySideAreOneColumn) {
    const std::vector<Cutter> columns = columns_over(polygons_of({square(0, 0, 1), square(1, 0, 1)}), kFloor, 2);
    ASSERT_EQ(columns.size(), 1u);
    for (const double x : {kStep / 2, 0.5, 1.0, 1.5, 2 - kStep / 2}) {
        EXPECT_TRUE(hold(columns, {x, 0.5, 1})) << x;
        EXPECT_TRUE(hold(columns, {x, 0.5, -4 * kStep})) << x;
        EXPECT_FALSE(hold(columns, {x, 0.5, 2 + kStep})) << x;
        EXPECT_FALSE(hold(columns, {x, 0.5, -9 * kStep})) << x;
    }
    EXPECT_FALSE(hold(columns, {-kStep / 2, 0.5, 1}));
    EXPECT_FALSE(hold(columns, {2 + kStep / 2, 0.5, 1}));
}

TEST(WallColumn, AnOutlineThatTouchesItselfGivesColumnsThatOverlap) {
    // Corner on corner; and a strip thinner than the grid between two squares that it keeps apart.
    const std::vector<Cutter> touching = columns_over(polygons_of({square(0, 0, 1), square(1, 1, 1)}), kFloor, 2);
    ASSERT_EQ(touching.size(), 2u);
    for (const Vec3& p : {Vec3{0.5, 0.5, 1}, {1.5, 1.5, 1}, {1, 1, 1}, {-kStep / 2, 0.5, 1}, {1, 0.5, 1}})
        EXPECT_TRUE(hold(touching, p)) << p.x;
    EXPECT_FALSE(hold(touching, {1 + 2 * kStep, 1 - 2 * kStep, 1}));
    // Snapped, the corner in the middle of a side lies beyond it: the outline crosses itself.
    const double bit = kStep * 0.45;
    const std::vector<Cutter> crossed = columns_over(
        polygons_of({{{0, 0, 0}, {1, kStep, 0}, {0, 1, 0}}, {{0, -1, 0}, {1, -1, 0}, {0.5, kStep / 2 - bit, 0}}}),
        kFloor, 2);
    EXPECT_GE(crossed.size(), 1u);
    for (const Vec3& p : {Vec3{0.3, 0.3, 1}, {0.5, -0.5, 1}}) EXPECT_TRUE(hold(crossed, p)) << p.x;
    // What is no more than a point on the grid.
    const std::vector<Cutter> small = columns_over(polygons_of({square(0, 0, kStep / 8)}), kFloor, 2);
    ASSERT_EQ(small.size(), 1u);
    EXPECT_TRUE(hold(small, {kStep / 16, kStep / 16, 1}));
    EXPECT_FALSE(hold(small, {2 * kStep, 0, 1}));
}

TEST(WallColumn, SectionsCoverWhereThePlaneMeetsTheBox) {
    GridBox box;
    box.add(GridPoint{-262144, -262144, -262144});
    box.add(GridPoint{262144, 262144, 262144});
    for (const double way : {-1.0, 1.0}) {
        const FaceSet flat = section_of_box(wall_plane({0, way, 0}, {0, 64000, 0}), box);
        ASSERT_EQ(flat.faces.size(), 1u);
        for (const GridPoint& p : flat.vertices) EXPECT_EQ(p.y, 64000);
        EXPECT_TRUE(section_of_box(wall_plane({0, way, 0}, {0, 262145, 0}), box).faces.empty());
        const Vec3 normal = Vec3{0.6, -0.8, 0} * way;
        const WallPlane wall = wall_plane(normal, {3 * 6400, 0, 0});
        const FaceSet slanted = section_of_box(wall, box);
        ASSERT_EQ(slanted.faces.size(), 2u);
        Vec3 sum;
        for (const FaceSet::Entry& face : slanted.faces) {
            const Vec3 a = to_metres(slanted.corner(face, 0));
            sum = sum + cross(to_metres(slanted.corner(face, 1)) - a, to_metres(slanted.corner(face, 2)) - a);
            for (std::uint32_t k = 0; k < face.corner_count; ++k) {
                const double height = wall.height(to_metres(slanted.corner(face, k))) * kSurfaceSteps;
                EXPECT_LT(height, -2);
                EXPECT_GT(height, -5);
            }
        }
        EXPECT_GT(dot(sum, normal), 9) << "twice the area, seen from the front";
    }
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Triangles that a portal was drawn by, as polygons.
#include "level/portal_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "firma/polygon.h"

namespace firma {
namespace {

using Triangle = std::array<GridPoint, 3>;

GridPoint point_at(double x, double y, double z) {
    return snap({x, y, z}).value();
}

std::vector<Vec3> metres_of(const std::vector<GridPoint>& polygon) {
    std::vector<Vec3> corners;
    for (const GridPoint& point : polygon) corners.push_back(to_metres(point));
    EXPECT_EQ(check_polygon(corners), PolygonFault::kNone);
    return corners;
}

/// Twice the area, along the normal.
Vec3 area_vector_of(const std::vector<GridPoint>& polygon) {
    const std::vector<Vec3> corners = metres_of(polygon);
    Vec3 sum;
    for (std::size_t k = 2; k < corners.size(); ++k)
        sum = sum + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    return sum;
}

TEST(PortalPolygons, TrianglesAboutAMiddleBecomeASquare) {
    const GridPoint a = point_at(0, 0, 0), b = point_at(2, 0, 0), c = point_at(2, 2, 0), d = point_at(0, 2, 0),
                    middle = point_at(1, 1, 0);
    const auto made =
        portal_polygons(std::vector<Triangle>{Triangle{a, b, middle}, {b, c, middle}, {c, d, middle}, {d, a, middle}});
    ASSERT_EQ(made.size(), 1u);
    EXPECT_EQ(made[0].size(), 4u);
    EXPECT_EQ(area_vector_of(made[0]), (Vec3{0, 0, 8})) << "its front is that of the triangles";
}

TEST(PortalPolygons, APlaneEachInOrderOfItsFirstTriangle) {
    const GridPoint a = point_at(0, 0, 0), b = point_at(1, 0, 0), c = point_at(1, 1, 0), d = point_at(0, 1, 0),
                    up = point_at(0, 0, 1), far = point_at(1, 0, 1);
    const auto made = portal_polygons(std::vector<Triangle>{Triangle{a, b, far}, {a, b, c}, {a, far, up}, {a, c, d}});
    ASSERT_EQ(made.size(), 2u);
    EXPECT_EQ(area_vector_of(made[0]), (Vec3{0, -2, 0}));
    EXPECT_EQ(area_vector_of(made[1]), (Vec3{0, 0, 2}));
}

TEST(PortalPolygons, AnLIsDivided) {
    const GridPoint a = point_at(0, 0, 0), b = point_at(2, 0, 0), c = point_at(2, 1, 0), d = point_at(1, 1, 0),
                    e = point_at(1, 2, 0), f = point_at(0, 2, 0);
    const auto made = portal_polygons(std::vector<Triangle>{Triangle{a, b, c}, {a, c, d}, {a, d, e}, {a, e, f}});
    EXPECT_GE(made.size(), 2u);
    Vec3 sum;
    for (const auto& polygon : made) sum = sum + area_vector_of(polygon);
    EXPECT_EQ(sum, (Vec3{0, 0, 6}));
}

TEST(PortalPolygons, WithoutAreaThereIsNone) {
    EXPECT_TRUE(portal_polygons({}).empty());
    EXPECT_TRUE(
        portal_polygons(std::vector<Triangle>{Triangle{point_at(0, 0, 0), point_at(1, 0, 0), point_at(2, 0, 0)}})
            .empty());
}

}  // namespace
}  // namespace firma

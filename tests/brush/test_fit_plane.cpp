// SPDX-License-Identifier: MIT
#include "brush/fit_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "brush/plane_families.h"
#include "geometry/exact_plane.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr double kScale = 1.0 / 32;

Plane exact(const FittedPlane& fitted) {
    return plane_through(to_input(fitted.points[0]), to_input(fitted.points[1]), to_input(fitted.points[2]));
}

FloatPlane rounded(const FloatPlane& plane) {
    return {{float(plane.normal.x), float(plane.normal.y), float(plane.normal.z)}, float(plane.distance)};
}

TEST(Winding, CubeHasSquares) {
    std::vector<FloatPlane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            FloatPlane plane{{}, sign > 0 ? 12.0 : -4.0};
            plane.normal[axis] = sign;
            planes.push_back(plane);
        }
    }
    for (std::size_t k = 0; k < 6; ++k) {
        const std::vector<Vec3> corners = winding(planes, k, 1000);
        ASSERT_EQ(corners.size(), 4u);
        EXPECT_DOUBLE_EQ(area(corners), 64);
        const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        EXPECT_GT(dot(normal, planes[k].normal), 0);  // counter-clockwise seen from outside
    }
    planes.push_back({{1, 0, 0}, 20});  // beyond
    EXPECT_TRUE(winding(planes, 6, 1000).empty());
    planes.back().distance = 12;  // twice the same plane: the face is that of both
    EXPECT_DOUBLE_EQ(area(winding(planes, 1, 1000)), 64);
    EXPECT_DOUBLE_EQ(area(winding(planes, 6, 1000)), 64);
    EXPECT_DOUBLE_EQ(area(winding(std::vector<FloatPlane>{planes[0]}, 0, 1000)), 4e6);
}

TEST(Winding, CornersInOnePlaceAreMerged) {
    std::vector<Vec3> corners = {{0, 0, 0}, {0.001, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0.002, 0}};
    merge_corners(corners, 0.01);
    EXPECT_EQ(corners, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    corners = {{0, 0, 0}, {0.001, 0, 0}};
    merge_corners(corners, 0.01);
    EXPECT_EQ(corners.size(), 1u);
}

TEST(Winding, NoPlaneThroughALine) {
    EXPECT_FALSE(float_plane({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
    EXPECT_FALSE(float_plane({0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}));  // no length to divide by
    const auto plane = float_plane({0, 0, 5}, {2, 0, 5}, {0, 2, 5});
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(plane->distance, 5);
}

TEST(FitPlane, AxialDistanceIsSnapped) {
    for (const double sign : {-1.0, 1.0}) {
        FloatPlane plane{{0, sign, 0}, sign * 10.005};
        ASSERT_EQ(axis_of(plane), 1);
        const auto fitted = fit_axial_plane(plane, 1, kScale);
        ASSERT_TRUE(fitted);
        EXPECT_EQ(fitted->points[0].y, 1281 * 64);  // 1280.64 steps
        EXPECT_EQ(exact(*fitted).normal[1], std::int64_t(sign));
        EXPECT_NEAR(fitted->shift, 0.36 / 4096, 1e-9);
    }
    EXPECT_FALSE(fit_axial_plane({{1, 0, 0}, 262144}, 0, kScale));
    EXPECT_FALSE(axis_of({{1, 1e-9, 0}, 0}));
}

TEST(FitPlane, WholeUnitsComeBack) {
    scenes::Rng rng(21);
    const auto whole = [&](double range) { return std::floor(rng.uniform(-range, range)); };
    int fitted_whole = 0;
    for (int round = 0; round < 300; ++round) {
        Vec3 p[3];
        for (Vec3& q : p)
            for (int axis = 0; axis < 3; ++axis) q[axis] = whole(200);
        const Vec3 away = {3000, -1000, 500};
        for (Vec3& q : p) q = q + away;
        const auto plane = float_plane(p[0], p[1], p[2]);
        if (!plane || axis_of(*plane)) continue;
        const FloatPlane from = rounded(*plane);
        // The corners as a compiler's floats place them, and one that is not whole.
        std::vector<Vec3> corners;
        for (const Vec3& q : p) corners.push_back(q + from.normal * (from.distance - dot(from.normal, q)));
        corners.push_back(p[0] * 0.37 + p[1] * 0.63);
        const auto fitted = fit_plane(from, corners, kScale);
        ASSERT_TRUE(fitted);
        ++fitted_whole;
        EXPECT_EQ(fitted->kind, FittedPlane::Points::kWhole);
        EXPECT_LT(fitted->shift, 0.0001);
        const auto steps = [](const Vec3& q) {
            return InputPoint{std::int32_t(q.x * 128), std::int32_t(q.y * 128), std::int32_t(q.z * 128)};
        };
        EXPECT_EQ(exact(*fitted), plane_through(steps(p[0]), steps(p[1]), steps(p[2])));
    }
    EXPECT_GT(fitted_whole, 200);
}

TEST(FitPlane, EighthsAndAnyCorners) {
    const Vec3 eighths[] = {{0.125, 3, 8}, {90.5, 7.375, 8.25}, {4.25, 66.625, 10}};
    auto plane = float_plane(eighths[0], eighths[1], eighths[2]);
    auto fitted = fit_plane(*plane, eighths, kScale);
    ASSERT_TRUE(fitted);
    EXPECT_EQ(fitted->kind, FittedPlane::Points::kEighths);
    EXPECT_LT(fitted->shift, 1e-12);

    const Vec3 any[] = {{0.3331, 3.07, 8.041}, {90.571, 7.377, 8.233}, {4.211, 66.683, 10.057}};
    plane = float_plane(any[0], any[1], any[2]);
    fitted = fit_plane(*plane, any, kScale);
    ASSERT_TRUE(fitted);
    EXPECT_EQ(fitted->kind, FittedPlane::Points::kGrid);
    EXPECT_LT(fitted->shift, 0.9 / 4096);
    EXPECT_GT(dot(exact(*fitted).direction(), plane->normal), 0);
    const FloatPlane behind{-plane->normal, -plane->distance};
    EXPECT_EQ(exact(*fit_plane(behind, any, kScale)), flipped(exact(*fitted)));
}

TEST(FitPlane, NothingWithoutThreeCorners) {
    const Vec3 line[] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    EXPECT_FALSE(fit_plane({{0.6, 0.8, 0}, 0}, line, kScale));
    EXPECT_FALSE(fit_plane({{0.6, 0.8, 0}, 0}, {}, kScale));
    const Vec3 outside[] = {{1e6, 0, 0}, {0, 1e6, 0}, {0, NAN, 1e6}};
    EXPECT_FALSE(fit_plane({{0.6, 0.8, 0}, 0}, outside, kScale));
    EXPECT_TRUE(fit_bare_plane({{0.6, 0.8, 0}, 100}, kScale));
    EXPECT_FALSE(fit_bare_plane({{0.6, 0.8, 0}, 1e6}, kScale));
}

TEST(PlaneFamilies, FindsPlanesFromEitherSide) {
    PlaneFamilies families;
    scenes::Rng rng(22);
    std::vector<FloatPlane> planes;
    for (int k = 0; k < 500; ++k) {
        const Vec3 normal = rng.direction();
        const double distance = rng.uniform(-4000, 4000);
        planes.push_back({normal, distance});
        EXPECT_EQ(families.add(planes.back()), std::uint32_t(k));
    }
    for (std::uint32_t k = 0; k < planes.size(); ++k) {
        const Vec3 foot = planes[k].normal * planes[k].distance;
        const double sign = k % 2 ? -1 : 1;
        FloatPlane near{planes[k].normal * sign, planes[k].distance * sign};
        for (int axis = 0; axis < 3; ++axis) near.normal[axis] += rng.uniform(-5e-6, 5e-6);
        near.distance += rng.uniform(-0.05, 0.05);
        const Vec3 corners[] = {foot, foot + planes[k].normal * 0.009};
        const auto found = families.find(near, corners);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->family, k);
        EXPECT_EQ(found->flipped, k % 2 == 1);
        const Vec3 off[] = {foot, foot + planes[k].normal * 0.02};
        EXPECT_FALSE(families.find(near, off));
    }
    EXPECT_FALSE(families.find({{0, 0, 1}, NAN}, {}));
    EXPECT_FALSE(families.find({{0, 0, 1}, INFINITY}, {}));
}

// Planes that fill one cell: the first are found, the rest stay apart, and nothing takes long.
TEST(PlaneFamilies, OneCellDoesNotGrowWithoutEnd) {
    PlaneFamilies families;
    const auto plane = [](int k) { return FloatPlane{{0.5, 0.001 + 1e-8 * k, 0.86}, 0.5}; };
    for (int k = 0; k < 200000; ++k) families.add({{0.5, 0.001, 0.86}, 0.5});
    EXPECT_EQ(families.find(plane(0), {})->family, 0u);
    const Vec3 away[] = {{9, 9, 9}};
    for (int k = 0; k < 200000; ++k) EXPECT_FALSE(families.find(plane(k), away));
}

}  // namespace
}  // namespace firma

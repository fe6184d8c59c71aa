// SPDX-License-Identifier: MIT
// Volumes of boxes, and how often they wind around edges inside, outside, and in line with their own.
#include "geometry/mesh_shells.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace firma {
namespace {

struct BoxMesh {
    std::vector<InputPoint> points;
    /// Quads, counter-clockwise seen from outside: corner k has bit 0 for x, 1 for y, 2 for z.
    std::array<std::array<std::uint32_t, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

    BoxMesh(std::int32_t low, std::int32_t high) {
        for (int k = 0; k < 8; ++k) points.push_back({k & 1 ? high : low, k & 2 ? high : low, k & 4 ? high : low});
    }
    int winding(const InputPoint& a, const InputPoint& b) const {
        const EdgeRay ray(a, b);
        int sum = 0;
        for (const auto& face : faces) sum += ray.passage(points, {face, polygon_normal(points, face)});
        return sum;
    }
};

TEST(MeshShells, VolumeAboutAnyPoint) {
    constexpr std::int32_t kRim = 1 << 25;
    const BoxMesh box(-3, 7), world(-kRim, kRim - 1);
    for (const InputPoint& apex : {InputPoint{0, 0, 0}, {-3, 7, 2}, {-kRim, kRim - 1, 5}}) {
        Int128 sum = 0, surface = 0, largest = 0;
        for (const auto& face : box.faces) sum += six_times_cone(box.points, face, apex);
        for (const auto& face : world.faces) largest += six_times_cone(world.points, face, apex);
        for (const auto& face : box.faces) {
            std::vector<GridPoint> corners;
            for (const std::uint32_t corner : face) corners.push_back(to_surface(box.points[corner]));
            surface += six_times_cone(corners, to_surface({apex.y, apex.z, apex.x}));
        }
        const Int128 side = 2 * Int128(kRim) - 1, step = kSurfacePerInput;
        EXPECT_TRUE(sum == 6000);
        EXPECT_TRUE(surface == 6000 * step * step * step);
        EXPECT_TRUE(largest == 6 * side * side * side);
    }
}

TEST(MeshShells, WindingAroundEdges) {
    const BoxMesh box(0, 8);
    EXPECT_EQ(box.winding({2, 2, 2}, {3, 5, 4}), 1);
    EXPECT_EQ(box.winding({-5, 4, 4}, {-3, 4, 4}), 0) << "in at one side, out at the other";
    EXPECT_EQ(box.winding({9, 4, 4}, {11, 4, 4}), 0);
    EXPECT_EQ(box.winding({4, 9, 4}, {4, 11, 4}), 0);
    // Rays along edges and through corners pass a shade beside them.
    EXPECT_EQ(box.winding({-5, 0, 0}, {-3, 0, 0}), 0);
    EXPECT_EQ(box.winding({-5, 8, 8}, {-3, 8, 8}), 0);
    EXPECT_EQ(box.winding({-5, 0, 4}, {-3, 0, 4}), 0);
}

TEST(MeshShells, RayIsAsLongAsTheWorld) {
    const GridBox box = EdgeRay({1, 2, 3}, {2, 2, 4}).box();
    EXPECT_EQ(box.low, (GridPoint{96, 128, 224}));
    EXPECT_EQ(box.high, (GridPoint{INT32_MAX, 128, 224}));
}

}  // namespace
}  // namespace firma

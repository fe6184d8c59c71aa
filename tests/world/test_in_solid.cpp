// SPDX-License-Identifier: MIT
// Which side of the surface a point is on, where the rays that tell only graze it.
#include <gtest/gtest.h>

#include "firma/world.h"
#include "scenes/cut_levels.h"

namespace firma {
namespace {

World box_room(const Vec3& low, const Vec3& high) {
    const auto steps = [](const Vec3& p) {
        return scenes::Steps{std::int64_t(p.x * kSurfaceSteps), std::int64_t(p.y * kSurfaceSteps),
                             std::int64_t(p.z * kSurfaceSteps)};
    };
    scenes::Rng rng(1);
    std::vector<scenes::GridPolygon> faces;
    scenes::PanelBox box{steps(low), steps(high)};
    box.room = true;
    scenes::add_panel_box(faces, box, rng);
    return make_world(scenes::level_of(faces)).value();
}

// From rock to rock past a corner of the air: the walls on both sides of it are met at once, and rounding says which is
// met first. Found by a cutter that was filled in twice.
TEST(InSolid, RaysThatGrazeAnEdge) {
    const World world = box_room({31, 40, -20}, {39, 48, 20});
    EXPECT_EQ(locate(world.solid(), {29.125, 45.5, -0.75}), Where::kSolid);
    for (int k = 1; k < 200; ++k)
        for (const double z : {-0.75, 0.0, 0.3, 1.1}) {
            const double away = k / 32.0;
            EXPECT_EQ(locate(world.solid(), {31 - 3 * away, 48 - 4 * away, z}), Where::kSolid) << k << " " << z;
            if (away == 2) continue;  // on the wall
            EXPECT_EQ(locate(world.solid(), {39 - 3 * away, 48 - 4 * away, z}), away > 2 ? Where::kSolid : Where::kAir)
                << k << " " << z;
        }
}

TEST(InSolid, AroundABox) {
    const World world = box_room({0, 0, 0}, {1, 2, 3});
    EXPECT_EQ(locate(world.solid(), {0.5, 1, 1.5}), Where::kAir);
    EXPECT_EQ(locate(world.solid(), {0.5, 1, -1.5}), Where::kSolid);
    EXPECT_EQ(locate(world.solid(), {1e6, 1, -1.5}), Where::kSolid);
    EXPECT_EQ(locate(world.solid(), {0.5, NAN, 0}), Where::kUnknown);
    EXPECT_EQ(locate(world.solid(), {0.5, 1, 0}), Where::kSurface);
    EXPECT_EQ(locate(world.solid(), {1, 2, 3}), Where::kSurface) << "a corner";
    EXPECT_EQ(locate(world.solid(), {0, 1.25, 1.5}), Where::kSurface);
    EXPECT_EQ(locate(world.solid(), {0x1p-60, 1.25, 1.5}), Where::kAir);
    EXPECT_EQ(locate(World().solid(), {0.5, 1, 0}), Where::kAir);
}

}  // namespace
}  // namespace firma

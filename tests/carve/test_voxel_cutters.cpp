// SPDX-License-Identifier: MIT
// Cutters on the lattice of a solid of cubes, of whose edges many are used by four faces.
#include <gtest/gtest.h>

#include "base/random.h"
#include "firma/carve.h"
#include "firma/solid.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using namespace test;

constexpr int kSide = 8;

/// Flat up to the third layer; above it one cube in four is missing.
bool is_cube(int x, int y, int z) {
    const auto within = [](int v) { return v >= 0 && v < kSide; };
    return within(x) && within(y) && within(z) && ((x * 7 + y * 5 + z * 3) % 4 != 0 || z < 3);
}

/// The squares between cubes and air, looking out.
Level cubes() {
    Level level = empty_level();
    for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1})
            for (int k = 0; k < kSide * kSide * kSide; ++k) {
                int cell[3] = {k % kSide, k / kSide % kSide, k / kSide / kSide};
                if (!is_cube(cell[0], cell[1], cell[2])) continue;
                Vec3 low{double(cell[0]), double(cell[1]), double(cell[2])}, along, across;
                along[(axis + 1) % 3] = across[(axis + 2) % 3] = 1;
                cell[axis] += step;
                if (is_cube(cell[0], cell[1], cell[2])) continue;
                if (step > 0)
                    low[axis] += 1;
                else
                    std::swap(along, across);
                add_polygon(level, {low, low + along, low + along + across, low + across});
            }
    return level;
}

class VoxelCutters : public testing::Test {
protected:
    const World world = make_world(cubes()).value();
    const Cutter box = make_crater(CutterShape::kBox, 0);
};

TEST_F(VoxelCutters, TheBlastThatWasRefused) {
    const CarveResult result = carve(world, box, pose_at(1.5, 3, 4.5, 1.5));
    ASSERT_TRUE(result.done()) << result.error.text();
    expect_sound_world(result.world);
}

/// One after the other, each at whole and half metres; each again takes nothing.
TEST_F(VoxelCutters, NoneIsRefused) {
    World dug = world;
    Random random(6);
    int done = 0;
    for (int k = 0; k < sample(150); ++k) {
        const auto half_metres = [&] { return 0.5 * double(random.next() % (2 * kSide + 1)); };
        const double x = half_metres(), y = half_metres(), z = half_metres();
        const double radius = 0.5 * double(1 + random.next() % 3);
        const Pose pose = pose_at(x, y, z, radius);
        const bool carves = k % 3 != 2;
        const CarveResult result = carves ? carve(dug, box, pose) : fill(dug, box, pose, {});
        ASSERT_NE(result.status, CarveStatus::kRefused) << k << ": " << result.error.text();
        if (!result.done()) continue;
        ++done;
        ASSERT_FALSE(check_world(result.world)) << k;
        const double change = measure_solid(result.world).volume - measure_solid(dug).volume;
        EXPECT_NEAR(change, -result.report.volume, 1e-9) << k;
        dug = result.world;
        const CarveResult again = carves ? carve(dug, box, pose) : fill(dug, box, pose, {});
        EXPECT_EQ(again.status, CarveStatus::kNothing) << k << ": " << again.error.text();
    }
    EXPECT_GT(done, sample(60));
}

}  // namespace
}  // namespace firma

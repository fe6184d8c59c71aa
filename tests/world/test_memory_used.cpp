// SPDX-License-Identifier: MIT
// Memory of worlds: what is shared counts once.
#include <gtest/gtest.h>

#include <vector>

#include "firma/level.h"
#include "firma/memory.h"
#include "scenes/room_grid.h"
#include "world/sweep_lanes.h"
#include "world/world_data.h"

namespace firma {
namespace {

TEST(MemoryUsed, CountsSharedBlocksOnce) {
    const Level level = scenes::room_grid({2, 2, 1});
    const World world = make_world(level).value(), twin = make_world(level).value();
    const std::size_t alone = memory_used(world);
    EXPECT_GE(alone, world.statistics().bytes);
    const auto each = [](const void*) { return true; };
    const SolidData& solid = world.solid().data();
    const std::size_t sums =
        solid.points.bytes(each) + solid.faces.regions.bytes(each) + world.data().castable.regions.bytes(each);
    EXPECT_LT(sums, 5000u) << "of the hashes of a few regions";
    EXPECT_LT(alone, world.statistics().bytes + sums + 2000);
    EXPECT_EQ(memory_used(std::vector<World>{world, world}), alone);
    EXPECT_EQ(memory_used(std::vector<World>{world, twin}), 2 * alone) << "equal, but sharing nothing";

    auto next = std::make_shared<WorldData>(world.data());
    ++next->version;
    const std::size_t both = memory_used(std::vector<World>{world, World(next)});
    EXPECT_EQ(both, alone + sizeof(WorldData));
    EXPECT_EQ(memory_used(std::span<const World>{}), 0u);
}

TEST(MemoryUsed, AFaceTakesLittle) {
    const World world = make_world(scenes::room_grid({4, 4, 2})).value();
    // Squares: two triangles each in lanes, which are most of it.
    EXPECT_LT(double(memory_used(world)) / double(world.face_count()), lane_kernels().empty() ? 90 : 150);
}

}  // namespace
}  // namespace firma

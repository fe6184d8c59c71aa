// SPDX-License-Identifier: MIT
// Memory of worlds: what is shared counts once.
#include <gtest/gtest.h>

#include <vector>

#include "firma/level.h"
#include "firma/memory.h"
#include "scenes/room_grid.h"
#include "world/world_data.h"

namespace firma {
namespace {

TEST(MemoryUsed, CountsSharedBlocksOnce) {
    const Level level = scenes::room_grid({2, 2, 1});
    const World world = make_world(level).value(), twin = make_world(level).value();
    const std::size_t alone = memory_used(world);
    EXPECT_GE(alone, world.statistics().bytes);
    EXPECT_LT(alone, world.statistics().bytes + 6000) << "but for sums by region, and what a world is besides faces";
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
    EXPECT_LT(double(memory_used(world)) / double(world.face_count()), 90);
}

}  // namespace
}  // namespace firma

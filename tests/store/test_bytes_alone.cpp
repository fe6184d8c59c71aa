// SPDX-License-Identifier: MIT
// What a version holds alone is the difference that memory_used() finds by counting everything.
#include "store/bytes_alone.h"

#include <gtest/gtest.h>

#include "firma/level.h"
#include "firma/memory.h"
#include "firma/solid.h"
#include "tests/store/cratered.h"
#include "world/world_data.h"

namespace firma {
namespace {

void expect_the_difference(const World& before, const World& after) {
    const World both[] = {before, after};
    const std::size_t together = memory_used(both);
    EXPECT_EQ(bytes_alone(before, after), together - memory_used(after));
    EXPECT_EQ(bytes_alone(after, before), together - memory_used(before));
}

TEST(BytesAlone, IsWhatMemoryUsedFinds) {
    test::CraterMaker maker(1);
    World world = test::building();
    for (int k = 0; k < 60; ++k) {
        const World next = maker.next(world);
        expect_the_difference(world, next);
        EXPECT_GT(bytes_alone(next, world), 1000u);
        world = next;
    }
}

TEST(BytesAlone, IsExactManyVersionsApart) {
    test::CraterMaker maker(2);
    const World first = test::building();
    World world = first;
    for (int k = 0; k < 60; ++k) world = maker.next(world);
    expect_the_difference(first, world);
}

TEST(BytesAlone, OfWorldsWithoutAnythingInCommonIsAll) {
    const World one = test::building(), other = test::building();
    expect_the_difference(one, other);
    EXPECT_EQ(bytes_alone(one, other), memory_used(one));
    expect_the_difference(World(), one);
}

TEST(BytesAlone, CountsWhatIsCastableOnly) {
    // Half a box is open: castable only.
    Level level =
        read_obj("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 4\nv 4 0 4\nf 1 2 3 4\nf 1 2 6 5\n", "open").value();
    const World world = make_world(level).value();
    ASSERT_EQ(world.data().castable.count, 2u);
    expect_the_difference(world, rebuild_index(world, {}));
}

TEST(BytesAlone, OfOneVersionIsNothing) {
    const World world = test::building(), same = world;
    EXPECT_EQ(bytes_alone(world, same), 0u);
    expect_the_difference(world, with_rules(world, {}).value());
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// What two versions hold alone is the difference that memory_used() finds by counting everything.
#include "store/bytes_apart.h"

#include <gtest/gtest.h>

#include "firma/carve_rules.h"
#include "firma/memory.h"
#include "tests/store/cratered.h"

namespace firma {
namespace {

void expect_the_difference(const World& before, const World& after) {
    const World both[] = {before, after};
    const std::size_t together = memory_used(both);
    const BytesApart apart = bytes_apart(before, after);
    EXPECT_EQ(apart.gone, together - memory_used(after));
    EXPECT_EQ(apart.come, together - memory_used(before));
}

TEST(BytesApart, IsWhatMemoryUsedFinds) {
    test::CraterMaker maker(1);
    World world = test::building();
    for (int k = 0; k < 60; ++k) {
        const World next = maker.next(world);
        expect_the_difference(world, next);
        EXPECT_GT(bytes_apart(world, next).come, 1000u);
        world = next;
    }
}

TEST(BytesApart, IsExactManyVersionsApart) {
    test::CraterMaker maker(2);
    const World first = test::building();
    World world = first;
    for (int k = 0; k < 60; ++k) world = maker.next(world);
    expect_the_difference(first, world);
    expect_the_difference(world, first);
}

TEST(BytesApart, OfWorldsWithoutAnythingInCommonIsAll) {
    const World one = test::building(), other = test::building();
    expect_the_difference(one, other);
    EXPECT_EQ(bytes_apart(one, other).gone, memory_used(one));
    expect_the_difference(World(), one);
    expect_the_difference(one, World());
}

TEST(BytesApart, OfOneVersionIsNothing) {
    const World world = test::building(), same = world;
    EXPECT_EQ(bytes_apart(world, same).gone, 0u);
    EXPECT_EQ(bytes_apart(world, same).come, 0u);
    expect_the_difference(world, with_rules(world, {}));
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Worlds made on several threads: the same as on one, told of as they are made, and broken off when that is said.
#include <gtest/gtest.h>

#include <vector>

#include "firma/world.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"
#include "tests/lent_threads.h"
#include "tests/sample.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// What is told: never less than before, all of it at the end.
struct HeardProgress {
    std::size_t calls = 0, last = 0, count = 0, stop_at = ~std::size_t{};
    bool fell = false;

    static bool tell(std::size_t done, std::size_t count, void* user) {
        HeardProgress& told = *static_cast<HeardProgress*>(user);
        told.fell = told.fell || done < told.last || (told.calls > 0 && count != told.count);
        told.last = done;
        told.count = count;
        return ++told.calls < told.stop_at;
    }
};

std::vector<std::uint32_t> ids_of(const Block& block) {
    std::vector<std::uint32_t> ids;
    for (const FaceRecord& face : block.faces) ids.push_back(face.id.value);
    return ids;
}

void expect_same_index(const Node* one, const Node* other) {
    ASSERT_EQ(one == nullptr, other == nullptr);
    if (!one) return;
    ASSERT_EQ(one->box, other->box);
    ASSERT_EQ(one->depth, other->depth);
    ASSERT_EQ(one->facets_below, other->facets_below);
    ASSERT_EQ(one->wide.size(), other->wide.size());
    ASSERT_EQ(one->children.size(), other->children.size());
    for (std::size_t k = 0; k < one->lane_items.size(); ++k) {
        ASSERT_EQ(one->lane_items[k].count, other->lane_items[k].count);
        ASSERT_TRUE(std::equal(std::begin(one->lane_items[k].first), std::end(one->lane_items[k].first),
                               std::begin(other->lane_items[k].first)));
    }
    if (one->is_leaf()) {
        ASSERT_EQ(ids_of(block_of(*one)), ids_of(block_of(*other)));
    }
    for (std::size_t k = 0; k < one->children.size(); ++k)
        expect_same_index(one->children[k].get(), other->children[k].get());
}

void expect_same_world(const World& one, const World& other) {
    EXPECT_EQ(hash_world(one), hash_world(other));
    EXPECT_EQ(hash_solid(one), hash_solid(other));
    EXPECT_EQ(hash_regions(one), hash_regions(other));
    expect_same_index(one.data().solid.data().faces.root.get(), other.data().solid.data().faces.root.get());
    expect_same_index(one.data().castable.root.get(), other.data().castable.root.get());
}

/// @param squares  along each side; of some ten thousand faces the index is made in several tasks
Level ground(int squares = 150) {
    return scenes::terrain({.squares = squares});
}

TEST(BuildTogether, IsTheSameOnAnyThreads) {
    Level castable = ground(test::sample(150));
    for (LevelFace& face : castable.faces) face.two_sided = true;
    const Level rooms = scenes::room_grid(scenes::room_grid_of(std::uint32_t(test::sample(40000))));
    for (const Level& level : {rooms, castable}) {
        const World alone = make_world(level).value();
        for (const std::size_t count : {1, 2, 5}) {
            const test::LentThreads threads(count);
            WorldOptions options;
            options.work.tasks = &threads.tasks;
            expect_same_world(alone, make_world(level, options).value());
        }
    }
}

TEST(BuildTogether, TellsHowFarItIs) {
    const Level level = ground();
    const test::LentThreads threads(2);
    for (const Tasks* tasks : {static_cast<const Tasks*>(nullptr), &threads.tasks}) {
        HeardProgress told;
        WorldOptions options;
        options.work = {tasks, HeardProgress::tell, &told};
        ASSERT_TRUE(make_world(level, options).ok());
        EXPECT_GT(told.calls, 8u);
        EXPECT_FALSE(told.fell);
        EXPECT_EQ(told.last, told.count);
    }
}

TEST(BuildTogether, StopsWhenToldTo) {
    const Level level = ground(test::sample(150));
    const test::LentThreads threads(2);
    HeardProgress all;
    WorldOptions options;
    options.work = {&threads.tasks, HeardProgress::tell, &all};
    ASSERT_TRUE(make_world(level, options).ok());
    for (std::size_t stop = 1; stop <= all.calls; ++stop) {
        HeardProgress told;
        told.stop_at = stop;
        options.work.user = &told;
        const Result<World> world = make_world(level, options);
        ASSERT_FALSE(world.ok()) << stop << " of " << all.calls;
        EXPECT_EQ(world.error().code, ErrorCode::kCancelled);
        EXPECT_EQ(told.calls, stop);
    }
}

TEST(BuildTogether, TasksThatDoNotRunAreAnError) {
    const Tasks idle{[](std::size_t, void (*)(void*, std::size_t), void*, void*) {}, nullptr};
    WorldOptions options;
    options.work.tasks = &idle;
    const Result<World> world = make_world(ground(), options);
    ASSERT_FALSE(world.ok());
    EXPECT_EQ(world.error().code, ErrorCode::kInvalid);
    EXPECT_EQ(world.error().reason, "Tasks::run returned before all its work had");
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// A world made by several threads at once: under the thread sanitizer.
#include <gtest/gtest.h>

#include "firma/world.h"
#include "scenes/room_grid.h"
#include "tests/lent_threads.h"

namespace firma {
namespace {

bool hear(std::size_t done, std::size_t, void* last) {
    *static_cast<std::size_t*>(last) = done;
    return true;
}

TEST(BuildThreads, MakeTheSameWorldWithoutARace) {
    const Level level = scenes::room_grid(scenes::room_grid_of(30000));
    const test::LentThreads threads(4);
    std::size_t last = 0;
    WorldOptions options;
    options.work = {&threads.tasks, hear, &last};
    const World together = make_world(level, options).value();
    EXPECT_EQ(hash_world(together), hash_world(make_world(level).value()));
    EXPECT_EQ(last, 4 * level.faces.size());
}

}  // namespace
}  // namespace firma

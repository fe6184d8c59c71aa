// SPDX-License-Identifier: MIT
// A world made by several threads at once: under the thread sanitizer.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "firma/world.h"
#include "scenes/room_grid.h"

namespace firma {
namespace {

void run_on_four(std::size_t count, void (*work)(void* context, std::size_t k), void* context, void*) {
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (std::size_t k = next++; k < count; k = next++) work(context, k);
        });
    for (std::thread& thread : threads) thread.join();
}

bool hear(std::size_t done, std::size_t, void* last) {
    *static_cast<std::size_t*>(last) = done;
    return true;
}

TEST(BuildThreads, MakeTheSameWorldWithoutARace) {
    const Level level = scenes::room_grid(scenes::room_grid_of(30000));
    const Tasks tasks{run_on_four, nullptr};
    std::size_t last = 0;
    WorldOptions options;
    options.work = {&tasks, hear, &last};
    const World together = make_world(level, options).value();
    EXPECT_EQ(hash_world(together), hash_world(make_world(level).value()));
    EXPECT_EQ(last, 4 * level.faces.size());
}

}  // namespace
}  // namespace firma

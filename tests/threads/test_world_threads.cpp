// SPDX-License-Identifier: MIT
// Many threads ask one World while handles to it come and go: to be run under the thread sanitizer.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "firma/firma.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr int kCasts = 20000;

/// A hash of what a seeded job of casts, overlaps and nearest points answers.
std::uint64_t ask(const World& world, std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Box bounds = world.bounds();
    std::vector<Hit> hits;
    std::vector<Overlap> near;
    std::uint64_t sum = 0;
    for (int k = 0; k < kCasts; ++k) {
        Vec3 centre;
        for (int axis = 0; axis < 3; ++axis) centre[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        const Vec3 direction = rng.direction();
        const Sphere sphere{centre, 0.25};
        sum = sum * 31 + cast(world, sphere, direction * 10).face.id.value;
        if (k % 16 != 0) continue;
        cast_all(world, sphere, direction, hits);
        overlap(world, sphere, near);
        const auto nearest = closest(world, centre, 2);
        sum = sum * 31 + hits.size() + near.size() + (nearest ? nearest.face.id.value : 0);
    }
    return sum;
}

TEST(WorldThreads, AnswerAsOneThreadWould) {
    const Result<Level> level = read_level(FIRMA_ROOT "/levels/first.obj");
    ASSERT_TRUE(level) << level.error().text();
    World world = make_world(level.value()).value();
    const std::uint64_t alone[2] = {ask(world, 1), ask(world, 2)};

    std::uint64_t together[2] = {};
    std::vector<std::thread> threads;
    for (int k = 0; k < 2; ++k) {
        // Each thread holds a handle of its own; the last one to let go, whoever it is, frees the world.
        threads.emplace_back([&, k, mine = world] { together[k] = ask(mine, std::uint64_t(k + 1)); });
    }
    world = World();
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(together[0], alone[0]);
    EXPECT_EQ(together[1], alone[1]);
}

}  // namespace
}  // namespace firma

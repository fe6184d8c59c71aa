// SPDX-License-Identifier: MIT
// One thread edits and publishes while others ask whatever version they hold: to be run under the thread sanitizer.
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "firma/firma.h"
#include "scenes/room_grid.h"
#include "tests/solid/edited_tree.h"

namespace firma {
namespace {

/// A version and what it answers.
struct Published {
    World world;
    std::uint64_t answer = 0;
};

std::uint64_t ask(const World& world) {
    scenes::Rng rng(5);
    std::uint64_t sum = world.face_count();
    for (int k = 0; k < 40; ++k) {
        Vec3 centre;
        for (int axis = 0; axis < 3; ++axis) centre[axis] = rng.uniform(1, axis == 2 ? 5 : 17);
        const Vec3 direction = rng.direction();
        const Hit hit = cast(world, {centre, 0.2}, direction * 8);
        sum = sum * 31 + hit.face.id.value + room_of(world, hit).value;
    }
    return sum;
}

TEST(EditThreads, VersionsAnswerAsTheyDidWhenPublished) {
    EditedTree edited(face_set_of(scenes::room_grid({2, 2, 1})));
    std::mutex lock;
    Published latest{edited.world(), ask(edited.world())};
    std::atomic<bool> done = false;
    std::atomic<int> asked = 0, wrong = 0;
    std::vector<std::thread> readers;
    for (int k = 0; k < 2; ++k)
        readers.emplace_back([&] {
            while (!done || asked < 10) {
                Published mine;
                {
                    const std::lock_guard<std::mutex> guard(lock);
                    mine = latest;
                }
                if (ask(mine.world) != mine.answer) ++wrong;
                ++asked;  // then perhaps the last to let go of an old version
            }
        });
    scenes::Rng rng(8);
    for (int k = 0; k < 60; ++k) {
        Vec3 centre;
        for (int axis = 0; axis < 3; ++axis) centre[axis] = rng.uniform(0, axis == 2 ? 6 : 18);
        edited.crater(centre, 1.2, 4, rng);
        Published next{edited.world(), 0};
        next.answer = ask(next.world);
        const std::lock_guard<std::mutex> guard(lock);
        std::swap(latest, next);
    }
    done = true;
    for (std::thread& reader : readers) reader.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_GE(asked, 10);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// The pool hands out memory that is nobody else's, reuses what comes back, from any thread.
#include "base/pool.h"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

struct Piece {
    unsigned char* memory;
    std::size_t bytes;
    unsigned char mark;
};

bool is_whole(const Piece& piece) {
    for (std::size_t k = 0; k < piece.bytes; ++k)
        if (piece.memory[k] != piece.mark) return false;
    return true;
}

/// Takes and gives back at random; every piece keeps what was written into it.
void churn(std::uint64_t seed, int times, bool& sound) {
    scenes::Rng rng(seed);
    std::vector<Piece> held;
    sound = true;
    for (int k = 0; k < times; ++k) {
        if (held.size() < 200 && rng.chance(0.55)) {
            const std::size_t bytes = 1 + rng.below(rng.chance(0.1) ? 40000 : 2000);
            Piece piece{static_cast<unsigned char*>(pool_take(bytes)), bytes, static_cast<unsigned char>(k)};
            sound = sound && reinterpret_cast<std::uintptr_t>(piece.memory) % alignof(std::max_align_t) == 0;
            std::memset(piece.memory, piece.mark, bytes);
            held.push_back(piece);
        } else if (!held.empty()) {
            const std::size_t at = rng.below(std::uint32_t(held.size()));
            sound = sound && is_whole(held[at]);
            pool_give_back(held[at].memory, held[at].bytes);
            held[at] = held.back();
            held.pop_back();
        }
    }
    for (const Piece& piece : held) {
        sound = sound && is_whole(piece);
        pool_give_back(piece.memory, piece.bytes);
    }
}

TEST(Pool, PiecesDoNotOverlap) {
    bool sound = false;
    churn(1, 20000, sound);
    EXPECT_TRUE(sound);
}

TEST(Pool, ServesThreadsAtOnce) {
    bool sound[3] = {};
    std::vector<std::thread> threads;
    for (std::uint64_t k = 0; k < 3; ++k) threads.emplace_back([&, k] { churn(k + 7, 10000, sound[k]); });
    for (std::thread& thread : threads) thread.join();
    for (const bool each : sound) EXPECT_TRUE(each);
}

TEST(Pool, SizesWasteAtMostAnEighthBeyondTheSmallest) {
    for (std::size_t bytes = 1; bytes <= 20000; ++bytes) {
        const std::size_t taken = pool_size(bytes);
        EXPECT_GE(taken, bytes);
        EXPECT_LE(taken, bytes <= 128 ? bytes + 15 : bytes + bytes / 8);
        EXPECT_GE(pool_size(bytes + 1), taken);
    }
}

TEST(Pool, ReusesWhatCameBack) {
    if (!kPoolKeepsSlabs) GTEST_SKIP() << "under the address sanitizer nothing is kept";
    void* first = pool_take(777);
    pool_give_back(first, 777);
    void* second = pool_take(780);
    EXPECT_EQ(first, second) << "of one size";
    pool_give_back(second, 780);
}

struct Thing : Pooled {
    PoolVector<int> numbers;
};

TEST(Pool, HoldsObjectsAndTheirVectors) {
    Thing* thing = new Thing;
    thing->numbers.assign(100, 5);
    EXPECT_EQ(pool_size_of(thing->numbers), pool_size(400));
    delete thing;
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// A program's own source of memory: when it is taken, what is asked of it, and what happens when it has no more. A test
// program of its own, as a source is set once for the whole process, before all else.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <new>
#include <vector>

#include "base/pool.h"
#include "firma/memory.h"
#include "scenes/room_grid.h"

namespace firma {
namespace {

struct Ledger {
    std::map<void*, std::size_t> held;
    std::size_t bytes = 0, times_taken = 0, times_given_back = 0;
    bool empty = false;  ///< has no more
    bool sound = true;
};

void* take(std::size_t bytes, std::size_t alignment, void* user) {
    Ledger& ledger = *static_cast<Ledger*>(user);
    ledger.sound = ledger.sound && alignment == alignof(std::max_align_t) && bytes > 0;
    if (ledger.empty) return nullptr;
    void* memory = std::malloc(bytes);
    ledger.held[memory] = bytes;
    ledger.bytes += bytes;
    ++ledger.times_taken;
    return memory;
}

void give_back(void* memory, std::size_t bytes, std::size_t alignment, void* user) {
    Ledger& ledger = *static_cast<Ledger*>(user);
    const auto at = ledger.held.find(memory);
    ledger.sound = ledger.sound && alignment == alignof(std::max_align_t) && at != ledger.held.end();
    if (at == ledger.held.end()) return;
    ledger.sound = ledger.sound && at->second == bytes;
    ledger.bytes -= at->second;
    ledger.held.erase(at);
    ++ledger.times_given_back;
    std::free(memory);
}

struct Start {
    Ledger other, ledger;
    bool without_take, without_give_back, first, second;
};

/// What the calls before all else came to; the first one that asks makes them.
Start& start() {
    static Start* it = [] {
        auto* s = new Start;
        s->without_take = set_memory_source({nullptr, give_back, nullptr});
        s->without_give_back = set_memory_source({take, nullptr, nullptr});
        s->first = set_memory_source({take, give_back, &s->other});
        s->second = set_memory_source({take, give_back, &s->ledger});
        return s;
    }();
    return *it;
}

class MemorySourceTest : public testing::Test {
protected:
    MemorySourceTest() : ledger(start().ledger) {}
    ~MemorySourceTest() override { EXPECT_TRUE(ledger.sound); }
    Ledger& ledger;
};

TEST_F(MemorySourceTest, IsRefusedWithoutBothFunctions) {
    EXPECT_FALSE(start().without_take);
    EXPECT_FALSE(start().without_give_back);
}

TEST_F(MemorySourceTest, TheLastOneSetBeforeTheFirstPieceServes) {
    EXPECT_TRUE(start().first);
    EXPECT_TRUE(start().second);
    pool_give_back(pool_take(100), 100);
    EXPECT_GT(ledger.times_taken, 0u);
    EXPECT_EQ(start().other.times_taken, 0u);
}

TEST_F(MemorySourceTest, IsRefusedOnceAPieceWasTaken) {
    pool_give_back(pool_take(100), 100);
    Ledger late;
    EXPECT_FALSE(set_memory_source({take, give_back, &late}));
    const std::size_t bytes = kLargestPooled + 1;
    pool_give_back(pool_take(bytes), bytes);
    EXPECT_EQ(late.times_taken, 0u);
}

TEST_F(MemorySourceTest, LargePiecesAreAskedForByThemselvesAndGivenBack) {
    const std::size_t bytes = kLargestPooled + 1, before = ledger.bytes;
    void* memory = pool_take(bytes);
    EXPECT_EQ(ledger.bytes, before + bytes);
    EXPECT_EQ(ledger.held.count(memory), 1u);
    pool_give_back(memory, bytes);
    EXPECT_EQ(ledger.bytes, before);
}

TEST_F(MemorySourceTest, SmallPiecesComeFromSlabsThatAreKept) {
    if (!kPoolKeepsSlabs) GTEST_SKIP() << "under the address sanitizer nothing is kept";
    std::vector<void*> pieces;
    const std::size_t taken = ledger.times_taken, given_back = ledger.times_given_back;
    for (int k = 0; k < 4000; ++k) pieces.push_back(pool_take(kLargestPooled));
    EXPECT_GE(ledger.times_taken - taken, 4000u / 16);
    EXPECT_LE(ledger.times_taken - taken, 4000u / 16 + 4);
    const std::size_t held = ledger.bytes, slabs = ledger.times_taken;
    for (int round = 0; round < 2; ++round) {
        for (void* piece : pieces) pool_give_back(piece, kLargestPooled);
        for (void*& piece : pieces) piece = pool_take(kLargestPooled);
    }
    for (void* piece : pieces) pool_give_back(piece, kLargestPooled);
    EXPECT_EQ(ledger.bytes, held);
    EXPECT_EQ(ledger.times_taken, slabs);
    EXPECT_EQ(ledger.times_given_back, given_back);
}

TEST_F(MemorySourceTest, NullIsOutOfMemoryAndLeavesThePoolSound) {
    ledger.empty = true;
    EXPECT_THROW(pool_take(kLargestPooled + 1), std::bad_alloc);
    std::vector<void*> pieces;
    const auto exhaust = [&] {
        for (int k = 0; k < 100000; ++k) pieces.push_back(pool_take(3000));
    };
    EXPECT_THROW(exhaust(), std::bad_alloc);
    ledger.empty = false;
    const std::size_t so_far = pieces.size();
    for (int k = 0; k < 1000; ++k) pieces.push_back(pool_take(3000));
    EXPECT_EQ(pieces.size(), so_far + 1000);
    for (void* piece : pieces) pool_give_back(piece, 3000);
}

TEST_F(MemorySourceTest, HoldsWhatAWorldIsMadeOf) {
    const std::size_t before = ledger.bytes;
    const World world = make_world(scenes::room_grid({8, 8, 1})).value();
    const std::size_t used = memory_used(world), blocks = world.statistics().bytes;
    EXPECT_GT(blocks, 100'000u);
    EXPECT_LE(blocks, used);
    EXPECT_GE(ledger.bytes - before, blocks / 2) << "the rest may lie in slabs opened before";
    EXPECT_GE(ledger.bytes, blocks);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Publishing, undoing, forgetting: by one thread. (tests/threads has several.)
#include "firma/versions.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "firma/memory.h"
#include "store/bytes_alone.h"
#include "tests/store/cratered.h"
#include "world/world_data.h"

namespace firma {
namespace {

constexpr std::size_t kEverything = std::size_t(1) << 40;

bool same(const World& a, const World& b) {
    return &a.data() == &b.data();
}

/// A building, published with so many craters.
struct Carved {
    explicit Carved(int craters, std::size_t bytes = kEverything, std::uint64_t seed = 1)
        : maker(seed), versions{test::building()}, store(versions[0], {bytes}) {
        for (int k = 0; k < craters; ++k) publish_next();
    }
    void publish_next() {
        const World before = store.current();
        versions.push_back(maker.next(before));
        EXPECT_EQ(store.publish(before, versions.back()), PublishStatus::kDone);
    }

    test::CraterMaker maker;
    std::vector<World> versions;
    WorldStore store;
};

std::vector<World> kept(const WorldStore& store) {
    std::vector<World> worlds;
    const StoreHistory history = store.history();
    for (std::uint64_t version = history.oldest; version <= history.newest; ++version)
        if (const auto world = store.at(version)) worlds.push_back(*world);
    EXPECT_EQ(worlds.size(), history.versions);
    return worlds;
}

/// What the store says of its bytes, against everything counted.
void expect_true_bytes(const WorldStore& store, std::size_t limit) {
    const StoreHistory history = store.history();
    const std::vector<World> worlds = kept(store);
    EXPECT_EQ(history.bytes, memory_used(worlds) - memory_used(worlds.back()));
    EXPECT_LE(history.bytes, limit);
}

TEST(WorldStore, ShowsWhatWasPublished) {
    Carved it(5);
    EXPECT_TRUE(same(it.store.current(), it.versions[5]));
    const StoreHistory history = it.store.history();
    EXPECT_EQ(history.oldest, it.versions[0].version());
    EXPECT_EQ(history.current, it.versions[5].version());
    EXPECT_EQ(history.newest, it.versions[5].version());
    EXPECT_EQ(history.versions, 6u);
    for (const World& version : it.versions) {
        ASSERT_TRUE(it.store.at(version.version()));
        EXPECT_TRUE(same(*it.store.at(version.version()), version));
    }
    EXPECT_FALSE(it.store.at(history.newest + 1));
}

TEST(WorldStore, UndoesAndRedoes) {
    Carved it(4);
    for (int k = 3; k >= 0; --k) {
        ASSERT_TRUE(it.store.undo());
        EXPECT_TRUE(same(it.store.current(), it.versions[std::size_t(k)]));
        EXPECT_TRUE(it.store.at(it.versions[4].version())) << "undone, not forgotten";
        expect_true_bytes(it.store, kEverything);
    }
    EXPECT_FALSE(it.store.undo());
    EXPECT_TRUE(same(it.store.current(), it.versions[0]));
    for (std::size_t k = 1; k <= 4; ++k) {
        ASSERT_TRUE(it.store.redo());
        EXPECT_TRUE(same(it.store.current(), it.versions[k]));
    }
    EXPECT_FALSE(it.store.redo());
}

TEST(WorldStore, PublishingForgetsWhatWasUndone) {
    Carved it(4);
    it.store.undo();
    it.store.undo();
    it.publish_next();
    EXPECT_FALSE(it.store.redo());
    EXPECT_EQ(it.store.history().versions, 4u);
    EXPECT_EQ(it.store.history().newest, it.versions[3].version());
    EXPECT_TRUE(same(*it.store.at(it.versions[3].version()), it.versions[5])) << "its number is used again";
    expect_true_bytes(it.store, kEverything);
}

TEST(WorldStore, TheFirstOfTwoEditorsWins) {
    Carved it(1);
    const World before = it.store.current();
    const World mine = it.maker.next(before), theirs = it.maker.next(before);
    EXPECT_EQ(it.store.publish(before, mine), PublishStatus::kDone);
    EXPECT_EQ(it.store.publish(before, theirs), PublishStatus::kStale);
    EXPECT_TRUE(same(it.store.current(), mine));
    EXPECT_EQ(it.store.history().versions, 3u);
    const World again = it.maker.next(it.store.current());
    EXPECT_EQ(it.store.publish(mine, again), PublishStatus::kDone);
    it.store.undo();
    EXPECT_EQ(it.store.publish(again, it.maker.next(again)), PublishStatus::kStale) << "undone meanwhile";
    EXPECT_TRUE(same(it.store.current(), mine));
}

TEST(WorldStore, AnEditThatDidNothingIsNotAVersion) {
    Carved it(2);
    const World before = it.store.current();
    Pose far;
    far.position = {-500, 0, 0};
    const CarveResult nothing = carve(before, make_crater(CutterShape::kRocky, 1), far);
    ASSERT_EQ(nothing.status, CarveStatus::kNothing);
    EXPECT_EQ(it.store.publish(before, nothing.world), PublishStatus::kSame);
    EXPECT_EQ(it.store.history().versions, 3u);
}

TEST(WorldStore, NumbersRise) {
    Carved it(2);
    const World before = it.store.current();
    EXPECT_EQ(it.store.publish(before, it.versions[1]), PublishStatus::kNotNewer);
    EXPECT_EQ(it.store.publish(before, it.maker.next(it.versions[1])), PublishStatus::kNotNewer) << "of equal number";
    EXPECT_TRUE(same(it.store.current(), before));
    EXPECT_EQ(it.store.history().versions, 3u);
}

TEST(WorldStore, TakesAWorldOfAnotherLineAndSaysWhatItCosts) {
    Carved it(1);
    test::CraterMaker maker(9);
    World other = test::building();
    for (int k = 0; k < 4; ++k) other = maker.next(other);
    EXPECT_EQ(it.store.publish(it.store.current(), other), PublishStatus::kDone);
    EXPECT_TRUE(same(it.store.current(), other));
    expect_true_bytes(it.store, kEverything);
    EXPECT_GE(it.store.history().bytes, memory_used(it.versions[1]));
    World back = it.versions[1];  // what it shares with the first line counts twice: too much, never too little
    while (back.version() <= other.version()) back = maker.next(back);
    EXPECT_EQ(it.store.publish(other, back), PublishStatus::kDone);
    EXPECT_GT(it.store.history().bytes, memory_used(kept(it.store)) - memory_used(back));
}

TEST(WorldStore, HistoryStaysWithinItsBytes) {
    const Carved all(40);
    const std::size_t limit = all.store.history().bytes / 3;
    Carved it(0, limit);
    scenes::Rng rng(5);
    for (int k = 0; k < 60; ++k) {
        const double what = rng.uniform();
        if (what < 0.75)
            it.publish_next();
        else if (what < 0.9)
            it.store.undo();
        else
            it.store.redo();
        expect_true_bytes(it.store, limit);
        EXPECT_TRUE(same(*it.store.at(it.store.history().current), it.store.current()));
    }
    EXPECT_GT(it.store.history().versions, 3u);
    EXPECT_LT(it.store.history().versions, 30u);
    EXPECT_FALSE(it.store.at(it.versions[0].version()));
    EXPECT_GT(it.store.history().bytes, limit / 2) << "no more is dropped than must be";
}

TEST(WorldStore, KeepsAlmostExactlyWhatItsBytesAllow) {
    Carved it(20);
    const std::size_t all = it.store.history().bytes;
    it.store.set_history_bytes(all);
    EXPECT_EQ(it.store.history().versions, 21u);
    it.store.set_history_bytes(all - 1);
    EXPECT_EQ(it.store.history().versions, 20u);
    EXPECT_EQ(it.store.history().oldest, it.versions[1].version());
    for (int k = 0; k < 5; ++k) it.store.undo();
    it.store.set_history_bytes(0);
    EXPECT_EQ(it.store.history().versions, 1u);
    EXPECT_EQ(it.store.history().bytes, 0u);
    EXPECT_TRUE(same(it.store.current(), it.versions[15]));
    EXPECT_FALSE(it.store.undo() || it.store.redo());
    it.publish_next();
    EXPECT_EQ(it.store.history().versions, 1u);
    EXPECT_TRUE(same(it.store.current(), it.versions.back()));
}

TEST(WorldStore, UndoneVersionsGoAfterOldOnes) {
    Carved it(6);
    for (int k = 0; k < 3; ++k) it.store.undo();
    std::size_t three_pairs = 0;
    for (std::size_t k = 3; k < 6; ++k) three_pairs += bytes_alone(it.versions[k], it.versions[k + 1]);
    it.store.set_history_bytes(three_pairs);
    EXPECT_EQ(it.store.history().oldest, it.versions[3].version());
    EXPECT_EQ(it.store.history().newest, it.versions[6].version());
    it.store.set_history_bytes(three_pairs - 1);
    EXPECT_EQ(it.store.history().newest, it.versions[5].version());
}

/// Notes which thread a version ends in.
struct Ends {
    std::vector<std::thread::id> threads;

    World world(std::uint64_t version) {
        auto* data = new WorldData;
        data->version = version;
        return World(std::shared_ptr<const WorldData>(data, [this](const WorldData* ended) {
            threads.push_back(std::this_thread::get_id());
            delete ended;
        }));
    }
};

TEST(WorldStore, DroppedVersionsEndWithTheEditorNotWithTheReader) {
    Ends ends;
    WorldStore store(ends.world(1), {0});
    std::optional<World> held = store.current();
    EXPECT_EQ(store.publish(*held, ends.world(2)), PublishStatus::kDone);
    EXPECT_EQ(store.history().versions, 1u);
    EXPECT_EQ(store.history().waiting, 1u);
    std::thread reader([&] {
        EXPECT_EQ(held->version(), 1u);
        held.reset();
    });
    const std::thread::id reader_id = reader.get_id();
    reader.join();
    EXPECT_TRUE(ends.threads.empty()) << "the reader was the last to hold it";
    EXPECT_EQ(store.collect(), 0u);
    ASSERT_EQ(ends.threads.size(), 1u);
    EXPECT_EQ(ends.threads[0], std::this_thread::get_id());
    EXPECT_NE(ends.threads[0], reader_id);
    EXPECT_EQ(store.publish(store.current(), ends.world(3)), PublishStatus::kDone);
    EXPECT_EQ(store.publish(store.current(), ends.world(4)), PublishStatus::kDone);
    EXPECT_EQ(ends.threads.size(), 2u) << "the second ended, the third was in the editor's hands until now";
}

TEST(WorldStore, AVersionDroppedTwiceEndsOnce) {
    Ends ends;
    WorldStore store(ends.world(1));
    EXPECT_EQ(store.publish(store.current(), ends.world(2)), PublishStatus::kDone);
    std::optional<World> second = store.current();
    store.undo();
    EXPECT_EQ(store.publish(store.current(), *second), PublishStatus::kDone) << "once more";
    EXPECT_EQ(store.current().version(), 2u);
    store.undo();
    EXPECT_EQ(store.publish(store.current(), ends.world(5)), PublishStatus::kDone);
    EXPECT_EQ(store.collect(), 1u);
    EXPECT_TRUE(ends.threads.empty());
    second.reset();
    EXPECT_EQ(store.collect(), 0u);
    EXPECT_EQ(ends.threads.size(), 1u);
}

TEST(WorldStore, ResetBeginsAnew) {
    Ends ends;
    {
        WorldStore store(ends.world(7));
        EXPECT_EQ(store.publish(store.current(), ends.world(8)), PublishStatus::kDone);
        EXPECT_EQ(store.publish(store.current(), ends.world(9)), PublishStatus::kDone);
        store.undo();
        store.reset(ends.world(1));
        EXPECT_EQ(ends.threads.size(), 3u);
        EXPECT_EQ(store.current().version(), 1u);
        EXPECT_EQ(store.history().versions, 1u);
        EXPECT_EQ(store.history().bytes, 0u);
        EXPECT_FALSE(store.undo() || store.redo());
        EXPECT_EQ(store.publish(store.current(), ends.world(2)), PublishStatus::kDone);
        store.reset(store.current());
        EXPECT_EQ(store.current().version(), 2u);
    }
    EXPECT_EQ(ends.threads.size(), 5u);
}

}  // namespace
}  // namespace firma

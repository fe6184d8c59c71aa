// SPDX-License-Identifier: MIT
// Readers and editors at one WorldStore: to be run under the thread sanitizer. Many more cuts:
// tests/full/full_store.cpp.
#include <gtest/gtest.h>

#include "tests/threads/store_race.h"

namespace firma {
namespace {

TEST(StoreThreads, ReadersGetWhatTheirVersionAnswersAlone) {
    constexpr int kCuts = 60;
    const test::StoreRace race = test::run_store_race(kCuts, 1);
    EXPECT_EQ(race.wrong, 0u);
    EXPECT_GT(race.records.size(), 1000u);
    EXPECT_GT(race.versions_read, 5u);
    EXPECT_EQ(race.history.newest, race.records.back().version);
    EXPECT_GT(race.history.oldest, race.records.front().version) << "history was dropped";
    EXPECT_LT(race.history.versions, std::size_t(kCuts / 2));
    EXPECT_EQ(race.history.waiting, 0u);
}

TEST(StoreThreads, EditorsAtOnceLoseNothing) {
    constexpr int kEditors = 2, kCuts = 12;
    WorldStore store(test::building(), {0});
    const std::uint64_t first = store.current().version();
    std::atomic<int> stale = 0;
    std::vector<std::thread> editors;
    for (int k = 0; k < kEditors; ++k)
        editors.emplace_back([&, k] {
            test::CraterMaker maker(std::uint64_t(k) + 1);
            for (int cut = 0; cut < kCuts;) {
                const World before = store.current();
                if (store.publish(before, maker.next(before)) == PublishStatus::kDone)
                    ++cut;
                else
                    ++stale;
            }
        });
    for (std::thread& editor : editors) editor.join();
    EXPECT_EQ(store.current().version(), first + kEditors * kCuts);
    EXPECT_FALSE(check_world(store.current()));
    EXPECT_EQ(store.collect(), 0u);
    RecordProperty("stale", stale);
}

}  // namespace
}  // namespace firma

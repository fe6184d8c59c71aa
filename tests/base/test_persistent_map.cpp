// SPDX-License-Identifier: MIT
#include "base/persistent_map.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/random.h"

namespace firma {
namespace {

using Map = PersistentMap<std::uint64_t>;

std::map<std::uint32_t, std::uint64_t> entries_of(const Map& map) {
    std::map<std::uint32_t, std::uint64_t> entries;
    std::uint32_t last = 0;
    map.for_each([&](std::uint32_t key, std::uint64_t value) {
        EXPECT_TRUE(entries.empty() || key > last) << "in order";
        last = key;
        entries[key] = value;
    });
    return entries;
}

TEST(PersistentMap, IsEmptyAtFirst) {
    const Map map;
    EXPECT_EQ(map.size(), 0u);
    EXPECT_EQ(map.find(0), nullptr);
    EXPECT_EQ(map.find(~0u), nullptr);
    EXPECT_TRUE(entries_of(map).empty());
}

TEST(PersistentMap, EachVersionKeepsWhatItHeld) {
    Random random(7);
    std::vector<Map> versions(1);
    std::vector<std::map<std::uint32_t, std::uint64_t>> expected(1);
    for (int k = 0; k < 600; ++k) {
        const int bits = int(random.next() % 33);
        const auto key = std::uint32_t(bits == 0 ? 0 : random.next() >> (64 - bits));
        const std::uint64_t value = random.next();
        Map next = versions.back();
        next.set(key, value);
        auto entries = expected.back();
        entries[key] = value;
        versions.push_back(next);
        expected.push_back(entries);
    }
    for (std::size_t k = 0; k < versions.size(); k += 7) {
        EXPECT_EQ(versions[k].size(), expected[k].size());
        EXPECT_EQ(entries_of(versions[k]), expected[k]);
        for (const auto& [key, value] : expected.back()) {
            const std::uint64_t* found = versions[k].find(key);
            const auto known = expected[k].find(key);
            ASSERT_EQ(found != nullptr, known != expected[k].end());
            EXPECT_TRUE(!found || *found == known->second);
        }
    }
}

TEST(PersistentMap, UnsharedPagesHoldAllThatDiffers) {
    Map before;
    for (std::uint32_t key = 0; key < 20000; ++key) before.set(3 * key, key);
    Map after = before;
    const std::set<std::uint32_t> changed{0, 3, 299, 30000, 59997, 4000000000u};
    for (const std::uint32_t key : changed) after.set(key, 77);
    std::set<std::uint32_t> seen;
    std::size_t told = 0;
    const auto look = [&](std::uint32_t key, const std::uint64_t* mine, const std::uint64_t* its) {
        ++told;
        if (!mine || !its || *mine != *its) seen.insert(key);
    };
    before.for_each_unshared(after, look);
    EXPECT_EQ(seen, changed);
    EXPECT_LE(told, 32 * changed.size());
    told = 0;
    after.for_each_unshared(before, look);
    EXPECT_LE(told, 32 * changed.size());
    told = 0;
    after.for_each_unshared(after, look);
    EXPECT_EQ(told, 0u);
    Map().for_each_unshared(before, [&](std::uint32_t, const std::uint64_t* mine, const std::uint64_t*) {
        EXPECT_EQ(mine, nullptr);
        ++told;
    });
    EXPECT_EQ(told, before.size());
}

TEST(PersistentMap, SettingOneValueCopiesFewPages) {
    Map map;
    for (std::uint32_t key = 0; key < 10000; ++key) map.set(key, key);
    std::set<const void*> seen;
    const auto is_new = [&](const void* page) { return seen.insert(page).second; };
    const std::size_t all = map.bytes(is_new);
    Map next = map;
    next.set(5000, 1);
    EXPECT_LT(100 * next.bytes(is_new), all);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// The scratch map against the standard one.
#include "base/flat_map.h"

#include <gtest/gtest.h>

#include <map>

#include "base/random.h"

namespace firma {
namespace {

/// Fills a map with keys that repeat, and compares it with another way of doing so.
void expect_same_as_standard(FlatMap& map, std::uint64_t seed, std::uint64_t keys) {
    std::map<std::uint64_t, std::uint32_t> known;
    for (std::uint32_t k = 0; k < 3000; ++k) {
        const std::uint64_t key = mix_bits(seed + k) % keys;
        std::uint32_t& value = map.at(key);
        const auto [entry, is_new] = known.try_emplace(key, k);
        ASSERT_EQ(value == FlatMap::kNone, is_new);
        if (is_new) value = k;
        ASSERT_EQ(value, entry->second);
    }
    EXPECT_EQ(map.size(), known.size());
    for (std::uint64_t key = 0; key < keys; ++key) {
        const auto entry = known.find(key);
        ASSERT_EQ(map.find(key), entry == known.end() ? FlatMap::kNone : entry->second);
    }
}

TEST(FlatMap, FindsWhatWasPutIn) {
    FlatMap map;
    EXPECT_EQ(map.find(7), FlatMap::kNone);
    for (const std::uint64_t keys : {40, 900, 20000}) {
        map.clear();
        expect_same_as_standard(map, keys, keys);
    }
}

TEST(FlatMap, ReservingChangesNothingButTheTimeItTakes) {
    FlatMap map;
    for (const std::size_t room : {0, 1, 64, 5000}) {
        map.clear();
        map.reserve(room);
        EXPECT_EQ(map.size(), 0u);
        expect_same_as_standard(map, room, 900);
        map.reserve(100000);  // too late: keeps what there is
        EXPECT_NE(map.find(mix_bits(room) % 900), FlatMap::kNone);
    }
}

/// Keys that all fall into one part of the table, were they only mixed.
TEST(FlatMap, NobodyCanChooseKeysThatLieTogether) {
    constexpr std::uint64_t kPlaces = 1 << 13;
    FlatMap map;
    std::uint32_t count = 0;
    for (std::uint64_t key = 0; count < 4000; ++key)
        if ((mix_bits(key) & (kPlaces - 1)) < 64) map.at(key) = count++;
    EXPECT_LT(map.longest_search(), 400u);  // 3,900 without the seed; 70 is a long one
}

}  // namespace
}  // namespace firma

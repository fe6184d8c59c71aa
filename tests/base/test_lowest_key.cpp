// SPDX-License-Identifier: MIT
// The lowest of many numbers, against a plain search.
#include "base/lowest_key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace firma {
namespace {

TEST(LowestKey, LikeAPlainSearch) {
    std::mt19937 rng(1);
    LowestKey lowest;
    for (const std::uint32_t count : {1u, 3u, 16u, 17u, 100u}) {
        lowest.reset(count);
        std::vector<double> keys(count, LowestKey::kNone);
        EXPECT_EQ(lowest.find(), UINT32_MAX);
        for (int round = 0; round < 3000; ++round) {
            const std::uint32_t index = rng() % count, value = rng() % 24;
            keys[index] = value < 16 ? double(value) : LowestKey::kNone;
            lowest.set(index, keys[index]);
            const auto best = std::min_element(keys.begin(), keys.end());
            ASSERT_EQ(lowest.find(), *best == LowestKey::kNone ? UINT32_MAX : std::uint32_t(best - keys.begin()));
        }
    }
}

}  // namespace
}  // namespace firma

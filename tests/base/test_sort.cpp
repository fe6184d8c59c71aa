// SPDX-License-Identifier: MIT
// The module's sort against the standard library's.
#include "base/sort.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

TEST(Sort, AHeapSortIsASort) {
    scenes::Rng rng(1);
    for (std::size_t count = 0; count < 200; ++count) {
        const std::uint32_t most = 1 + rng.below(1000);  // with few numbers many are equal
        std::vector<std::uint32_t> numbers(count);
        for (std::uint32_t& number : numbers) number = rng.below(most);
        std::vector<std::uint32_t> sorted = numbers, by_heap = numbers, by_range = numbers;
        std::sort(sorted.begin(), sorted.end());
        heap_sort(std::span(by_heap), std::less<>());
        EXPECT_EQ(by_heap, sorted);
        sort_range(by_range);
        EXPECT_EQ(by_range, sorted);
        std::reverse(sorted.begin(), sorted.end());
        heap_sort(std::span(by_heap), std::greater<>());  // of what is sorted the other way
        EXPECT_EQ(by_heap, sorted);
    }
}

TEST(Sort, MovesWhatItSorts) {
    scenes::Rng rng(2);
    std::vector<std::string> words(100);
    for (std::string& word : words) word = std::string(20, 'a') + std::to_string(rng.below(50));
    std::vector<std::string> sorted = words;
    std::sort(sorted.begin(), sorted.end());
    heap_sort(std::span(words), std::less<>());
    EXPECT_EQ(words, sorted);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Bins divided by surface area against all planes tried one by one, also where centres are a few steps apart.
#include "index/split_bin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

constexpr int kBuckets = 16;

/// Of items that are looked at eight at a time.
double count_by_eights(std::size_t count, std::size_t all) {
    return all > 8 ? std::ceil(double(count) / 8) : double(count);
}

/// The least cost of all planes that no centre lies at but for rounding; negative when there is none.
/// @param apart  set to whether centres differ at all
double least_cost(const std::vector<BuildItem>& items, bool& apart) {
    double least = -1;
    apart = false;
    for (int axis = 0; axis < 3; ++axis) {
        std::int64_t low = items[0].centre(axis), high = low;
        for (const BuildItem& item : items) {
            low = std::min(low, item.centre(axis));
            high = std::max(high, item.centre(axis));
        }
        apart = apart || low < high;
        for (int plane = 1; plane < kBuckets; ++plane) {
            GridBox boxes[2];
            std::size_t counts[2] = {0, 0};
            bool sure = true;
            for (const BuildItem& item : items) {
                const double at = double(item.centre(axis) - low) * kBuckets / double(high - low);
                sure = sure && std::fabs(at - plane) > 0x1p-12;
                const bool right = at > plane;
                boxes[right].add(item.box);
                ++counts[right];
            }
            if (!sure || counts[0] == 0 || counts[1] == 0) continue;
            const double cost = boxes[0].half_area() * count_by_eights(counts[0], items.size()) +
                                boxes[1].half_area() * count_by_eights(counts[1], items.size());
            if (least < 0 || cost < least) least = cost;
        }
    }
    return least;
}

TEST(SplitBin, TakesThePlaneOfLeastCost) {
    scenes::Rng rng(3);
    for (int k = 0; k < 4000; ++k) {
        const std::size_t count = 2 + rng.below(40);
        const int shift = int(rng.below(28));
        const std::int32_t spread = std::int32_t(1) << shift;
        std::vector<BuildItem> items(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            items[i].face = i;
            for (int axis = 0; axis < 3; ++axis) {
                const auto low = std::int32_t(rng.below(std::uint32_t(spread)));
                const auto extent = std::int32_t(rng.below(4 * std::uint32_t(spread)));
                items[i].box.low[axis] = low - extent;  // centres are as near as that, boxes overlap
                items[i].box.high[axis] = low + extent + std::int32_t(rng.below(2));
            }
        }
        GridBox around;
        for (const BuildItem& item : items) around.add(item.box);
        EXPECT_EQ(box_around(items), around);
        bool apart;
        const double least = least_cost(items, apart);
        const std::size_t left = split_by_area(items, around);
        ASSERT_EQ(left > 0, apart);
        ASSERT_LT(left, count);
        if (!apart) continue;
        GridBox boxes[2], centres[2];
        for (std::size_t i = 0; i < count; ++i) {
            boxes[i >= left].add(items[i].box);
            GridPoint centre;
            for (int axis = 0; axis < 3; ++axis) centre[axis] = std::int32_t(items[i].centre(axis));
            centres[i >= left].add(centre);
        }
        EXPECT_TRUE(centres[0].high.x < centres[1].low.x || centres[0].high.y < centres[1].low.y ||
                    centres[0].high.z < centres[1].low.z);
        if (least >= 0) {
            EXPECT_LE(boxes[0].half_area() * count_by_eights(left, count) +
                          boxes[1].half_area() * count_by_eights(count - left, count),
                      least * (1 + 1e-5));
        }
        std::sort(items.begin(), items.end(), [](const BuildItem& a, const BuildItem& b) { return a.face < b.face; });
        for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(items[i].face, i);
    }
}

/// A cube of two steps.
BuildItem cube_at(std::uint32_t face, std::int32_t x, std::int32_t y, std::int32_t z) {
    return {{{x - 1, y - 1, z - 1}, {x + 1, y + 1, z + 1}}, face};
}

TEST(SplitBin, PartsFewItemsOnlyWhereTheyLieApart) {
    std::vector<BuildItem> items;
    for (std::int32_t k = 0; k < 8; ++k)  // two heaps of four, mixed
        items.push_back(cube_at(std::uint32_t(k), k % 2 * 1000 + k, -k, k));
    ASSERT_EQ(split_apart(items, box_around(items), 0.55), 4u);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(items[k].face % 2, k / 4) << k;
    // Boxes of 10 x 8 x 10 and 8 steps or less, in one of 1009 x 9 x 9 across: far less than a hundredth.
    EXPECT_GT(split_apart(items, box_around(items), 0.03), 0u);
    EXPECT_EQ(split_apart(items, box_around(items), 0.001), 0u);

    items.clear();  // a cube of eight beside each other: halves have two thirds of its surface each
    for (std::int32_t k = 0; k < 8; ++k)
        items.push_back(cube_at(std::uint32_t(k), k % 2 * 2, k / 2 % 2 * 2, k / 4 * 2));
    EXPECT_EQ(split_apart(items, box_around(items), 1.3), 0u);
    EXPECT_EQ(split_apart(items, box_around(items), 1.4), 4u);

    items.assign(8, cube_at(0, 5, 5, 5));  // no plane parts them
    EXPECT_EQ(split_apart(items, box_around(items), 100), 0u);
}

}  // namespace
}  // namespace firma

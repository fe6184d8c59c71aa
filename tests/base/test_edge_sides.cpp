// SPDX-License-Identifier: MIT
// Sides of random faces, gathered by edge: all are there, by edge, each edge once, in the order in which they came.
#include "base/edge_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "scenes/rng.h"

namespace firma {
namespace {

TEST(EdgeSides, KnowTheirWay) {
    const EdgeSide up(2, 5, 7), down(5, 2, 8);
    EXPECT_TRUE(up.upward && up.low == 2 && up.high == 5 && up.owner == 7);
    EXPECT_TRUE(!down.upward && down.low == 2 && down.high == 5 && down.owner == 8);
}

TEST(EdgeSides, AreGatheredInOrder) {
    scenes::Rng rng(1);
    for (const std::uint32_t points : {2u, 5u, 60u}) {
        std::vector<EdgeSide> sides;
        while (sides.size() < 300) {
            const std::uint32_t from = rng.below(points), to = rng.below(points);
            if (from != to) sides.emplace_back(from, to, std::uint32_t(sides.size()));
        }
        std::vector<EdgeSide> sorted = sides;
        sort_sides(sorted, points);
        const auto key = [](const EdgeSide& side) { return std::tuple(side.low, side.high, side.owner); };
        std::sort(sides.begin(), sides.end(), [&](const EdgeSide& a, const EdgeSide& b) { return key(a) < key(b); });
        std::size_t place = 0;
        std::tuple<std::uint32_t, std::uint32_t> last{0, 0};
        for_each_edge(sorted, [&](std::span<const EdgeSide> edge) {
            EXPECT_GT(std::tuple(edge[0].low, edge[0].high), last);
            last = {edge[0].low, edge[0].high};
            for (const EdgeSide& side : edge) {
                EXPECT_EQ(key(side), key(sides[place]));
                EXPECT_EQ(side.upward, sides[place++].upward);
                EXPECT_EQ(std::tuple(side.low, side.high), last);
            }
        });
        EXPECT_EQ(place, sides.size());
    }
}

TEST(EdgeSides, OfNothing) {
    std::vector<EdgeSide> none;
    sort_sides(none, 0);
    for_each_edge(none, [](std::span<const EdgeSide>) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace firma

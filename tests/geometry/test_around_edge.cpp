// SPDX-License-Identifier: MIT
// Half planes around a line, by hand; pair_sides() in tests/level/test_find_solids.cpp compares random ones with
// angles.
#include "geometry/around_edge.h"

#include <gtest/gtest.h>

#include <vector>

namespace firma {
namespace {

/// Half planes known by eighths of a turn; two with a distance of eight are one half plane by two names.
struct Eighths final : SpokeAngles {
    static std::uint32_t between(std::uint32_t a, std::uint32_t b) { return (b + 8 - a % 8) % 8; }
    int turn(std::uint32_t a, std::uint32_t b) const override {
        const std::uint32_t by = between(a, b);
        return by % 4 == 0 ? 0 : by < 4 ? 1 : -1;
    }
    bool same_half(std::uint32_t a, std::uint32_t b) const override { return between(a, b) == 0; }
};

constexpr bool kAir = true, kSolid = false;

std::vector<std::uint32_t> owners(const std::vector<Spoke>& spokes) {
    std::vector<std::uint32_t> order;
    for (const Spoke& spoke : spokes) order.push_back(spoke.owner);
    return order;
}

TEST(AroundEdge, SortsFromTheFirstOn) {
    std::vector<Spoke> spokes = {
        {6, 0, kSolid, kAir}, {1, 1, kSolid, kAir}, {7, 2, kAir, kSolid}, {2, 3, kAir, kSolid}};
    EXPECT_TRUE(sort_spokes(spokes, Eighths()));
    EXPECT_EQ(owners(spokes), (std::vector<std::uint32_t>{0, 2, 1, 3}));
}

TEST(AroundEdge, OppositeOnesAndPortals) {
    std::vector<Spoke> two = {{3, 0, kSolid, kAir}, {7, 1, kAir, kSolid}};
    EXPECT_TRUE(sort_spokes(two, Eighths()));
    std::vector<Spoke> portal = {{3, 0, kSolid, kAir}, {7, 1, kAir, kSolid}, {5, 2, kAir, kAir}};
    EXPECT_TRUE(sort_spokes(portal, Eighths()));
    EXPECT_EQ(owners(portal), (std::vector<std::uint32_t>{0, 2, 1}));
    portal[1].plane = 1;  // into the solid
    EXPECT_FALSE(sort_spokes(portal, Eighths()));
    std::vector<Spoke> alone = {{0, 0, kAir, kAir}};
    EXPECT_TRUE(sort_spokes(alone, Eighths())) << "a portal's rim that hangs in the air";
    alone[0].air_before = kSolid;
    EXPECT_FALSE(sort_spokes(alone, Eighths()));
}

TEST(AroundEdge, OneOnAnotherIsUnsound) {
    std::vector<Spoke> spokes = {{3, 5, kSolid, kAir}, {11, 4, kAir, kSolid}};
    EXPECT_FALSE(sort_spokes(spokes, Eighths())) << "of one angle by two names";
    EXPECT_EQ(owners(spokes), (std::vector<std::uint32_t>{4, 5}));
    spokes[1].plane = spokes[0].plane;
    EXPECT_FALSE(sort_spokes(spokes, Eighths()));
}

}  // namespace
}  // namespace firma

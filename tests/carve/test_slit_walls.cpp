// SPDX-License-Identifier: MIT
// Walls that something touches along an edge alone, opened there: their faces have this edge there and back.
#include <gtest/gtest.h>

#include <algorithm>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/rooms.h"
#include "scenes/contact_families.h"
#include "scenes/level_cuts.h"
#include "tests/brush/unprotected_world.h"
#include "tests/carve/cutters.h"
#include "tests/openarena_maps.h"
#include "tests/world/matter_levels.h"

namespace firma {
namespace {

/// Two rooms on top of each other, with a slab between z = 4 and 4.5.
World two_floors() {
    using map_text::box;
    return test::brush_world(box({-1, -1, -1}, {9, 9, 0}) + box({-1, -1, 8}, {9, 9, 9}) + box({-1, -1, 0}, {0, 9, 8}) +
                             box({8, -1, 0}, {9, 9, 8}) + box({0, -1, 0}, {8, 0, 8}) + box({0, 8, 0}, {8, 9, 8}) +
                             box({0, 0, 4}, {8, 8, 4.5}));
}

/// A bar along y whose ridge is at the top, from 0 to `length`.
Cutter ridge(double length) {
    const std::vector<Vec3> vertices{{-0.5, 0, -0.5},      {0.5, 0, -0.5},      {0, 0, 0},
                                     {-0.5, length, -0.5}, {0.5, length, -0.5}, {0, length, 0}};
    const std::vector<CutterTriangle> triangles{{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                                                {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
    return make_cutter(vertices, triangles).value();
}

std::string fault_of(const World& world) {
    if (const auto fault = check_world(world)) return fault->what;
    if (const auto fault = check_solid(world)) return fault->what;
    return "";
}

/// Right-angled: a side at x = 0 that looks inward, a floor, and a slope down from the edge at the top. Its length
/// along y is 2, its height and width are 1.
Cutter wedge() {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 2, 0}, {1, 2, 0}, {0, 2, 1}};
    const std::vector<CutterTriangle> triangles{{0, 1, 2}, {3, 5, 4}, {0, 2, 5}, {0, 5, 3},
                                                {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}};
    return make_cutter(vertices, triangles).value();
}

CarveResult open_slab(const World& world, double from, double to) {
    return carve(world, test::box_mesh({3, from, 4}, {5, to, 4.5}).cutter().value(), {});
}

TEST(SlitWalls, AreOpenedWhereARidgeTouchesThem) {
    // The ridge is from 2 to 6. Where along it the slab is opened before, and after.
    struct Case {
        double before, from, to;
    };
    for (const Case& it : {Case{0, 1, 3},
                           {0, 5, 7},
                           {0, 3, 5},
                           {0, 1, 7},
                           {0, 2, 6},
                           {3, 3, 4},
                           {3, 3, 6},
                           {3, 3, 7},
                           {2, 2, 4},
                           {3, 4, 7}}) {
        World world = two_floors();
        ASSERT_EQ(world.room_count(), 3u);
        if (it.before > 0) world = open_slab(world, 1, it.before).world;
        const CarveResult filled = fill(world, ridge(4), test::pose_at(4, 2, 4));
        ASSERT_TRUE(filled.done()) << filled.error.text();
        ASSERT_EQ(fault_of(filled.world), "");
        const CarveResult cut = open_slab(filled.world, it.from, it.to);
        ASSERT_TRUE(cut.done()) << cut.error.text();
        EXPECT_EQ(fault_of(cut.world), "") << it.before << " then " << it.from << " to " << it.to;
    }
}

// What touches a pit along an edge alone is a room of its own: its side goes on in the plane of the pit's, and looks
// into other air. Found by full_contact, seed 5, case 1 in islandctf.
TEST(SlitWalls, ACavityAlongTheEdgeOfAPitKeepsItsSides) {
    using map_text::box;
    World world =
        test::brush_world(box({-1, -1, -8}, {9, 9, 0}) + box({-1, -1, 8}, {9, 9, 9}) + box({-1, -1, 0}, {0, 9, 8}) +
                          box({8, -1, 0}, {9, 9, 8}) + box({0, -1, 0}, {8, 0, 8}) + box({0, 8, 0}, {8, 9, 8}));
    const std::uint32_t rooms = world.room_count();
    world = carve(world, test::box_mesh({2, 2, -2}, {4, 4, 1}).cutter().value(), {}).world;
    ASSERT_EQ(fault_of(world), "");
    for (const double y : {2, 3, 1}) {
        const CarveResult cut = carve(world, wedge(), test::pose_at(2, y, -3));
        ASSERT_TRUE(cut.done()) << cut.error.text();
        EXPECT_EQ(fault_of(cut.world), "") << y;
        EXPECT_EQ(cut.world.room_count(), rooms + 1) << y;
    }
}

// A ceiling that the tip of a gear had come to touch, opened up to it: the side along the tip was taken for a part of
// the side before it. Found by full_contact, seed 2, case 3.
TEST(SlitWalls, TheTipOfAGearUnderACeiling) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    const auto map = std::find_if(maps.begin(), maps.end(), [](const auto& path) { return path.stem() == "kaos2"; });
    if (map == maps.end()) GTEST_SKIP() << kNoOpenArena;
    World world = test::unprotected_world(read_brush_level(map->string()).value(), false);
    const auto cuts = scenes::contact_cuts(scenes::cut_places(world).inside, 2, 3);
    ASSERT_GE(cuts.size(), 11u);
    for (std::size_t k = 0; k < 11; ++k) {
        const scenes::CutOrder& cut = cuts[k];
        world = (cut.kind == CarveKind::kFill ? fill(world, cut.cutter, cut.pose) : carve(world, cut.cutter, cut.pose))
                    .world;
    }
    EXPECT_EQ(fault_of(world), "");
    EXPECT_EQ(portal_count(world), 57u);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Rooms where the author placed no portals: doors are found where they are, and what comes out is sound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/rooms.h"
#include "scenes/brush_piles.h"
#include "tests/brush/casts_agree.h"
#include "tests/brush/depot_level.h"
#include "tests/sample.h"

namespace firma {
namespace {

constexpr std::int32_t kInputMetre = 4096;

void add_box(BrushLevel& level, const Vec3& low, const Vec3& high, BrushKind kind = BrushKind::kSolid) {
    std::int32_t from[3], to[3];
    for (int axis = 0; axis < 3; ++axis) {
        from[axis] = std::int32_t(std::floor(low[axis] * kInputMetre));
        to[axis] = std::int32_t(std::floor(high[axis] * kInputMetre));
    }
    scenes::add_box(level, from, to, kind);
}

BrushLevel empty_level() {
    BrushLevel level;
    level.name = "made";
    level.materials = {"", "wall", "floor"};
    level.entities.resize(1);
    return level;
}

/// A storey of 3 m, a character a square metre: '#' is wall, 'd' a doorway of 2 m, anything else air. The first line is
/// the northernmost; y = 0 is below the last one.
BrushLevel storey(const std::vector<std::string>& plan) {
    BrushLevel level = empty_level();
    const auto rows = double(plan.size()), columns = double(plan[0].size());
    add_box(level, {0, 0, -1}, {columns, rows, 0});
    add_box(level, {0, 0, 3}, {columns, rows, 4});
    for (std::size_t row = 0; row < plan.size(); ++row)
        for (std::size_t from = 0, to = 0; from < plan[row].size(); from = to) {
            for (to = from; to < plan[row].size() && plan[row][to] == plan[row][from];) ++to;
            const double y = rows - 1 - double(row), floor = plan[row][from] == 'd' ? 2 : 0;
            if (plan[row][from] == '#' || plan[row][from] == 'd')
                add_box(level, {double(from), y, floor}, {double(to), y + 1, 3});
        }
    return level;
}

struct Divided {
    BrushLevel level;
    DivideReport report;
    BrushWorldReport joined;
    World world;
};

/// Divides a level, makes its world, and checks what is true of every level.
Divided divide(const BrushLevel& level, const DivideOptions& options = {}) {
    Divided made;
    const Result<BrushLevel> divided = divide_rooms(level, options, &made.report);
    EXPECT_TRUE(divided.ok());
    made.level = divided.value();
    made.world = make_world(made.level, {}, &made.joined).value();
    const std::size_t authors = level.brushes.size();
    EXPECT_EQ(made.level.brushes.size(), authors + made.report.portals);
    EXPECT_GE(made.report.narrows, made.report.portals);
    for (const BrushNote& note : made.joined.notes) EXPECT_LT(note.brush, authors) << note.reason;
    const std::optional<WorldFault> fault = check_world(made.world);  // edges of every room cancel
    EXPECT_FALSE(fault) << fault->what;
    EXPECT_EQ(made.joined.lost_shells, 0u);
    return made;
}

RoomId room_at(const World& world, const Vec3& point) {
    const Location place = locate(world, point);
    EXPECT_EQ(place.where, Where::kAir) << point.x << ' ' << point.y << ' ' << point.z;
    return place.room;
}

/// The portals that lie within a box.
std::vector<PortalInfo> portals_within(const World& world, const Vec3& low, const Vec3& high) {
    std::vector<PortalInfo> within;
    for (std::uint32_t k = 0; k < portal_count(world); ++k) {
        const PortalInfo portal = *portal_info(world, {k});
        bool is_within = true;
        for (int axis = 0; axis < 3; ++axis)
            is_within &= portal.bounds.low[axis] >= low[axis] && portal.bounds.high[axis] <= high[axis];
        if (is_within) within.push_back(portal);
    }
    return within;
}

/// A hall, a doorway, a corridor that opens into a second hall, and a doorway to a corridor around a block.
const std::vector<std::string> kBuilding = {
    "###############################################",  //
    "################################              #",  //
    "################################              #",  //
    "################################  ##########  #",  //
    "################################  ##########  #",  //
    "#        ##############        #  ##########  #",  //
    "#        ##############        #  ##########  #",  //
    "#        ##############        d  ##########  #",  //
    "#        d                     #  ##########  #",  //
    "#        #                     #  ##########  #",  //
    "#        ##############        #  ##########  #",  //
    "#        ##############        #  ##########  #",  //
    "#        ##############        #              #",  //
    "################################              #",  //
    "###############################################",  //
};

TEST(DivideRooms, FindsTheDoorsOfABuilding) {
    const BrushLevel level = storey(kBuilding);
    const Divided made = divide(level);
    const World& world = made.world;
    // Between hall and corridor, and between the second hall and the ring.
    const std::vector<PortalInfo> west = portals_within(world, {9, 6, 0}, {10, 7, 2});
    ASSERT_EQ(west.size(), 1u);
    EXPECT_NEAR(west[0].bounds.high.y - west[0].bounds.low.y, 1, 1e-9);
    EXPECT_NEAR(west[0].bounds.high.z - west[0].bounds.low.z, 2, 1e-9);
    EXPECT_EQ(portals_within(world, {31, 7, 0}, {32, 8, 2}).size(), 1u);
    // The corridor's end, where it opens into the hall.
    EXPECT_EQ(portals_within(world, {21.5, 5, 0}, {23.5, 7, 3}).size(), 1u);

    const RoomId hall = room_at(world, {5, 5, 1}), corridor = room_at(world, {15, 6.5, 1});
    const RoomId second = room_at(world, {27, 5, 1}), ring = room_at(world, {33, 7.5, 1});
    EXPECT_EQ((std::set<RoomId>{hall, corridor, second, ring}).size(), 4u);
    EXPECT_EQ(room_at(world, {8.9, 6.5, 2.9}), hall);
    EXPECT_EQ(find_path(world, hall, second)->size(), 2u);
    EXPECT_EQ(neighbours(world, hall), std::vector<RoomId>{corridor});
    EXPECT_FALSE(room_info(world, hall)->exterior);
    EXPECT_TRUE(room_info(world, room_at(world, {5, 5, 8}))->exterior);
    expect_casts_agree(world, 1, 3000);
}

TEST(DivideRooms, NoDoorNoRooms) {
    const Divided made = divide(storey({"##########",  //
                                        "#        #",  //
                                        "#        #",  //
                                        "#        #",  //
                                        "##########"}));
    EXPECT_EQ(made.report.portals, 0u);
    EXPECT_EQ(made.world.room_count(), 2u);  // with the exterior
    EXPECT_GT(made.report.cells, 100u);
}

/// A doorway in a wall of an eighth of a metre.
TEST(DivideRooms, ThinWalls) {
    BrushLevel level = storey({"############",  //
                               "#          #",  //
                               "#          #",  //
                               "#          #",  //
                               "#          #",  //
                               "############"});
    add_box(level, {6, 1, 0}, {6.125, 2.5, 3});
    add_box(level, {6, 3.5, 0}, {6.125, 5, 3});
    const Divided made = divide(level);
    EXPECT_EQ(portals_within(made.world, {6, 2.5, 0}, {6.125, 3.5, 3}).size(), 1u);
    EXPECT_NE(room_at(made.world, {3, 3, 1}), room_at(made.world, {9, 3, 1}));
}

/// What is wide, or leads to next to nothing, divides nothing.
TEST(DivideRooms, WhatTheOptionsSay) {
    const BrushLevel level = storey({"####################",  //
                                     "#        #         #",  //
                                     "#        #         #",  //
                                     "#        d         #",  //
                                     "#        #         #",  //
                                     "##########d#########",  //
                                     "##########  ########",  //
                                     "####################"});
    const auto rooms = [&](const DivideOptions& options) { return divide(level, options).world.room_count(); };
    EXPECT_EQ(rooms({.narrow = 0.7, .min_room_volume = 10}), 3u);  // two halls and the exterior
    EXPECT_EQ(rooms({.narrow = 0.7, .min_room_volume = 1}), 4u);   // and the closet
    EXPECT_EQ(rooms({.narrow = 0.3, .min_room_volume = 1}), 3u);   // whose door is wide for its size
    EXPECT_EQ(rooms({.min_room_volume = 1000}), 2u);
    EXPECT_EQ(divide(level, {.narrow = 0.01}).report.portals, 0u);
    for (const double bad : {-1.0, double(NAN), double(INFINITY)}) {
        EXPECT_EQ(divide_rooms(level, {.narrow = bad}).error().code, ErrorCode::kInvalid);
        EXPECT_EQ(divide_rooms(level, {.min_room_volume = bad}).error().code, ErrorCode::kInvalid);
    }
    for (const std::size_t cells : {0, 1, 100, 1000, 10'000})
        EXPECT_LE(divide(level, {.max_cells = cells}).report.cells, cells);
}

/// Ten gaps in a wall divide two halls, sixteen are a fence.
TEST(DivideRooms, Fences) {
    for (const int gaps : {10, 16}) {
        BrushLevel level = storey({"###################",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "#                 #",  //
                                   "###################"});
        for (int k = 0; k < gaps; ++k) add_box(level, {9, 1 + k * 0.5, 0}, {9.5, 1.25 + k * 0.5, 3});
        add_box(level, {9, 1 + gaps * 0.5, 0}, {9.5, 9.5, 3});
        const Divided made = divide(level);
        EXPECT_EQ(made.report.portals, gaps == 10 ? 10u : 0u);
        EXPECT_EQ(made.world.room_count(), gaps == 10 ? 3u : 2u);
    }
}

/// The author's portals stay what they are, and what they leave undivided is divided further.
TEST(DivideRooms, KeepsTheAuthorsPortals) {
    BrushLevel level = storey(kBuilding);
    const std::size_t without = divide(level).world.room_count();
    level.entities.resize(2);
    level.entities[1].keys = {{"classname", "func_areaportal"}, {"targetname", "gate"}};
    add_box(level, {9.4, 5.5, -0.5}, {9.5, 7.5, 2.5}, BrushKind::kPortal);
    level.brushes.back().entity = 1;
    level.sides[level.brushes.back().first_side].portal = true;
    const Divided made = divide(level);
    EXPECT_EQ(made.world.room_count(), without);
    const std::vector<PortalInfo> door = portals_within(made.world, {9, 6, 0}, {10, 7, 2});
    ASSERT_EQ(door.size(), 1u);
    EXPECT_EQ(door[0].name, "gate");
    EXPECT_TRUE(std::equal(level.sides.begin(), level.sides.end(), made.level.sides.begin(),
                           [](const BrushSide& a, const BrushSide& b) {
                               return std::equal(a.points, a.points + 3, b.points) && a.portal == b.portal;
                           }));
}

TEST(DivideRooms, OpenToTheVoid) {
    // A house without a hull around it: the door leads outside.
    BrushLevel level = storey({"##########",  //
                               "#        #",  //
                               "#        #",  //
                               "#        d",  //
                               "#        #",  //
                               "##########"});
    const Divided house = divide(level);
    EXPECT_EQ(house.report.portals, 1u);
    EXPECT_EQ(house.world.room_count(), 2u);
    EXPECT_TRUE(room_info(house.world, room_at(house.world, {12, 2.5, 1}))->exterior);
    EXPECT_FALSE(room_info(house.world, room_at(house.world, {5, 2.5, 1}))->exterior);
    // A player outside of it changes nothing, one inside neither: the hull is open.
    for (const char* origin : {"384 80 32", "160 80 32"}) {
        level.entities.resize(2);
        level.entities[1].keys = {{"classname", "info_player_start"}, {"origin", origin}};
        EXPECT_EQ(divide(level).report.portals, 1u) << origin;
    }
}

/// Between two hulls is air that nobody gets to: with a player inside one it is left alone.
TEST(DivideRooms, OutsideOfAHull) {
    BrushLevel level = storey({"##########   ###",  //
                               "#        #   # #",  //
                               "#        ####  #",  //
                               "#        d     #",  //
                               "#        ####  #",  //
                               "#        #   # #",  //
                               "##########   ###"});
    add_box(level, {10, 0, 0}, {13, 0.5, 3});  // a yard outside, open by half a metre
    add_box(level, {10, 6.2, 0}, {13, 7, 3});
    const std::size_t all = divide(level).report.portals;
    level.entities.resize(2);
    level.entities[1].keys = {{"classname", "info_player_start"}, {"origin", "160 112 32"}};
    const Divided inside = divide(level);
    EXPECT_LE(inside.report.portals, all);
    for (std::uint32_t k = 0; k < portal_count(inside.world); ++k)
        for (const std::size_t side : {0, 1})
            EXPECT_FALSE(room_info(inside.world, portal_info(inside.world, {k})->rooms[side])->exterior);
    EXPECT_GE(inside.report.portals, 1u);
}

TEST(DivideRooms, OddLevels) {
    // Of nothing no world is made.
    const auto cells_of = [](const BrushLevel& level) {
        DivideReport report;
        EXPECT_TRUE(divide_rooms(level, {}, &report));
        return report.cells;
    };
    EXPECT_EQ(cells_of(empty_level()), 0u);
    BrushLevel block = empty_level();
    add_box(block, {0, 0, 0}, {10, 10, 10});
    EXPECT_EQ(divide(block).report.portals, 0u);
    BrushLevel portal = empty_level();
    add_box(portal, {0, 0, 0}, {1, 1, 1}, BrushKind::kPortal);
    EXPECT_EQ(cells_of(portal), 0u);

    BrushLevel corners = storey(kBuilding);  // as large as a world can be
    for (const double at : {-8191.0, 8190.0}) add_box(corners, {at, at, at}, {at + 1, at + 1, at + 1});
    const Divided large = divide(corners);
    EXPECT_GT(large.report.cells, 0u);
    EXPECT_LE(large.report.cells, DivideOptions{}.max_cells);

    BrushLevel crowd = empty_level();  // each as large as the level, on top of each other
    for (int k = 0; k < 300; ++k) add_box(crowd, {0, 0, 0}, {1000.0 + k, 1000, 1000});
    divide(crowd, {.max_cells = 100'000});

    BrushLevel dust = empty_level();
    for (int k = 0; k < 20; ++k) {
        const double at = k / 1024.0;
        add_box(dust, {at, 0, 0}, {at + 1 / 4096.0, 1 / 4096.0, 1 / 4096.0});
    }
    divide(dust);

    BrushLevel flat = storey(kBuilding);  // brushes without volume, without end, without sides
    for (const std::uint32_t sides : {5u, 0u}) {
        Brush& brush = flat.brushes.emplace_back(flat.brushes[0]);
        brush.first_side = std::uint32_t(flat.sides.size());
        brush.side_count = sides;
        for (std::uint32_t k = 0; k < sides; ++k) flat.sides.push_back(BrushSide(flat.sides[k]));
    }
    EXPECT_EQ(divide(flat).world.room_count(), divide(storey(kBuilding)).world.room_count());
}

TEST(DivideRooms, PilesOfBrushes) {
    for (int pile = 0; pile < scenes::kBrushPiles; ++pile)
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            SCOPED_TRACE(testing::Message() << "pile " << pile << ", seed " << seed);
            BrushLevel level = scenes::brush_pile(scenes::BrushPile(pile), seed, 30);
            const Result<BrushLevel> divided = divide_rooms(level, {.min_room_volume = 0.1, .max_cells = 200'000});
            ASSERT_TRUE(divided.ok());
            const World world = make_world(divided.value()).value();
            const std::optional<WorldFault> fault = check_world(world);
            EXPECT_FALSE(fault) << fault->what;
        }
}

BrushLevel without_portals(BrushLevel level) {
    for (Brush& brush : level.brushes)
        if (brush.kind == BrushKind::kPortal) brush.kind = BrushKind::kData;
    return level;
}

std::set<std::string> room_names(const World& world) {
    std::set<std::string> names;
    for (std::uint32_t k = 0; k < world.room_count(); ++k) names.emplace(room_info(world, {k})->name);
    names.erase("");
    return names;
}

TEST(DivideRooms, TheDepotWithoutItsPortals) {
    const BrushLevel level = without_portals(test::depot_level());
    const Divided made = divide(level);
    EXPECT_GE(made.world.room_count(), 20u);
    EXPECT_GE(made.report.portals, 28u);
    // What the author meant as a room is one: of two names in one room only one is left.
    EXPECT_GE(room_names(made.world).size(), 19u);
    for (const char* name : {"hall", "dock", "workshop", "director", "archive", "plan_room", "boiler_room", "passage",
                             "cave", "tunnel", "yard", "cistern"})
        EXPECT_TRUE(room_names(made.world).contains(name)) << name;
    expect_casts_agree(made.world, 3, 6000);
    EXPECT_EQ(hash_world(divide(level).world), hash_world(made.world));
}

TEST(DivideRooms, TheDepotAsItIs) {
    const BrushLevel level = test::depot_level();
    const World before = make_world(level).value();
    const Divided made = divide(level);
    EXPECT_GE(made.world.room_count(), before.room_count());
    const std::set<std::string> names = room_names(before), still = room_names(made.world);
    EXPECT_TRUE(std::includes(still.begin(), still.end(), names.begin(), names.end()));
}

TEST(DivideRooms, MapsOfOpenArena) {
    const char* folder = std::getenv("FIRMA_OPENARENA");
    int seen = 0;
    for (const char* map : test::sampled<const char*>({"kaos2", "oa_dm1", "oa_bases3", "aggressor"})) {
        const std::string path = std::string(folder == nullptr ? "" : folder) + "/" + map + ".bsp";
        if (!std::filesystem::exists(path)) continue;
        SCOPED_TRACE(map);
        ++seen;
        const Divided made = divide(read_brush_level(path).value());
        EXPECT_GE(made.report.portals, 5u);
        EXPECT_GE(made.world.room_count(), 7u);
        expect_casts_agree(made.world, 7, 2000);
    }
    if (seen == 0) GTEST_SKIP() << "FIRMA_OPENARENA names no folder of OpenArena's maps";
}

}  // namespace
}  // namespace firma

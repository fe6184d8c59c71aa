// SPDX-License-Identifier: MIT
// A level divided into rooms by portals that stand beside it.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using test::add_box;
using test::box_level;

using Portals = std::vector<LevelPortal>;

GridPoint at(double x, double y, double z) {
    return snap({x, y, z}).value();
}

/// A rectangle in y and z at x, front toward +x.
std::vector<GridPoint> wall(double x, double low_y, double low_z, double high_y, double high_z) {
    return {at(x, low_y, low_z), at(x, high_y, low_z), at(x, high_y, high_z), at(x, low_y, high_z)};
}

/// Air of 8 by 4 by 4 m in rock.
Level hall() {
    return box_level({0, 0, 0}, {8, 4, 4}, true);
}

struct Made {
    World world;
    PortalReport report;
};

Made make(const Level& level, const Portals& portals) {
    Made made;
    made.world = make_divided_world(level, portals, {}, &made.report).value();
    const auto fault = check_world(made.world);
    EXPECT_FALSE(fault) << fault->what;
    const auto solid = check_solid(made.world);
    EXPECT_FALSE(solid) << solid->what;
    return made;
}

RoomId room_at(const World& world, const Vec3& point) {
    const Location where = locate(world, point);
    EXPECT_EQ(where.where, Where::kAir) << point.x;
    return where.room;
}

double area_of(const std::vector<std::vector<Vec3>>& polygons) {
    double area = 0;
    for (const std::vector<Vec3>& polygon : polygons)
        for (std::size_t k = 2; k < polygon.size(); ++k)
            area += length(cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0])) / 2;
    return area;
}

void expect_plain(const Made& made, const Level& level) {
    const World plain = make_world(level).value();
    EXPECT_EQ(hash_world(made.world), hash_world(plain));
    EXPECT_EQ(made.world.room_count(), 1u);
    EXPECT_EQ(portal_count(made.world), 0u);
}

TEST(MakeDividedWorld, APortalDividesABox) {
    for (const double into_the_rock : {0.0, 1.0}) {
        const double low = -into_the_rock, high = 4 + into_the_rock;
        const Made made = make(hall(), {{"door", {wall(4, low, low, high, high)}}});
        EXPECT_EQ(made.report.undivided, "");
        EXPECT_TRUE(made.report.idle.empty());
        EXPECT_EQ(made.world.room_count(), 2u);
        ASSERT_EQ(portal_count(made.world), 1u);
        const PortalInfo portal = *portal_info(made.world, PortalId{0});
        EXPECT_EQ(portal.name, "door");
        EXPECT_EQ(area_of(portal_polygons(made.world, PortalId{0})), 16);
        EXPECT_EQ(portal.rooms[0], room_at(made.world, {7, 2, 2})) << "its front looks toward +x";
        EXPECT_EQ(portal.rooms[1], room_at(made.world, {1, 2, 2}));
        EXPECT_EQ(measure_solid(made.world).volume, -128);
        RoomTrail trail;
        const Hit hit = cast(made.world, {{1, 2, 2}, 0.25}, {20, 0, 0}, {.room = portal.rooms[1], .trail = &trail});
        EXPECT_EQ(trail.count, 2u);
        EXPECT_NEAR(hit.point.x, 8, 1e-9);
    }
}

TEST(MakeDividedWorld, PortalsHaveNoMaterialOfTheMesh) {
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"rock"}, {"rock", ""}, {"rock", "lead"}, {""}}) {
        Level level = hall();
        level.materials = names;
        const World world = make(level, {{"door", {wall(4, 0, 0, 4, 4)}}}).world;
        EXPECT_EQ(world.material_name(portal_info(world, PortalId{0})->material), "");
        const Hit hit = cast(world, {{1, 2, 2}, 0}, {0, 0, -9});
        EXPECT_EQ(hit.material, 0u) << "as the caller numbered it";
        EXPECT_EQ(world.material_name(hit.material), names[0]);
    }
}

TEST(MakeDividedWorld, APortalThatDoesNotCloseItsOpeningIsIdle) {
    const Made made = make(hall(), {{"door", {wall(4, 0, 0, 4, 3.5)}}, {"gate", {wall(6, 0, 0, 4, 4)}}});
    EXPECT_EQ(made.report.idle, std::vector<std::uint32_t>{0});
    EXPECT_EQ(made.report.undivided, "");
    EXPECT_EQ(made.world.room_count(), 2u);
    ASSERT_EQ(portal_count(made.world), 1u);
    EXPECT_EQ(portal_info(made.world, PortalId{0})->name, "gate");
}

// Each is cut at the other: their parts lie in the list by turns.
TEST(MakeDividedWorld, IdlePortalsThatCrossAreNamedOnce) {
    const LevelPortal along = {"along", {{at(2, 2, 1), at(6, 2, 1), at(6, 2, 3), at(2, 2, 3)}}};
    const Made made = make(hall(), {{"across", {wall(4, 1, 1, 3, 3)}}, along});
    EXPECT_EQ(made.report.idle, (std::vector<std::uint32_t>{0, 1}));
}

TEST(MakeDividedWorld, APortalMayBeGivenInTriangles) {
    const std::vector<GridPoint> whole = wall(4, 0, 0, 4, 4);
    const Made made = make(hall(), {{"", {{whole[0], whole[1], whole[2]}, {whole[0], whole[2], whole[3]}}}});
    EXPECT_EQ(made.world.room_count(), 2u);
    ASSERT_EQ(portal_count(made.world), 1u);
    EXPECT_EQ(area_of(portal_polygons(made.world, PortalId{0})), 16);
}

TEST(MakeDividedWorld, APortalInRockOrWithoutPolygonsIsNothing) {
    const Made made = make(hall(), {{"buried", {wall(-4, 0, 0, 4, 4)}}, {"none", {}}});
    EXPECT_TRUE(made.report.idle.empty());
    EXPECT_EQ(made.report.undivided, "");
    EXPECT_EQ(made.world.room_count(), 1u);
    EXPECT_EQ(portal_count(made.world), 0u);
}

TEST(MakeDividedWorld, WhereAirReachesToInfinityTheLastRoomIsTheExterior) {
    Level block = box_level({-1, -1, -1}, {9, 5, 5});
    add_box(block, {0, 0, 0}, {8, 4, 4}, true);
    const Made made = make(block, {{"door", {wall(4, 0, 0, 4, 4)}}});
    ASSERT_EQ(made.world.room_count(), 3u);
    const RoomInfo outside = *room_info(made.world, room_at(made.world, {20, 2, 2}));
    EXPECT_TRUE(outside.exterior);
    EXPECT_EQ(outside.name, "exterior");
}

TEST(MakeDividedWorld, WhatBoundsNoSolidIsCutAtPortals) {
    Level level = hall();
    test::add_polygon(level, {{2, 1, 1}, {6, 1, 1}, {6, 3, 1}, {2, 3, 1}});  // a shelf through the portal
    const Made made = make(level, {{"door", {wall(4, 0, 0, 4, 4)}}});
    const RoomId low = room_at(made.world, {1, 2, 2}), high = room_at(made.world, {7, 2, 2});
    EXPECT_NE(low, high);
    for (const auto& [x, room] : {std::pair{3.0, low}, {5.0, high}})
        EXPECT_EQ(cast(made.world, {{x, 2, 2}, 0}, {0, 0, -1.5}, {.room = room}).point.z, 1);
}

TEST(MakeDividedWorld, WithoutPortalsItIsMakeWorld) {
    const Made made = make(hall(), {});
    EXPECT_EQ(made.report.undivided, "");
    expect_plain(made, hall());
}

TEST(MakeDividedWorld, WhereNothingIsSolidThereIsOneRoom) {
    Level open = hall();
    open.faces.pop_back();
    const Made made = make(open, {{"door", {wall(4, 0, 0, 4, 4)}}});
    EXPECT_EQ(made.report.undivided, "none of its faces bounds a solid");
    expect_plain(made, open);
}

// Readers make no such level; a program may.
TEST(MakeDividedWorld, OffTheInputGridThereIsOneRoom) {
    Level level = hall();
    test::add_polygon(level, {{2, 1, 1}, {3, 1, 1}, {3, 2, 1}});
    level.vertices.back().y += 1;
    const Made made = make(level, {{"door", {wall(4, 0, 0, 4, 4)}}});
    EXPECT_EQ(made.report.undivided, "a corner of its faces is not on the input grid");
    expect_plain(made, level);
}

TEST(MakeDividedWorld, PortalsThatAreNoPolygonsAreRefused) {
    Level level = hall();
    const auto said = [&](const auto& change) {
        Portals portals = {{"door", {wall(4, 0, 0, 4, 4)}}, {"gate", {wall(6, 0, 0, 4, 4)}}};
        change(portals[1].polygons[0]);
        const Result<World> world = make_divided_world(level, portals);
        return world.ok() ? "" : world.error().text();
    };
    const std::string refused =
        "portal 1: a polygon of it is not convex and planar, of 3 to 64 corners on the input grid";
    EXPECT_EQ(said([](std::vector<GridPoint>&) {}), "");
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon.clear(); }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon.resize(65); }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { std::swap(polygon[1], polygon[2]); }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon[1].x += 64; }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) {
                  for (GridPoint& point : polygon) point.x += 1;
              }),
              refused);
    level.name = "mine";
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon.clear(); }), "mine: " + refused);
}

TEST(MakeDividedWorld, ALevelThatMakesNoWorldIsRefusedAlike) {
    Level level = hall();
    level.faces[3].material = 7;
    const Result<World> made = make_divided_world(level, Portals{{"door", {wall(4, 0, 0, 4, 4)}}});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().text(), make_world(level).error().text());
}

TEST(MakeDividedWorld, ALevelMayNameNoMaterials) {
    Level level = hall();
    level.materials.clear();
    const Portals portals = {{"door", {wall(4, 0, 0, 4, 4)}}};
    const Made made = make(level, portals);
    EXPECT_EQ(made.world.room_count(), 2u);
    level.materials = {""};
    EXPECT_EQ(hash_world(made.world), hash_world(make(level, portals).world));
}

TEST(MakeDividedWorld, TheReportIsOfThisCallAlone) {
    PortalReport report;
    const Portals floating = {{"door", {wall(4, 1, 1, 3, 3)}}};
    ASSERT_TRUE(make_divided_world(hall(), floating, {}, &report));
    ASSERT_TRUE(make_divided_world(hall(), floating, {}, &report));
    EXPECT_EQ(report.idle, std::vector<std::uint32_t>{0});
    ASSERT_TRUE(make_divided_world(hall(), {}, {}, &report));
    EXPECT_TRUE(report.idle.empty());
}

TEST(MakeDividedWorld, WhatWasCutAtAPortalIsCarved) {
    const Made made = make(hall(), {{"door", {wall(4, 0, 0, 4, 4)}}});
    const CarveResult result =
        carve(made.world, make_crater(CutterShape::kRocky, 3), {.position = {4, 0, 2}, .scale = 1}, {"fresh"});
    ASSERT_EQ(result.status, CarveStatus::kDone);
    EXPECT_FALSE(check_world(result.world));
    EXPECT_LT(measure_solid(result.world).volume, -128.5);
    EXPECT_NE(room_at(result.world, {1, 2, 2}), room_at(result.world, {7, 2, 2}));
    ASSERT_EQ(portal_count(result.world), 2u) << "the way around the portal";
    EXPECT_TRUE(portal_info(result.world, {1})->open);
}

}  // namespace
}  // namespace firma

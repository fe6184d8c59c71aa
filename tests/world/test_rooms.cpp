// SPDX-License-Identifier: MIT
// Rooms and portals: where points are, what leads where, doors.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/divided_building.h"
#include "tests/world/two_halves.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::BuildingPlan;
using scenes::DividedBuilding;

Location in_room(std::uint32_t room) {
    return {Where::kAir, {room}};
}
const Location kSolid{Where::kSolid, {}};

TEST(Rooms, PointsOfTwoHalves) {
    const World world = two_halves();
    EXPECT_EQ(check_world(world), std::nullopt);
    EXPECT_EQ(locate(world, {1, 1, 1}), in_room(0));
    EXPECT_EQ(locate(world, {7, 1, 1}), in_room(1));
    EXPECT_EQ(locate(world, {4, 1, 1}), in_room(0));  // on the portal
    EXPECT_EQ(locate(world, {4 + 1e-12, 1, 1}), in_room(1));
    EXPECT_EQ(locate(world, {4 - 1e-12, 1, 1}), in_room(0));
    EXPECT_EQ(locate(world, {1, 1, 5}), kSolid);
    EXPECT_EQ(locate(world, {1e5, 1, 5}), kSolid);
    EXPECT_EQ(locate(world, {4, 0, 1}).where, Where::kSurface);  // on the rim of the portal: on a wall
    EXPECT_EQ(locate(world, {1, 1, 0}).where, Where::kSurface);
    EXPECT_EQ(locate(world, {NAN, 1, 0}).where, Where::kUnknown);
}

TEST(Rooms, WhatTheyAre) {
    const World world = two_halves();
    const RoomInfo room = *room_info(world, {1});
    EXPECT_EQ(room.faces, 5u);
    EXPECT_EQ(room.bounds.low, (Vec3{4, 0, 0}));
    EXPECT_EQ(room.bounds.high, (Vec3{8, 4, 4}));
    EXPECT_EQ(std::vector<PortalId>(room.portals.begin(), room.portals.end()), std::vector<PortalId>{{0}});
    EXPECT_EQ(room.merged_into, RoomId{1});
    const PortalInfo portal = *portal_info(world, {0});
    EXPECT_EQ(portal.name, "door");
    EXPECT_TRUE(portal.open);
    EXPECT_EQ(portal.bounds.low, (Vec3{4, 0, 0}));
    EXPECT_EQ(portal.polygons, 1u);
    ASSERT_EQ(portal_polygons(world, {0}).size(), 1u);
    EXPECT_EQ(portal_polygons(world, {0})[0].size(), 4u);
    // What is not there is told.
    for (const std::uint32_t none : {1u, 2u, ~0u, ~0u - 1}) {
        EXPECT_EQ(portal_info(world, {none}).has_value(), false);
        EXPECT_TRUE(portal_polygons(world, {none}).empty());
        EXPECT_FALSE(set_portal_open(world, {none}, false));
        if (none == 1) continue;
        EXPECT_EQ(room_info(world, {none}).has_value(), false);
        EXPECT_TRUE(neighbours(world, {none}).empty());
        EXPECT_FALSE(find_path(world, {0}, {none}));
    }
    EXPECT_EQ(neighbours(world, {0}), std::vector<RoomId>{{1}});
}

TEST(Rooms, AClosedDoorIsAWall) {
    const World open = two_halves(), closed = *set_portal_open(open, {0}, false);
    EXPECT_EQ(closed.version(), open.version() + 1);
    EXPECT_TRUE(portal_info(open, {0})->open);
    EXPECT_FALSE(portal_info(closed, {0})->open);
    EXPECT_EQ(&closed.data().cells.room(0), &open.data().cells.room(0));
    EXPECT_EQ(set_portal_open(closed, {0}, false)->version(), closed.version());
    for (const RoomId room : {RoomId{0}, kAnyRoom, kLocateRoom}) {
        CastOptions options{.room = room};
        Hit hit = cast(open, {{1, 2, 2}, 0.5}, {10, 0, 0}, options);
        EXPECT_EQ(hit.face.id, FaceId{9});
        EXPECT_EQ(hit.portal, PortalId{});
        EXPECT_EQ(hit.fraction, 0.65);
        EXPECT_EQ(room_of(open, hit), RoomId{1});
        hit = cast(closed, {{1, 2, 2}, 0.5}, {10, 0, 0}, options);
        EXPECT_EQ(hit.status, Status::kHit);
        EXPECT_EQ(hit.portal, PortalId{0});
        EXPECT_FALSE(hit.face.valid());
        EXPECT_FALSE(closed.face(hit.face)) << "a door has no face";
        EXPECT_EQ(hit.fraction, 0.25);
        EXPECT_EQ(hit.normal, (Vec3{-1, 0, 0}));
        EXPECT_EQ(hit.material, 1u);
        EXPECT_EQ(room_of(closed, hit), RoomId{0});
        EXPECT_FALSE(room_of(World(), hit).valid());
        EXPECT_EQ(cast_any(closed, {{1, 2, 2}, 0.5}, {2.9, 0, 0}, options), Status::kHit);
        EXPECT_EQ(cast_any(open, {{1, 2, 2}, 0.5}, {2.9, 0, 0}, options), Status::kMiss);
        options.mask = kStopsLiquid;  // the walls stop everything, the door not that
        EXPECT_EQ(cast(closed, {{1, 2, 2}, 0.5}, {10, 0, 0}, options).face.id, FaceId{9});
    }
    // From the other side, and starts in touch.
    CastOptions from_right{.room = {1}};
    Hit back = cast(closed, {{6, 2, 2}, 0.5}, {-10, 0, 0}, from_right);
    EXPECT_EQ(back.portal, PortalId{0});
    EXPECT_EQ(back.normal, (Vec3{1, 0, 0}));
    EXPECT_EQ(room_of(closed, back), RoomId{1});
    EXPECT_EQ(cast(closed, {{4.25, 2, 2}, 0.5}, {-1, 0, 0}, from_right).status, Status::kInitialOverlap);
    EXPECT_EQ(cast(closed, {{4.25, 2, 2}, 0.5}, {1, 0, 0}, from_right).status, Status::kMiss);
}

TEST(Rooms, AllHitsOfACast) {
    const World closed = two_halves(false);
    std::vector<Hit> hits;
    EXPECT_EQ(cast_all(closed, {{1, 2, 2}, 0.5}, {10, 0, 0}, hits), Status::kHit);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].portal, PortalId{0});
    EXPECT_EQ(hits[1].face.id, FaceId{9});
    RoomTrail trail;
    cast_all(closed, {{1, 2, 2}, 0.5}, {10, 0, 0}, hits, {.room = {0}, .trail = &trail});
    ASSERT_EQ(hits.size(), 2u);  // each as if alone: doors stop nothing here, as walls do not
    EXPECT_EQ(hits[0].portal, PortalId{0});
    EXPECT_EQ(hits[1].face.id, FaceId{9});
    EXPECT_EQ(trail.count, 1u);
}

TEST(Rooms, NearAClosedDoor) {
    const World open = two_halves(), closed = two_halves(false);
    EXPECT_EQ(closest(open, {3.5, 2, 2}).distance, 2);
    const NearFace near = closest(closed, {3.5, 2, 2});
    EXPECT_EQ(near.distance, 0.5);
    EXPECT_EQ(near.portal, PortalId{0});
    EXPECT_FALSE(near.face.valid());
    EXPECT_EQ(closest(closed, {3.5, 2, 2}, INFINITY, {.mask = kStopsLiquid}).distance, 2);
    EXPECT_EQ(closest(closed, {1, 2, 2}, INFINITY, {.room = {1}}).portal, PortalId{0});
    EXPECT_EQ(closest(open, {1, 2, 2}, INFINITY, {.room = {1}}).distance, std::sqrt(13));
    std::vector<Overlap> found;
    EXPECT_EQ(overlap(closed, {{3.5, 2, 2}, 2.1}, found), Status::kInitialOverlap);
    EXPECT_EQ(found.size(), 9u);  // four walls of either room, then the door
    EXPECT_EQ(found.back().portal, PortalId{0});
    overlap(closed, {{3.5, 2, 2}, 2.1}, found, {.room = {0}});
    EXPECT_EQ(found.size(), 5u);
    EXPECT_EQ(overlap(closed, {{3.5, 2, 2}, 2}, found, {.room = {2}}), Status::kInvalid);
    EXPECT_EQ(closest(closed, {3.5, 2, 2}, INFINITY, {.room = {2}}).status, Status::kInvalid);
}

TEST(Rooms, RoomsPassed) {
    const World world = two_halves();
    std::array<RoomId, 1> passed{RoomId{7}};
    RoomTrail trail{passed};
    Hit hit = cast(world, {{1, 2, 2}, 0.5}, {10, 0, 0}, {.room = {0}, .trail = &trail});
    EXPECT_EQ(trail.count, 2u);
    EXPECT_EQ(passed[0], RoomId{0});
    hit = cast(world, {{1, 2, 2}, 0.5}, {2, 0, 0}, {.room = kLocateRoom, .trail = &trail});
    EXPECT_EQ(hit.status, Status::kMiss);
    EXPECT_EQ(trail.count, 1u);
    // The surface of the ball touches the portal at its very end: that counts.
    hit = cast(world, {{1, 2, 2}, 0.5}, {2.5, 0, 0}, {.room = {0}, .trail = &trail});
    EXPECT_EQ(trail.count, 2u);
    // From the rock all rooms are asked.
    hit = cast(world, {{1, 2, 5}, 0.5}, {0, 0, -10}, {.room = kLocateRoom, .trail = &trail});
    EXPECT_EQ(trail.count, 0u);
    EXPECT_EQ(hit.face.id, FaceId{0});
    EXPECT_EQ(cast(world, {{1, 2, 2}, 0.5}, {2, 0, 0}, {.room = {2}}).status, Status::kInvalid);
}

TEST(Rooms, WaysThroughABuilding) {
    const World world =
        assemble_world(DividedBuilding({.rooms_x = 4, .rooms_y = 3, .rooms_z = 2, .closed = 0.3, .seed = 5}).parts())
            .value();
    std::size_t found = 0, longest = 0;
    for (std::uint32_t a = 0; a < world.room_count(); ++a)
        for (std::uint32_t b = 0; b < world.room_count(); ++b)
            for (const Doors doors : {Doors::kAsTheyAre, Doors::kAllOpen}) {
                const auto path = find_path(world, {a}, {b}, doors);
                const auto back = find_path(world, {b}, {a}, doors);
                ASSERT_EQ(path.has_value(), back.has_value());
                if (!path) continue;
                EXPECT_EQ(path->size(), back->size());
                RoomId room{a};
                for (const PortalId id : *path) {
                    const PortalInfo portal = *portal_info(world, id);
                    EXPECT_TRUE(portal.open || doors == Doors::kAllOpen);
                    ASSERT_TRUE(portal.rooms[0] == room || portal.rooms[1] == room);
                    room = portal.rooms[0] == room ? portal.rooms[1] : portal.rooms[0];
                }
                EXPECT_EQ(room, RoomId{b});
                ++found;
                longest = std::max(longest, path->size());
            }
    EXPECT_GT(longest, 5u);
    EXPECT_GT(found, world.room_count() * 4);
    for (std::uint32_t a = 0; a < world.room_count(); ++a)
        for (const RoomId next : neighbours(world, {a}))
            EXPECT_EQ(find_path(world, {a}, next, Doors::kAllOpen)->size(), 1u);
}

TEST(Rooms, PointsOfBuildings) {
    for (const bool outdoors : {false, true})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const DividedBuilding building(
                {.rooms_x = 3, .rooms_y = 3, .rooms_z = 2, .outdoors = outdoors, .closed = 0.2, .seed = seed});
            const World world = assemble_world(building.parts()).value();
            EXPECT_EQ(check_world(world), std::nullopt);
            scenes::Rng rng(seed);
            std::set<std::uint32_t> seen;
            for (int k = 0; k < 2000; ++k) {
                const Vec3 point{rng.uniform(-3, 19), rng.uniform(-3, 19), rng.uniform(-3, 12)};
                const std::optional<int> room = building.room_at(point);
                if (!room) continue;
                EXPECT_EQ(locate(world, point), *room < 0 ? kSolid : in_room(std::uint32_t(*room)));
                EXPECT_EQ(locate(world.solid(), point), *room < 0 ? Where::kSolid : Where::kAir);
                if (*room >= 0) seen.insert(std::uint32_t(*room));
            }
            EXPECT_GT(seen.size(), 15u);
            EXPECT_EQ(locate(world, {1e6, 0, 0}), outdoors ? in_room(0) : kSolid);
        }
}

TEST(Rooms, APartIsRefused) {
    const auto refused = [](const auto& spoil) {
        WorldParts parts = DividedBuilding({}).parts();
        spoil(parts);
        const Result<World> world = assemble_world(std::move(parts));
        return world ? std::string() : world.error().place + ": " + world.error().reason;
    };
    EXPECT_EQ(refused([](WorldParts&) {}), "");
    EXPECT_NE(refused([](WorldParts& p) { p.portals[1].rooms[0] = p.portals[1].rooms[1]; }).find("portal 1"),
              std::string::npos);
    EXPECT_NE(refused([](WorldParts& p) { p.portals[0].rooms[1].value = 99; }), "");
    EXPECT_NE(refused([](WorldParts& p) { p.portals[0].polygons[0].resize(2); }), "");
    EXPECT_NE(refused([](WorldParts& p) { p.rooms[0].exterior = true; }), "");
    EXPECT_NE(refused([](WorldParts& p) { p.rooms.clear(), p.portals.clear(); }), "");
}

}  // namespace
}  // namespace firma

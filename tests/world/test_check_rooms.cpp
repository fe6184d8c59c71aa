// SPDX-License-Identifier: MIT
// What check_world() finds wrong with rooms and portals, and what hashes, diffs and sums of memory see of them.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "firma/memory.h"
#include "firma/rooms.h"
#include "firma/versions.h"
#include "scenes/divided_building.h"
#include "store/bytes_alone.h"
#include "tests/world/two_halves.h"
#include "world/world_data.h"

namespace firma {
namespace {

constexpr std::int32_t kStep = std::int32_t(kSurfaceSteps);

/// The fault of two halves whose parts were changed; "" when there is none.
std::string fault_of(const std::function<void(WorldParts&)>& spoil) {
    WorldParts parts = two_halves_parts();
    spoil(parts);
    const std::optional<WorldFault> fault = check_world(assemble_world(std::move(parts)).value());
    return fault ? fault->what : "";
}

std::string fault_with(const std::function<void(WorldData&)>& spoil) {
    auto data = std::make_shared<WorldData>(two_halves().data());
    spoil(*data);
    const std::optional<WorldFault> fault = check_world(World(std::move(data)));
    return fault ? fault->what : "";
}

TEST(CheckRooms, WhatIsWrong) {
    EXPECT_EQ(fault_of([](WorldParts&) {}), "");
    EXPECT_EQ(fault_of([](WorldParts& p) { p.portals.clear(); }), "room 0 is not closed by its faces and portals");
    EXPECT_EQ(fault_of([](WorldParts& p) { std::swap(p.portals[0].rooms[0], p.portals[0].rooms[1]); }),
              "room 0 is not closed by its faces and portals");
    EXPECT_EQ(fault_of([](WorldParts& p) { p.portals[0].polygons[0][1].y += 1; }),
              "room 0 is not closed by its faces and portals");
    EXPECT_EQ(fault_of([](WorldParts& p) { p.portals[0].polygons[0][1].x += 1; }),
              "portal 0 has a polygon that is not convex and planar, with area");
    EXPECT_EQ(fault_of([](WorldParts& p) { std::swap(p.portals[0].polygons[0][0], p.portals[0].polygons[0][1]); }),
              "portal 0 has a polygon that is not convex and planar, with area");
    EXPECT_EQ(fault_of([](WorldParts& p) { p.rooms[1].faces.faces.pop_back(); }),
              "room 1 is not closed by its faces and portals");
    // Two polygons side by side are as good as one.
    EXPECT_EQ(fault_of([](WorldParts& p) {
                  std::vector<GridPoint>& whole = p.portals[0].polygons[0];
                  const std::vector<GridPoint> low{whole[0], whole[1], whole[2]}, high{whole[2], whole[3], whole[0]};
                  p.portals[0].polygons = {low, high};
              }),
              "");
    // What is only there to be cast against closes nothing.
    EXPECT_EQ(fault_of([](WorldParts& p) {
                  FaceSet& set = p.rooms[0].faces;
                  const auto first = std::uint32_t(set.corners.size());
                  for (const GridPoint& corner :
                       {GridPoint{kStep, kStep, 5}, GridPoint{2 * kStep, kStep, 5}, GridPoint{kStep, 2 * kStep, 5}}) {
                      set.corners.push_back(std::uint32_t(set.vertices.size()));
                      set.vertices.push_back(corner);
                  }
                  set.faces.push_back({.id = {77}, .first_corner = first, .corner_count = 3});
              }),
              "");
}

/// The same room with another record.
void set_record(WorldData& data, std::uint32_t number, const std::function<void(RoomRecord&)>& change) {
    RoomRecord record = data.cells.room(number);
    change(record);
    data.set_room(number, std::make_shared<const RoomRecord>(std::move(record)), data.room_faces[number]);
}

TEST(CheckRooms, Records) {
    const auto with_record = [](std::uint32_t number, const std::function<void(RoomRecord&)>& change) {
        return fault_with([&](WorldData& data) { set_record(data, number, change); });
    };
    EXPECT_EQ(with_record(0, [](auto&) {}), "");
    EXPECT_EQ(with_record(0, [](auto& r) { r.merged_into = 1; }),
              "a block lies in a room that its faces are not part of");
    EXPECT_EQ(with_record(1, [](auto& r) { r.merged_into = 0; }),
              "a block lies in a room that its faces are not part of");
    EXPECT_EQ(with_record(0, [](auto& r) { r.exterior = true; }),
              "more than one room, or rock as well, reaches to infinity");
    EXPECT_EQ(with_record(1, [](auto& r) { r.portals.clear(); }), "room 1 does not list its portals");
    EXPECT_EQ(fault_with([](WorldData& data) {
                  Cells unknown;
                  for (std::uint32_t k = 0; k < 2; ++k) unknown.set_room(k, data.cells.record(k));
                  data.cells = unknown;
              }),
              "rooms have no records");
    // An empty room may be part of a lower one, and of no other.
    const auto with_third = [](const std::function<void(RoomRecord&)>& change) {
        return fault_with([&](WorldData& data) {
            RoomRecord record;
            change(record);
            data.set_room(2, std::make_shared<const RoomRecord>(std::move(record)),
                          Ref<const RoomFaces>(new RoomFaces));
        });
    };
    EXPECT_EQ(with_third([](auto& r) { r.merged_into = 1; }), "");
    EXPECT_EQ(with_third([](auto& r) { r.merged_into = 2; }), "");
    EXPECT_EQ(with_third([](auto& r) { r.merged_into = 1, r.exterior = true; }),
              "room 2 is part of another, and yet not empty");
}

TEST(CheckRooms, KeptHashesAndCounts) {
    const auto with_room = [](const std::function<void(RoomFaces&)>& change) {
        return fault_with([&](WorldData& data) {
            const RoomFaces& room = data.faces_of(0);
            Ref<RoomFaces> changed(new RoomFaces);
            changed->tree = room.tree;
            changed->count = room.count;
            changed->hash = room.hash;
            change(*changed);
            data.set_room(0, data.cells.record(0), Ref<const RoomFaces>(changed.get()));
        });
    };
    EXPECT_EQ(with_room([](RoomFaces&) {}), "");
    EXPECT_EQ(with_room([](RoomFaces& r) { ++r.count; }), "a room's count of faces is not how many there are");
    EXPECT_EQ(with_room([](RoomFaces& r) { ++r.hash; }), "a room's hash is not that of its faces");
    EXPECT_EQ(with_room([](RoomFaces& r) {
                  r.tree = {};
                  r.count = 0;
                  r.hash = 0;
              }),
              "a block lies in no room, in several, or in another leaf there");
    const auto with_solid = [](const std::function<void(SolidData&)>& change) {
        return fault_with([&](WorldData& data) {
            auto solid = std::make_shared<SolidData>(data.solid.data());
            change(*solid);
            data.solid = Solid(std::move(solid));
        });
    };
    EXPECT_EQ(with_solid([](SolidData&) {}), "");
    EXPECT_EQ(with_solid([](SolidData& s) { ++s.point_sum; }), "the hash of the solid is not that of its faces");
    EXPECT_EQ(with_solid([](SolidData& s) { ++s.faces.hash; }), "a hash of faces is not that of the faces");
}

TEST(CheckRooms, HashesSeeRoomsPortalsAndDoors) {
    std::set<std::uint64_t> hashes;
    const auto hash_of = [&](const std::function<void(WorldParts&)>& change) {
        WorldParts parts = two_halves_parts();
        change(parts);
        hashes.insert(hash_world(assemble_world(std::move(parts)).value()));
    };
    hash_of([](WorldParts&) {});
    hash_of([](WorldParts&) {});
    EXPECT_EQ(hashes.size(), 1u);
    hash_of([](WorldParts& p) { p.rooms[1].name = "cellar"; });
    hash_of([](WorldParts& p) { p.rock_outside = false; });
    hash_of([](WorldParts& p) { p.rock_outside = false, p.rooms[1].exterior = true; });
    hash_of([](WorldParts& p) { p.portals[0].open = false; });
    hash_of([](WorldParts& p) { p.portals[0].name = "gate"; });
    hash_of([](WorldParts& p) { p.portals[0].mask = 1; });
    hash_of([](WorldParts& p) { p.portals[0].material = 0; });
    hash_of([](WorldParts& p) { p.portals[0].polygons[0][0].y = 1; });
    hash_of([](WorldParts& p) { std::swap(p.portals[0].rooms[0], p.portals[0].rooms[1]); });
    hash_of([](WorldParts& p) { p.portals[0].polygons.clear(); });
    hash_of([](WorldParts& p) { p.portals.clear(); });
    EXPECT_EQ(hashes.size(), 12u);
    const World world = two_halves();
    const World twice = *set_portal_open(*set_portal_open(world, {0}, false), {0}, true);
    EXPECT_NE(hash_world(world), hash_world(twice));  // another version
}

TEST(CheckRooms, DiffsSeeDoors) {
    const World world = two_halves(), closed = *set_portal_open(world, {0}, false);
    const WorldDiff diff = diff_worlds(world, closed, 4);
    EXPECT_FALSE(diff.empty());
    EXPECT_EQ(diff.closed, std::vector<PortalId>{{0}});
    EXPECT_TRUE(diff.opened.empty() && diff.removed.empty() && diff.added.empty() && diff.rooms.empty());
    EXPECT_EQ(diff.bounds.low, (Vec3{4, 0, 0}));
    EXPECT_EQ(diff.bounds.high, (Vec3{4, 4, 4}));
    EXPECT_EQ(diff.tiles.size(), 4u);
    EXPECT_EQ(diff_worlds(closed, world).opened, std::vector<PortalId>{{0}});
    EXPECT_TRUE(diff_worlds(closed, closed).empty());
}

TEST(CheckRooms, DiffsSeeRoomsAndPortals) {
    const World world = two_halves();
    WorldParts parts = two_halves_parts();
    parts.portals[0].polygons.clear();
    const World gone = assemble_world(std::move(parts)).value();
    EXPECT_EQ(diff_worlds(world, gone).portals_removed, std::vector<PortalId>{{0}});
    EXPECT_EQ(diff_worlds(gone, world).portals_added, std::vector<PortalId>{{0}});
    parts = two_halves_parts();
    parts.portals[0].name = "gate";
    EXPECT_EQ(diff_worlds(world, assemble_world(std::move(parts)).value()).portals_changed, std::vector<PortalId>{{0}});
    // A room that became part of another.
    auto data = std::make_shared<WorldData>(world.data());
    set_record(*data, 1, [](RoomRecord& record) { record.merged_into = 0; });
    const WorldDiff diff = diff_worlds(world, World(data));
    EXPECT_TRUE(diff.removed.empty() && diff.added.empty());
    EXPECT_EQ(diff.rooms, std::vector<RoomId>{{1}});
}

TEST(CheckRooms, MemoryOfRoomsAndPortals) {
    using scenes::DividedBuilding;
    const DividedBuilding building({.rooms_x = 4, .rooms_y = 4, .closed = 0.5, .seed = 2});
    const World world = assemble_world(building.parts()).value();
    const std::size_t plain = memory_used(make_world(building.level()).value()), rooms = memory_used(world);
    EXPECT_GT(rooms, plain + portal_count(world) * 100);
    const World other = *set_portal_open(world, {0}, !portal_info(world, {0})->open);
    const std::vector<World> both{world, other};
    EXPECT_EQ(bytes_alone(other, world), memory_used(both) - memory_used(world));
    EXPECT_LT(bytes_alone(other, world), 2000u);
    EXPECT_EQ(bytes_alone(world, World()), memory_used(std::vector<World>{world, World()}) - memory_used(World()));
}

}  // namespace
}  // namespace firma

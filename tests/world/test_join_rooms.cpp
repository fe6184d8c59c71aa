// SPDX-License-Identifier: MIT
// Craters that make rooms one: what the worlds are then, and that a room's other portals, however many, are shared.
#include <gtest/gtest.h>

#include <algorithm>

#include "firma/carve.h"
#include "firma/memory.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/versions.h"
#include "scenes/hub.h"
#include "scenes/rng.h"
#include "store/bytes_alone.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::Hub;

/// Rooms become one as soon as a crater makes a portal between them.
World make_hub(const Hub& hub) {
    WorldParts parts = scenes::hub_parts(hub);
    parts.options.rules.merge_share = 1e-9;
    return assemble_world(std::move(parts)).value();
}

/// Cuts where a closet's doorway is, at the hall's floor.
World join_to_hall(const World& world, const Hub& hub, int closet) {
    Vec3 door = scenes::floor_of_closet(hub, closet);
    door.y = door.y < 0 ? 0 : 2;
    const CarveResult cut = carve(world, make_crater(CutterShape::kWedge, 1), {.position = door, .scale = 0.3});
    EXPECT_TRUE(cut.done());
    return cut.world;
}

/// Cuts the wall between a closet and the one behind it, on the same side.
World join_closets(const World& world, const Hub& hub, int closet) {
    const Vec3 wall = scenes::floor_of_closet(hub, closet) + Vec3{1, 0, 1};
    const CarveResult cut = carve(world, make_crater(CutterShape::kWedge, 1), {.position = wall, .scale = 0.8});
    EXPECT_TRUE(cut.done());
    return cut.world;
}

std::size_t portals_not_shared(const World& a, const World& b) {
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < portal_count(a); ++k) count += &a.data().cells.portal(k) != &b.data().cells.portal(k);
    return count;
}

void expect_sound(const World& world) {
    const auto fault = check_world(world);
    ASSERT_FALSE(fault) << fault->what;
    const World read = unpack_world(pack_world(world), "joined").value();
    ASSERT_EQ(hash_world(read), hash_world(world));
    ASSERT_TRUE(pack_world(read) == pack_world(world));
    ASSERT_FALSE(check_world(read));
}

TEST(JoinRooms, AHallKeepsThePortalsThatDoNotChange) {
    for (const bool hall_last : {false, true}) {
        const Hub few{20, hall_last}, many{400, hall_last};
        std::size_t bytes[2] = {};
        for (const Hub& hub : {few, many}) {
            SCOPED_TRACE(testing::Message() << hub.closets << " closets, the hall " << hall_of(hub).value);
            const World world = make_hub(hub);
            expect_sound(world);
            ASSERT_EQ(portal_count(world), std::size_t(hub.closets));
            const World joined = join_to_hall(world, hub, 2);
            expect_sound(joined);
            EXPECT_EQ(portals_not_shared(world, joined), 1u);
            bytes[hub.closets == many.closets] = bytes_alone(joined, world);
            const std::vector<World> both{world, joined};
            EXPECT_EQ(bytes_alone(joined, world), memory_used(both) - memory_used(std::span(both).first(1)));

            const RoomId hall = std::min(hall_of(hub), room_of_closet(hub, 2));
            EXPECT_EQ(room_info(joined, hall_of(hub))->merged_into, hall);
            EXPECT_EQ(room_info(joined, hall)->portals.size(), std::size_t(hub.closets) - 1);
            EXPECT_EQ(neighbours(joined, hall_of(hub)).size(), std::size_t(hub.closets) - 1);
            const WorldDiff diff = diff_worlds(world, joined), back = diff_worlds(joined, world);
            EXPECT_EQ(diff.portals_removed.size(), 1u);
            EXPECT_EQ(back.portals_added, diff.portals_removed);
            EXPECT_EQ(diff.portals_changed.size(), hall_last ? std::size_t(hub.closets) - 1 : 0u);
            EXPECT_EQ(back.portals_changed, diff.portals_changed);
        }
        // Four bytes a portal, and maps and indices a level deeper, those over the portals of the world and of the hall
        // too: two nodes of up to 64 are made anew in each. The portals themselves are many times as much.
        EXPECT_LT(bytes[1], bytes[0] + 32'000);
    }
}

TEST(JoinRooms, PortalsSayWhatTheirRoomsBecame) {
    const Hub hub{8, true};
    World world = make_hub(hub);
    const World first = world;
    world = join_closets(world, hub, 2);
    expect_sound(world);
    EXPECT_EQ(room_info(world, {4})->merged_into, RoomId{2});
    EXPECT_EQ(room_info(world, {2})->portals.size(), 2u);
    EXPECT_EQ(diff_worlds(first, world).portals_changed, std::vector<PortalId>{room_info(first, {4})->portals[0]});
    world = join_to_hall(world, hub, 0);
    expect_sound(world);
    for (const RoomId room : {RoomId{8}, RoomId{0}}) EXPECT_EQ(neighbours(world, room).size(), 6u);
    const PortalInfo portal = *portal_info(world, room_info(world, {3})->portals[0]);
    EXPECT_EQ(portal.rooms[0], RoomId{3});
    EXPECT_EQ(portal.rooms[1], RoomId{0});
    EXPECT_EQ(find_path(world, {8}, {4})->size(), 1u);
    // From the hall through the portal of closet 3, and back.
    const Vec3 closet = scenes::floor_of_closet(hub, 3) + Vec3{0, 0, 1};
    for (const double way : {1.0, -1.0}) {
        const Vec3 start = closet + Vec3{0, way > 0 ? -2.0 : 0, 0};
        std::array<RoomId, 2> passed;
        RoomTrail trail{passed};
        EXPECT_NE(cast_any(world, {start, 0.1}, {0, way * 1.5, 0}, {.room = kLocateRoom, .trail = &trail}),
                  Status::kInvalid);
        EXPECT_EQ(trail.count, 2u);
        EXPECT_EQ(passed[0], way > 0 ? RoomId{0} : RoomId{3});
        EXPECT_EQ(passed[1], way > 0 ? RoomId{3} : RoomId{0});
    }
    const World closed = *set_portal_open(world, room_info(world, {3})->portals[0], false);
    const Hit hit = cast(closed, {closet + Vec3{0, -2, 0}, 0.1}, {0, 3, 0}, {.room = {8}});
    EXPECT_EQ(room_of(closed, hit), RoomId{0});
    EXPECT_EQ(locate(world, closet + Vec3{0, -1, 0}).room, RoomId{3});  // on it: the first of its rooms
}

/// Whichever order they are joined in, rooms of more portals than Cells::kCrowd among them.
TEST(JoinRooms, ManyInAnyOrder) {
    for (const bool hall_last : {false, true})
        for (const std::uint64_t seed : {1, 2}) {
            const Hub hub{72, hall_last};
            World world = make_hub(hub);
            std::vector<int> order(72);
            for (int k = 0; k < 72; ++k) order[std::size_t(k)] = k;
            scenes::Rng rng(seed);
            for (std::size_t k = 72; k > 1; --k) std::swap(order[k - 1], order[rng.below(std::uint32_t(k))]);
            for (std::size_t k = 0; k < 20; ++k) {
                const bool between = order[k] < 70 && k % 3 == 0;
                world = between ? join_closets(world, hub, order[k]) : join_to_hall(world, hub, order[k]);
                if (k % 4 == 3) expect_sound(world);
                if (HasFatalFailure()) return;
            }
            expect_sound(world);
        }
}

/// From the last to the first: each joined room is part of the one before it.
TEST(JoinRooms, ALongChainOfJoinedRooms) {
    Cells cells;
    constexpr std::uint32_t kRooms = 3000;
    const auto set = [&](std::uint32_t number, std::uint32_t into) {
        RoomRecord record;
        record.merged_into = into;
        cells.set_room(number, std::make_shared<const RoomRecord>(std::move(record)));
    };
    for (std::uint32_t k = 0; k < kRooms; ++k) set(k, k);
    for (std::uint32_t k = kRooms - 1; k > 1; --k) {
        const Cells before = cells;
        set(k, k - 1);
        ASSERT_EQ(before.current_room(kRooms - 1), k);
        ASSERT_EQ(cells.current_room(kRooms - 1), k - 1);
    }
    for (std::uint32_t k = 1; k < kRooms; ++k) ASSERT_EQ(cells.current_room(k), 1u);
    EXPECT_EQ(cells.current_room(0), 0u);
    int deepest = 0;  // steps to a root
    cells.joined().for_each([&](std::uint32_t room, std::uint64_t) {
        int steps = 0;
        for (const std::uint64_t* next; !(*(next = cells.joined().find(room)) >> 63); ++steps)
            room = std::uint32_t(*next);
        deepest = std::max(deepest, steps);
    });
    EXPECT_LE(deepest, 12);  // the logarithm of the rooms
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Casts that go from room to room answer as casts against all faces do, for starts in the air clear of the walls.
#include <gtest/gtest.h>

#include <algorithm>

#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/divided_building.h"
#include "scenes/hub.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// Each room but the first was reached through an open portal, or one that stops nothing, of a room before it.
void expect_portals_join(const World& world, const RoomTrail& trail) {
    const std::size_t count = std::min<std::size_t>(trail.count, trail.portals.size());
    for (std::size_t k = 0; k < count; ++k) {
        if (k == 0) {
            EXPECT_FALSE(trail.portals[k].valid());
            continue;
        }
        const std::optional<PortalInfo> portal = portal_info(world, trail.portals[k]);
        ASSERT_TRUE(portal);
        const bool second = portal->rooms[1] == trail.rooms[k];
        EXPECT_EQ(portal->rooms[second], trail.rooms[k]);
        const auto before = trail.rooms.first(k);
        EXPECT_NE(std::find(before.begin(), before.end(), portal->rooms[!second]), before.end()) << "room " << k;
    }
}

using scenes::BuildingPlan;
using scenes::DividedBuilding;

struct Asked {
    Sphere sphere;
    Vec3 path;
};

Asked ask(const DividedBuilding& building, scenes::Rng& rng) {
    Asked asked;
    asked.sphere.radius = rng.chance(0.3) ? 0 : rng.uniform(0.01, 0.45);
    asked.sphere.centre = building.point_in_air(asked.sphere.radius, rng);
    const Vec3 direction = rng.direction();
    asked.path = direction * (rng.chance(0.3) ? rng.uniform(0.01, 1.0) : rng.uniform(1, 40));
    if (rng.chance(0.25)) {  // along an axis, and so along portals, too
        const std::uint32_t axis = rng.below(3);
        for (std::uint32_t other = 0; other < 3; ++other)
            if (other != axis) asked.path[int(other)] = 0;
    }
    return asked;
}

/// All that does not say which rooms were asked.
void expect_same(const Hit& a, const Hit& b) {
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.fraction, b.fraction);
    EXPECT_EQ(a.safe_fraction, b.safe_fraction);
    EXPECT_EQ(a.face, b.face);
    EXPECT_EQ(a.portal, b.portal);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.normal, b.normal);
}

/// Of a cast that finds out where it starts.
std::uint32_t rooms_passed(const World& world, const Sphere& sphere, const Vec3& path) {
    RoomTrail trail;
    static_cast<void>(cast(world, sphere, path, {.room = kLocateRoom, .trail = &trail}));
    return trail.count;
}

void compare(const DividedBuilding& building, const World& world, int casts, std::uint64_t seed) {
    const World whole = make_world(building.level()).value();
    const bool has_closed = world.data().cells.any_closed();
    scenes::Rng rng(seed);
    std::size_t touched = 0, doors = 0, far = 0;
    std::vector<Hit> hits;
    for (int k = 0; k < casts && !testing::Test::HasFailure(); ++k) {
        const Asked asked = ask(building, rng);
        const bool starts_at_door = closest(world, asked.sphere.centre, asked.sphere.radius + 1e-9).found();
        const Hit all = cast(world, asked.sphere, asked.path);
        const Location start = locate(world, asked.sphere.centre);
        ASSERT_EQ(start.where, Where::kAir);
        SCOPED_TRACE(testing::Message() << "cast " << k << " from room " << start.room.value);
        std::array<RoomId, 64> passed;
        std::array<PortalId, 64> portals;
        RoomTrail trail{.rooms = passed, .portals = portals};
        const CastOptions by_room{.room = start.room, .trail = &trail};
        const Hit hit = cast(world, asked.sphere, asked.path, by_room);
        const std::uint32_t rooms_passed = trail.count;
        expect_portals_join(world, trail);
        trail.rooms = {};
        trail.portals = {};
        expect_same(hit, all);
        EXPECT_EQ(room_of(world, hit), room_of(world, all));
        expect_same(cast(world, asked.sphere, asked.path, {.room = kLocateRoom}), all);
        EXPECT_EQ(cast_any(world, asked.sphere, asked.path, by_room) == Status::kMiss, !all.touched());
        EXPECT_EQ(cast_all(world, asked.sphere, asked.path, hits, by_room) == Status::kMiss, !all.touched());
        if (!hits.empty()) {
            expect_same(hits[0], all);
        }
        if (!has_closed) {
            const Hit plain = cast(whole, asked.sphere, asked.path);
            EXPECT_EQ(plain.status, all.status);
            EXPECT_EQ(plain.fraction, all.fraction);
            EXPECT_EQ(plain.face, all.face);
        }
        ASSERT_GE(rooms_passed, 1u);
        EXPECT_EQ(passed[0], start.room);
        for (std::uint32_t p = 0; p < std::min(rooms_passed, 64u); ++p) {
            EXPECT_EQ(std::count(passed.begin(), passed.begin() + std::min(rooms_passed, 64u), passed[p]), 1);
        }
        const bool ends_at_door = std::any_of(hits.begin(), hits.end(), [&](const Hit& other) {
            return other.portal.valid() && other.fraction <= hit.fraction * (1 + 1e-9);
        });
        if (hit.touched() && !starts_at_door && !ends_at_door) {  // there a face behind the door may have the lowest id
            const RoomId* const end = passed.data() + std::min(rooms_passed, 64u);
            EXPECT_NE(std::find<const RoomId*>(passed.data(), end, room_of(world, hit)), end);
        }
        touched += all.touched();
        doors += all.portal.valid();
        far += rooms_passed > 2;
    }
    EXPECT_GT(touched, std::size_t(casts) / 5);
    EXPECT_GT(far, std::size_t(casts) / 200);
    if (has_closed) {
        EXPECT_GT(doors, 0u);
    }
}

TEST(CastsByRoom, AnswerAsThoseAgainstAllFaces) {
    for (const bool outdoors : {false, true})
        for (const double closed : {0.0, 0.4})
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                SCOPED_TRACE(testing::Message() << outdoors << " " << closed << " " << seed);
                const DividedBuilding building({.rooms_x = 3,
                                                .rooms_y = 2,
                                                .rooms_z = seed == 2 ? 1 : 2,
                                                .jitter = seed == 3 ? 0 : 0.15,
                                                .outdoors = outdoors,
                                                .closed = closed,
                                                .seed = seed});
                compare(building, assemble_world(building.parts()).value(), 2500, seed);
            }
}

TEST(CastsByRoom, ManyRooms) {
    const DividedBuilding building({.rooms_x = 6, .rooms_y = 6, .rooms_z = 2, .outdoors = true, .seed = 9});
    const World world = assemble_world(building.parts()).value();
    EXPECT_GT(world.room_count(), 100u);
    compare(building, world, 1500, 1);
}

/// From a portal on, both rooms are right.
TEST(CastsByRoom, FromOnAPortal) {
    const DividedBuilding building({.rooms_x = 3, .rooms_y = 3, .seed = 4});
    const World world = assemble_world(building.parts()).value();
    scenes::Rng rng(4);
    for (std::uint32_t k = 0; k < portal_count(world); ++k) {
        const PortalInfo portal = *portal_info(world, {k});
        for (const std::vector<Vec3>& polygon : portal_polygons(world, {k}))
            for (int turn = 0; turn < 8; ++turn) {
                const double share = rng.uniform(0.1, 0.9);
                const Vec3 start = polygon[0] + (polygon[2] - polygon[0]) * share;
                const Vec3 direction = rng.direction();
                const Hit all = cast(world, {start, 0}, direction * 9);
                for (const RoomId room : portal.rooms)
                    expect_same(cast(world, {start, 0}, direction * 9, {.room = room}), all);
            }
    }
}

/// The faces of a box of air, corners in whole steps of 1/8 m.
void add_air_box(FaceSet& set, std::uint32_t first_id, const GridPoint& low, const GridPoint& high) {
    constexpr std::int32_t kStep = std::int32_t(kSurfaceSteps / 8);
    const auto first = std::uint32_t(set.vertices.size());
    for (int k = 0; k < 8; ++k)
        set.vertices.push_back(
            {(k & 1 ? high.x : low.x) * kStep, (k & 2 ? high.y : low.y) * kStep, (k & 4 ? high.z : low.z) * kStep});
    constexpr std::uint32_t kSides[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                            {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (const auto& side : kSides) {
        set.faces.push_back(
            {.id = {first_id++}, .first_corner = std::uint32_t(set.corners.size()), .corner_count = 4, .solid = true});
        for (const std::uint32_t corner : side) set.corners.push_back(first + corner);
    }
}

/// Starts that are not clear of the walls: the rule of docs/rooms.md.
TEST(CastsByRoom, ThroughAThinWall) {
    WorldParts parts;
    parts.rock_outside = true;
    parts.rooms.resize(2);
    add_air_box(parts.rooms[0].faces, 0, {0, 0, 0}, {32, 32, 32});   // 0 to 4 m
    add_air_box(parts.rooms[1].faces, 6, {33, 0, 0}, {64, 24, 32});  // behind a wall of 1/8 m; only 3 m along y
    const World world = assemble_world(std::move(parts)).value();
    ASSERT_EQ(check_world(world), std::nullopt);
    const Vec3 path{0, 1.5, 0};  // along the wall, into which the ball reaches, and through it
    const Sphere ball{{3.875, 2, 2}, 0.5};
    const Hit all = cast(world, ball, path);
    EXPECT_EQ(room_of(world, all), RoomId{1});
    EXPECT_EQ(all.face.id, FaceId{9});
    EXPECT_LT(all.fraction, 1);
    for (const RoomId room : {RoomId{0}, kLocateRoom}) {
        RoomTrail trail;
        const Hit hit = cast(world, ball, path, {.room = room, .trail = &trail});  // its own room only
        EXPECT_EQ(hit.face.id, FaceId{3});
        EXPECT_EQ(hit.fraction, 1);
        EXPECT_EQ(trail.count, 1u);
    }
    // Into the wall: the overlap gets deeper at once, whoever is asked.
    for (const RoomId room : {RoomId{0}, kLocateRoom, kAnyRoom}) {
        const Hit hit = cast(world, ball, {1, 0, 0}, {.room = room});
        EXPECT_EQ(hit.status, Status::kInitialOverlap);
        EXPECT_EQ(hit.face.id, FaceId{5});
    }
    // From within the wall nothing says which room is meant: all are asked.
    const Sphere inside{{4.0625, 2, 2}, 0.5};
    expect_same(cast(world, inside, path, {.room = kLocateRoom}), cast(world, inside, path));
    EXPECT_EQ(rooms_passed(world, inside, path), 0u);
    EXPECT_EQ(cast(world, inside, path * 1.25, {.room = {0}}).face.id, FaceId{3});  // believed
    // On a face likewise.
    const Sphere on_face{{4, 2, 2}, 0.5};
    expect_same(cast(world, on_face, path, {.room = kLocateRoom}), cast(world, on_face, path));
    EXPECT_EQ(rooms_passed(world, on_face, path), 0u);
}

/// More rooms than there are marks for on the stack, and more waiting than have places there.
TEST(CastsByRoom, MoreRoomsThanPlaces) {
    WorldParts parts;
    parts.rock_outside = true;
    constexpr std::uint32_t kCount = 5000;
    parts.rooms.resize(kCount);
    const auto at = [](double x, double y, double z) {
        return GridPoint{std::int32_t(x * kSurfaceSteps), std::int32_t(y * kSurfaceSteps),
                         std::int32_t(z * kSurfaceSteps)};
    };
    // A floor of strips, a room each, between two long walls; every strip is reached from the first by a portal of its
    // own. No closed rooms, but casts do not mind.
    for (std::uint32_t k = 0; k < kCount; ++k) {
        FaceSet& set = parts.rooms[k].faces;
        set.vertices = {at(k, 0, 0), at(k + 1, 0, 0), at(k + 1, 1, 0), at(k, 1, 0)};
        set.corners = {0, 1, 2, 3};
        set.faces.push_back({.id = {k}, .first_corner = 0, .corner_count = 4});
        if (k == 0) continue;
        PortalPart portal;
        portal.rooms = {RoomId{0}, RoomId{k}};
        portal.polygons = {{at(k, 0, 0.125), at(k + 1, 0, 0.125), at(k + 1, 1, 0.125), at(k, 1, 0.125)}};
        parts.portals.push_back(portal);
    }
    for (const std::uint32_t count : {kCount, 4000u}) {
        parts.rooms.resize(count);
        parts.portals.resize(count - 1);
        WorldParts copy;
        copy.rock_outside = true;
        copy.rooms = parts.rooms;
        copy.portals = parts.portals;
        const World world = assemble_world(std::move(copy)).value();
        // Down on the first strips: some rooms wait. Along all of them: far too many do.
        for (const Vec3& path : {Vec3{1.2, 0, -2}, Vec3{3900, 0, -1.6}}) {
            const Hit all = cast(world, {{0.5, 0.5, 1.5}, 0.25}, path);
            RoomTrail trail;
            const Hit by_room = cast(world, {{0.5, 0.5, 1.5}, 0.25}, path, {.room = {0}, .trail = &trail});
            EXPECT_TRUE(all.touched());
            expect_same(by_room, all);
            EXPECT_EQ(trail.count > 256, path.x > 1000) << trail.count;
            std::vector<Hit> hits, hits_by_room;
            cast_all(world, {{0.5, 0.5, 1.5}, 0.25}, path, hits);
            cast_all(world, {{0.5, 0.5, 1.5}, 0.25}, path, hits_by_room, {.room = {0}});
            ASSERT_EQ(hits.size(), hits_by_room.size());
            for (std::size_t k = 0; k < hits.size(); ++k) expect_same(hits_by_room[k], hits[k]);
        }
    }
}

/// More rooms than marks fit on the stack: a cast keeps its thread's memory, so one that a visitor asks, in a world of
/// more rooms still, must not touch it.
TEST(CastsByRoom, AVisitorMayAskInWorldsOfManyRooms) {
    const scenes::Hub many{.closets = 4'200}, more{.closets = 8'600};
    const World world = assemble_world(scenes::hub_parts(many)).value();
    const World larger = assemble_world(scenes::hub_parts(more)).value();
    const Sphere ball{{0, 1, 1}, 1.5};  // reaches into the closets that it passes
    const Vec3 path{30, 0, 0};
    const CastOptions by_room{.sides = Sides::kBoth, .room = kLocateRoom};
    const auto count = [&](const auto& meanwhile) {
        std::size_t hits = 0;
        cast_each(
            world, ball, path,
            [&](const Hit&) {
                ++hits;
                meanwhile();
                return 1.0;
            },
            by_room);
        return hits;
    };
    const std::size_t alone = count([] {});
    ASSERT_GT(alone, 0u);
    for (const World* asked : {&world, &larger}) {
        const Hit expected = cast(*asked, ball, path, by_room);
        EXPECT_EQ(count([&] { expect_same(cast(*asked, ball, path, by_room), expected); }), alone);
    }
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Edits of worlds of several rooms: every room stays closed, every answer true.
#include <gtest/gtest.h>

#include "firma/carve.h"
#include "firma/memory.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/solid.h"
#include "firma/versions.h"
#include "scenes/divided_building.h"
#include "store/bytes_alone.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_rooms.h"
#include "tests/world/two_halves.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::DividedBuilding;

CarveResult cut(const World& world, CutterShape shape, const Vec3& position, double scale, bool fills = false) {
    Pose pose;
    pose.position = position;
    pose.scale = scale;
    const Cutter cutter = make_crater(shape, 3);
    return fills ? fill(world, cutter, pose) : carve(world, cutter, pose);
}

Location in_room(std::uint32_t room) {
    return {Where::kAir, {room}};
}

/// By room, by located room, and against all faces.
void expect_casts_agree(const World& world, const Vec3& around, double reach, scenes::Rng& rng, int casts) {
    for (int k = 0; k < casts; ++k) {
        Sphere sphere;
        sphere.radius = rng.chance(0.4) ? 0 : rng.uniform(0.01, 0.3);
        for (int axis = 0; axis < 3; ++axis) sphere.centre[axis] = around[axis] + rng.uniform(-reach, reach);
        const Vec3 direction = rng.direction();
        const Vec3 path = direction * rng.uniform(0.1, 20.0);
        std::uint32_t rooms_passed = 0;
        EXPECT_EQ(reference::judge_cast_by_room(world, sphere, path, rooms_passed), "");
        if (rooms_passed > 0) {
            EXPECT_EQ(locate(world.solid(), sphere.centre), Where::kAir);
        }
    }
}

TEST(CarveRooms, ACutInOneRoomLeavesTheOtherAlone) {
    const World world = two_halves();
    const CarveResult result = cut(world, CutterShape::kRocky, {0, 2, 2}, 1);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(result.world.room_count(), 2u);
    EXPECT_EQ(&result.world.data().faces_of(1), &world.data().faces_of(1));
    EXPECT_EQ(&result.world.data().cells.portal(0), &world.data().cells.portal(0));
    EXPECT_EQ(locate(result.world, {-0.3, 2, 2}), in_room(0));
    EXPECT_EQ(diff_worlds(world, result.world).rooms, std::vector<RoomId>{{0}});
}

TEST(CarveRooms, ACutAtAPortalJoinsItsRooms) {
    for (const bool open : {true, false}) {
        const World world = two_halves(open);
        const CarveResult result = cut(world, CutterShape::kRocky, {4, 2, 0}, 1);
        ASSERT_TRUE(result.done());
        const World& after = result.world;
        test::expect_sound_world(after);
        EXPECT_EQ(after.room_count(), 2u);
        EXPECT_EQ(room_info(after, {1})->merged_into, RoomId{0});
        EXPECT_EQ(room_info(after, {1})->faces, 0u);
        EXPECT_EQ(room_info(after, {0})->faces, after.face_count());
        EXPECT_TRUE(portal_info(after, {0})->polygons == 0);
        EXPECT_TRUE(portal_info(after, {0})->open);
        EXPECT_EQ(portal_info(after, {0})->rooms[0], RoomId{0});
        EXPECT_EQ(locate(after, {7, 1, 1}), in_room(0));
        EXPECT_EQ(find_path(after, {1}, {0})->size(), 0u);
        std::array<RoomId, 1> passed;
        RoomTrail trail{passed};
        const Hit hit = cast(after, {{7, 2, 2}, 0.2}, {-10, 0, 0}, {.room = {1}, .trail = &trail});  // the id of before
        EXPECT_EQ(hit.face.id, FaceId{4});
        EXPECT_EQ(room_of(after, hit), RoomId{0});
        EXPECT_EQ(passed[0], RoomId{0});
        // Faces that only came into another room did not change.
        const WorldDiff diff = diff_worlds(world, after);
        EXPECT_EQ(diff.rooms, (std::vector<RoomId>{{0}, {1}}));
        EXPECT_EQ(diff.portals_removed, std::vector<PortalId>{{0}});
        EXPECT_EQ(diff.removed.size(), result.report.faces_removed);
        EXPECT_EQ(diff.added.size(), result.report.faces_added);
        // And as a file.
        const World read = unpack_world(pack_world(after), "test").value();
        EXPECT_EQ(hash_world(read), hash_world(after));
        EXPECT_EQ(hash_world(cut(read, CutterShape::kRocky, {8, 2, 2}, 0.7).world),
                  hash_world(cut(after, CutterShape::kRocky, {8, 2, 2}, 0.7).world));
    }
}

TEST(CarveRooms, ACavityIsARoomUntilItIsOpened) {
    const World world = two_halves();
    CarveResult result = cut(world, CutterShape::kBox, {1.5, 2, -2}, 0.5);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(result.world.room_count(), 3u);
    EXPECT_EQ(locate(result.world, {1.5, 2, -2}), in_room(2));
    EXPECT_EQ(room_of(result.world, cast(result.world, {{1.5, 2, -2}, 0}, {0, 0, 9}, {.room = kLocateRoom})),
              RoomId{2});
    EXPECT_EQ(&result.world.data().cells.portal(0), &world.data().cells.portal(0));
    EXPECT_EQ(diff_worlds(world, result.world).rooms, std::vector<RoomId>{{2}});
    result = cut(result.world, CutterShape::kBox, {1.5, 2, -0.8}, 1);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(locate(result.world, {1.5, 2, -2}), in_room(0));
    EXPECT_EQ(room_info(result.world, {2})->merged_into, RoomId{0});
    EXPECT_EQ(locate(result.world, {7, 1, 1}), in_room(1));
}

TEST(CarveRooms, FillsInTheAir) {
    const World world = two_halves();
    CarveResult result = cut(world, CutterShape::kBox, {6, 2, 2}, 0.5, true);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(result.world.room_count(), 2u);
    EXPECT_EQ(room_info(result.world, {1})->faces, 5 + result.report.faces_added);
    EXPECT_EQ(&result.world.data().faces_of(0), &world.data().faces_of(0));
    result = cut(result.world, CutterShape::kBox, {4, 2, 2}, 0.5, true);  // astride the portal
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(room_info(result.world, {1})->merged_into, RoomId{0});
}

/// A door that is shut says nothing of the solid: the same edit with it open makes the same solid.
TEST(CarveRooms, DoorsDoNotMatter) {
    const World open = two_halves(true), closed = two_halves(false);
    for (const bool fills : {true, false})
        for (const Vec3& at : {Vec3{4, 2, 2}, Vec3{4, 2, 0}, Vec3{3.5, 2, 0}}) {
            const CarveResult a = cut(open, CutterShape::kBox, at, 0.5, fills);
            const CarveResult b = cut(closed, CutterShape::kBox, at, 0.5, fills);
            EXPECT_EQ(a.status, b.status);
            EXPECT_EQ(hash_solid(a.world), hash_solid(b.world));
        }
}

/// Large walls are divided toward a cut, and with them edges that they share with walls of other rooms, at the rims of
/// portals.
TEST(CarveRooms, LargeWalls) {
    scenes::Rng rng(8);
    int joined = 0, alone = 0;
    for (int k = 0; k < 60 && !HasFailure(); ++k) {
        World world = assemble_world(two_halves_parts(40)).value();
        for (int cuts = 0; cuts < 3 && room_info(world, {1})->merged_into == RoomId{1}; ++cuts) {
            Vec3 at{rng.uniform(0, 80), rng.uniform(0, 40), rng.uniform(0, 40)};
            at[int(rng.below(3))] = 0;
            const CarveResult result = cut(world, CutterShape::kRocky, at, 1, rng.chance(0.3));
            ASSERT_TRUE(result.done());
            test::expect_sound_world(result.world);
            expect_casts_agree(result.world, at, 3, rng, 60);
            world = result.world;
        }
        room_info(world, {1})->merged_into == RoomId{1} ? ++alone : ++joined;
    }
    EXPECT_GT(joined, 5);
    EXPECT_GT(alone, 5);
}

TEST(CarveRooms, ManyCutsInBuildings) {
    for (const bool outdoors : {false, true}) {
        const DividedBuilding building({.rooms_x = 4, .rooms_y = 4, .rooms_z = 2, .outdoors = outdoors, .seed = 11});
        World world = assemble_world(building.parts()).value(), one_room = make_world(building.level()).value();
        scenes::Rng rng(outdoors ? 5 : 6);
        std::size_t done = 0, joined = 0, alone = 0;
        for (int k = 0; k < 40 && !HasFailure(); ++k) {
            SCOPED_TRACE(testing::Message() << outdoors << ", cut " << k);
            Pose pose;
            const Vec3 start = building.point_in_air(0.2, rng);
            const Vec3 direction = rng.direction();
            const Hit hit = cast(world, {start, 0}, direction * 50.0);
            pose.position = rng.chance(0.8) && hit.touched() ? hit.point : start;
            pose.scale = rng.uniform(0.2, 0.9);
            const CutterShape shape = rng.chance(0.5) ? CutterShape::kRocky : CutterShape::kBox;
            const Cutter cutter = make_crater(shape, rng.next());
            const bool fills = rng.chance(0.3);
            const CarveResult result = fills ? fill(world, cutter, pose) : carve(world, cutter, pose);
            const CarveResult plain = fills ? fill(one_room, cutter, pose) : carve(one_room, cutter, pose);
            ASSERT_EQ(result.status, plain.status);
            if (!result.done()) continue;
            ++done;
            test::expect_sound_world(result.world);
            // Rooms change nothing of the solid.
            EXPECT_EQ(hash_solid(result.world), hash_solid(plain.world));
            EXPECT_EQ(result.world.face_count(), plain.world.face_count());
            expect_casts_agree(result.world, pose.position, 2, rng, 150);
            const WorldDiff diff = diff_worlds(world, result.world);
            EXPECT_EQ(diff.removed.size(), result.report.faces_removed);
            EXPECT_EQ(diff.added.size(), result.report.faces_added);
            const std::vector<World> both{world, result.world};
            EXPECT_EQ(bytes_alone(result.world, world), memory_used(both) - memory_used(world));
            const auto is_part = [](const World& it, std::uint32_t room) {
                return room_info(it, {room})->merged_into != RoomId{room};
            };
            bool any = false;
            for (std::uint32_t room = 0; room < world.room_count(); ++room)
                any |= is_part(result.world, room) && !is_part(world, room);
            any ? ++joined : ++alone;
            world = result.world;
            one_room = plain.world;
        }
        EXPECT_GT(done, 20u);
        EXPECT_GT(joined, 3u);
        EXPECT_GT(alone, 7u);
        const World read = unpack_world(pack_world(world), "test").value();
        EXPECT_EQ(hash_world(read), hash_world(world));
    }
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Edits of worlds of several rooms: every room stays closed, every answer true.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/edit_log.h"
#include "firma/memory.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/solid.h"
#include "firma/versions.h"
#include "scenes/divided_building.h"
#include "store/bytes_alone.h"
#include "tests/brush/depot_level.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_rooms.h"
#include "tests/sample.h"
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

double area_of(const World& world, PortalId portal) {
    double sum = 0;
    for (const std::vector<Vec3>& polygon : portal_polygons(world, portal)) {
        Vec3 twice{0, 0, 0};
        for (std::size_t k = 2; k < polygon.size(); ++k)
            twice = twice + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
        sum += length(twice) / 2;
    }
    return sum;
}

/// A hole under a door: the door stays what it was, and there is a way under it.
TEST(CarveRooms, ACutAtAPortalGoesAroundIt) {
    for (const bool open : {true, false}) {
        const World world = two_halves(open);
        const CarveResult result = cut(world, CutterShape::kRocky, {4, 2, 0}, 1);
        ASSERT_TRUE(result.done());
        const World& after = result.world;
        test::expect_sound_world(after);
        EXPECT_EQ(after.room_count(), 2u);
        EXPECT_EQ(room_info(after, {1})->merged_into, RoomId{1});
        EXPECT_EQ(portal_info(after, {0})->open, open);
        EXPECT_NEAR(area_of(after, {0}), 16, 1e-4) << "its rim is divided, no more";
        ASSERT_EQ(portal_count(after), 2u);
        const PortalInfo hole = *portal_info(after, {1});
        EXPECT_TRUE(hole.open);
        EXPECT_EQ(hole.name, "");
        EXPECT_GT(area_of(after, {1}), 0.5);
        EXPECT_EQ(locate(after, {7, 1, 1}), in_room(1));
        EXPECT_EQ(locate(after, {1, 1, 1}), in_room(0));
        EXPECT_EQ(find_path(after, {1}, {0})->size(), 1u);
        // Under the door, from one room's floor into the pocket, which is the other's.
        const Vec3 start{4.5, 2, 0.2}, path{-0.9, 0, -0.6};
        std::array<RoomId, 4> passed;
        std::array<PortalId, 4> through;
        RoomTrail trail{.rooms = passed, .portals = through};
        const Hit hit = cast(after, {start, 0}, path, {.room = kLocateRoom, .trail = &trail});
        EXPECT_FALSE(hit.portal.valid());
        EXPECT_EQ(locate(after, start), in_room(1));
        const RoomId below = locate(after, start + path * 0.9).room;
        if (below == RoomId{0}) {
            EXPECT_EQ(trail.count, 2u);
            EXPECT_EQ(through[1], PortalId{1});
        }
        EXPECT_EQ(cast(world, {start, 0}, path).touched(), true);
        const WorldDiff diff = diff_worlds(world, after);
        EXPECT_EQ(diff.rooms, (std::vector<RoomId>{{0}, {1}}));
        EXPECT_EQ(diff.portals_added, std::vector<PortalId>{{1}});
        EXPECT_EQ(diff.portals_changed, std::vector<PortalId>{{0}});
        EXPECT_TRUE(diff.portals_removed.empty() && diff.opened.empty() && diff.closed.empty());
        EXPECT_EQ(diff.removed.size(), result.report.faces_removed);
        EXPECT_EQ(diff.added.size(), result.report.faces_added);
        // And as a file.
        const World read = unpack_world(pack_world(after), "test").value();
        EXPECT_EQ(hash_world(read), hash_world(after));
        EXPECT_EQ(hash_world(cut(read, CutterShape::kRocky, {8, 2, 2}, 0.7).world),
                  hash_world(cut(after, CutterShape::kRocky, {8, 2, 2}, 0.7).world));
        EXPECT_EQ(hash_world(cut(read, CutterShape::kRocky, {4, 2.5, 0}, 0.7).world),
                  hash_world(cut(after, CutterShape::kRocky, {4, 2.5, 0}, 0.7).world));
    }
}

/// Whose air a pocket is: the room's from which it was shot, else the one whose wall it opened most of.
TEST(CarveRooms, APocketIsTheRoomsThatItWasShotFrom) {
    const World world = two_halves();
    const Cutter cutter = make_crater(CutterShape::kBox, 3);
    const Pose pose{.position = {4.2, 2, -0.3}, .scale = 1};
    const Vec3 inside{3.9, 2, -0.5};
    const std::pair<std::optional<Vec3>, std::uint32_t> expected[] = {
        {std::nullopt, 1}, {Vec3{1, 1, 1}, 0}, {Vec3{7, 1, 1}, 1}, {Vec3{0, 0, -9}, 1}, {Vec3{INFINITY, 0, 0}, 1}};
    for (const auto& [from, room] : expected) {
        const CarveResult result = carve(world, cutter, pose, {"", from});
        ASSERT_TRUE(result.done());
        test::expect_sound_world(result.world);
        EXPECT_EQ(locate(result.world, inside), in_room(room));
    }
}

TEST(CarveRooms, ACavityIsARoomThroughEdits) {
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
    const World cavity = result.world;
    // Opened from above, it is a room with a portal.
    result = cut(cavity, CutterShape::kBox, {1.5, 2, -0.8}, 1);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(locate(result.world, {1.5, 2, -2}), in_room(2));
    EXPECT_EQ(find_path(result.world, {0}, {2})->size(), 1u);
    EXPECT_EQ(locate(result.world, {7, 1, 1}), in_room(1));
    // Swallowed whole, it is part of the room around it.
    result = cut(cavity, CutterShape::kBox, {1.5, 2, -1.5}, 2.5);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(locate(result.world, {1.5, 2, -2}), in_room(0));
    EXPECT_EQ(room_info(result.world, {2})->merged_into, RoomId{0});
    EXPECT_EQ(hash_world(unpack_world(pack_world(result.world), "test").value()), hash_world(result.world));
}

/// A pillar goes, and its air is that of the room that it stood in.
/// Six corners, each so far from the middle along an axis.
Cutter octahedron(double reach) {
    const std::vector<Vec3> corners{{reach, 0, 0},  {0, reach, 0},  {0, 0, reach},
                                    {-reach, 0, 0}, {0, -reach, 0}, {0, 0, -reach}};
    const std::vector<CutterTriangle> triangles{{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                                                {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
    return make_cutter(corners, triangles).value();
}

/// All corners of the cavity lie on the cutter: none of them tells that it is in it.
TEST(CarveRooms, ACavityThatTouchesWhatSwallowsItIsPartOfIt) {
    const Vec3 middle{1.5, 2, -2};
    const CarveResult cavity = carve(two_halves(), octahedron(0.5), {.position = middle});
    ASSERT_TRUE(cavity.done());
    ASSERT_EQ(cavity.world.room_count(), 3u);
    // With a second box, which makes a room: what a cutter opens in one piece is not looked at so closely.
    test::TriangleMesh boxes = test::box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    boxes.add(test::box_mesh({2, -0.5, -0.5}, {3, 0.5, 0.5}));
    const CarveResult result = carve(cavity.world, boxes.cutter().value(), {.position = middle});
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(result.world.room_count(), 4u);
    EXPECT_EQ(locate(result.world, middle), in_room(2));
    EXPECT_EQ(locate(result.world, middle + Vec3{0.4, 0.4, 0.4}), in_room(2));
    EXPECT_EQ(locate(result.world, middle + Vec3{2.5, 0, 0}), in_room(3));
}

TEST(CarveRooms, APillarThatGoesIsAir) {
    const World pillar = cut(two_halves(), CutterShape::kBox, {1.5, 2, 2}, 0.3, true).world;
    const CarveResult result = cut(pillar, CutterShape::kRocky, {1.5, 2, 2}, 1.2);
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(locate(result.world, {1.5, 2, 2}), in_room(0));
    EXPECT_EQ(portal_count(result.world), 1u);
    EXPECT_EQ(hash_solid(result.world), hash_solid(two_halves()));
}

/// Craters side by side at one wall: what they take of it is one portal, of few polygons.
TEST(CarveRooms, PiecesOfPortalsInOnePlaneBecomeOne) {
    World world = two_halves();
    for (int k = 0; k < 6; ++k) {
        const CarveResult result = cut(world, CutterShape::kBox, {4.1, 0.6 + 0.5 * k, -0.2}, 0.6);
        ASSERT_TRUE(result.done());
        test::expect_sound_world(result.world);
        world = result.world;
    }
    EXPECT_EQ(portal_count(world), 2u);
    std::set<const SolidFace*> sheets;
    const Portal& hole = world.data().cells.portal(1);
    for (std::size_t k = 0; k < hole.all_polygons().size(); ++k) sheets.insert(hole.exact(k));
    EXPECT_EQ(sheets.size(), 1u);
    EXPECT_EQ(hash_world(unpack_world(pack_world(world), "test").value()), hash_world(world));
}

/// A beam through a portal, shot at both ends: what it bounded is air then, of the room that it was shot from last, and
/// its walls in the other one are a portal.
TEST(CarveRooms, APieceThatLeavesIsAir) {
    const World world = two_halves();
    const std::array<Vec3, 8> corners = {Vec3{-2.5, -0.3, -0.3}, {2.5, -0.3, -0.3}, {2.5, 0.3, -0.3}, {-2.5, 0.3, -0.3},
                                         {-2.5, -0.3, 0.3},      {2.5, -0.3, 0.3},  {2.5, 0.3, 0.3},  {-2.5, 0.3, 0.3}};
    const std::array<CutterTriangle, 12> triangles = {CutterTriangle{0, 2, 1},
                                                      {0, 3, 2},
                                                      {4, 5, 6},
                                                      {4, 6, 7},
                                                      {0, 1, 5},
                                                      {0, 5, 4},
                                                      {1, 2, 6},
                                                      {1, 6, 5},
                                                      {2, 3, 7},
                                                      {2, 7, 6},
                                                      {3, 0, 4},
                                                      {3, 4, 7}};
    const Cutter beam = make_cutter(corners, triangles, "beam").value();
    // From one far wall to the other: x from -0.5 to 8.5.
    const CarveResult filled = fill(world, beam, {.position = {4, 2, 2}, .scale = 1.8});
    ASSERT_TRUE(filled.done());
    test::expect_sound_world(filled.world);
    ASSERT_LT(area_of(filled.world, {0}), 15.5) << "the portal lost what the beam fills";
    for (const double first : {1.0, 7.0}) {
        CarveOptions options;
        options.chunks.emplace();
        const Cutter blast = make_crater(CutterShape::kBox, 3);
        CarveResult result = carve(filled.world, blast, {.position = {first, 2, 2}, .scale = 0.9}, options);
        ASSERT_TRUE(result.done());
        EXPECT_EQ(result.chunks.size(), 0u);
        result = carve(result.world, blast, {.position = {8 - first, 2, 2}, .scale = 0.9}, options);
        ASSERT_TRUE(result.done());
        ASSERT_EQ(result.chunks.size(), 1u);
        test::expect_sound_world(result.world);
        EXPECT_EQ(room_info(result.world, {1})->merged_into, RoomId{1});
        const std::uint32_t last = first == 1 ? 1 : 0;
        EXPECT_EQ(locate(result.world, {3.7, 2, 2}), in_room(last));
        EXPECT_EQ(locate(result.world, {4.3, 2, 2}), in_room(last));
        EXPECT_EQ(locate(result.world, {3, 1, 1}), in_room(0));
        EXPECT_EQ(locate(result.world, {5, 1, 1}), in_room(1));
        EXPECT_EQ(result.report.portals, 1u);
        scenes::Rng rng(5);
        expect_casts_agree(result.world, {4, 2, 2}, 2, rng, 200);
        EXPECT_EQ(hash_world(unpack_world(pack_world(result.world), "test").value()), hash_world(result.world));
    }
}

/// By the rule that a caller may choose: rooms become one where carvings opened enough of the walls, but not at a door
/// that is shut.
TEST(CarveRooms, RoomsBecomeOneByShare) {
    const auto rooms_after = [](double share, bool open) {
        WorldParts parts = two_halves_parts();
        parts.portals[0].open = open;
        parts.options.rules.merge_share = share;
        const CarveResult result = cut(assemble_world(std::move(parts)).value(), CutterShape::kBox, {4, 2, 0}, 1);
        EXPECT_TRUE(result.done());
        test::expect_sound_world(result.world);
        const World read = unpack_world(pack_world(result.world), "test").value();
        EXPECT_EQ(hash_world(read), hash_world(result.world));
        EXPECT_EQ(read.data().rules->merge_share, share);
        return room_info(result.world, {1})->merged_into == RoomId{0} ? 1 : 2;
    };
    EXPECT_EQ(rooms_after(0, true), 2);
    EXPECT_EQ(rooms_after(0.9, true), 2);
    EXPECT_EQ(rooms_after(0.001, true), 1);
    EXPECT_EQ(rooms_after(0.001, false), 2);
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
    EXPECT_EQ(room_info(result.world, {1})->merged_into, RoomId{1});
    EXPECT_EQ(locate(result.world, {3.3, 2, 2}), in_room(0));
    EXPECT_EQ(locate(result.world, {4.7, 2, 2}), in_room(1));
    EXPECT_NEAR(area_of(result.world, {0}), 16 - 1, 0.2);
    EXPECT_EQ(hash_world(unpack_world(pack_world(result.world), "test").value()), hash_world(result.world));
}

/// A body that fills a doorway: the portal goes, and comes back as a hole.
TEST(CarveRooms, AFilledPortalGoes) {
    for (const bool open : {true, false}) {
        const World world = two_halves(open);
        const CarveResult filled = cut(world, CutterShape::kBox, {4, 2, 2}, 2.5, true);
        ASSERT_TRUE(filled.done());
        test::expect_sound_world(filled.world);
        EXPECT_EQ(portal_info(filled.world, {0})->polygons, 0u);
        EXPECT_EQ(diff_worlds(world, filled.world).portals_removed, std::vector<PortalId>{{0}});
        EXPECT_EQ(locate(filled.world, {0.5, 2, 2}), in_room(0));
        EXPECT_EQ(locate(filled.world, {7.5, 2, 2}), in_room(1));
        EXPECT_FALSE(find_path(filled.world, {0}, {1}, Doors::kAllOpen));
        const std::optional<World> turned = set_portal_open(filled.world, {0}, !open);
        ASSERT_TRUE(turned);
        EXPECT_EQ(&turned->data(), &filled.world.data()) << "nobody can open or shut what is gone";
        EXPECT_EQ(apply(filled.world, door_command(9, {0}, !open)).status, CarveStatus::kNothing);
        const CarveResult again = cut(filled.world, CutterShape::kRocky, {4, 2, 2}, 4);
        ASSERT_TRUE(again.done());
        test::expect_sound_world(again.world);
        ASSERT_EQ(portal_count(again.world), 2u);
        EXPECT_TRUE(portal_info(again.world, {1})->open);
        EXPECT_EQ(find_path(again.world, {0}, {1})->size(), 1u);
    }
}

/// It stands on its corner where the portal's rim lies between the floors of both rooms: the rim is divided there, and
/// the floors with it.
TEST(CarveRooms, AFillThatTouchesARimInAPoint) {
    for (const bool open : {true, false}) {
        const World world = two_halves(open);
        const CarveResult result = fill(world, octahedron(1), {.position = {4, 2, 1}});
        ASSERT_TRUE(result.done());
        test::expect_sound_world(result.world);
        EXPECT_EQ(room_info(result.world, {1})->merged_into, RoomId{1});
        EXPECT_EQ(locate(result.world, {3.4, 2, 0.1}), in_room(0));
        EXPECT_EQ(locate(result.world, {4.6, 2, 0.1}), in_room(1));
        EXPECT_EQ(portal_info(result.world, {0})->open, open);
        EXPECT_EQ(area_of(result.world, {0}), 16 - 2);
        EXPECT_EQ(hash_world(unpack_world(pack_world(result.world), "test").value()), hash_world(result.world));
        // And a hole beside it, where floors are pieces of themselves by now.
        const CarveResult hole = cut(result.world, CutterShape::kRocky, {4, 1, 0}, 0.7);
        ASSERT_TRUE(hole.done());
        test::expect_sound_world(hole.world);
        EXPECT_EQ(room_info(hole.world, {1})->merged_into, RoomId{1});
    }
}

/// It takes the walls on both sides of a portal's rim, and has an edge of its own there, which runs on over a corner of
/// the portal: the corner stays.
TEST(CarveRooms, AFillWhoseEdgeRunsOverAPortalsCorner) {
    // Where it touches the rim there is a corner, in the middle of an edge.
    const World world = fill(two_halves(), octahedron(1), {.position = {4, 3, 2}}).world;
    std::vector<Vec3> corners;
    for (const double z : {1.0, 3.0})
        for (const auto& [x, y] : {std::pair(2, 3), {4, 4}, {6, 3}, {6, 5}, {2, 5}})
            corners.push_back({double(x), double(y), z});
    std::vector<CutterTriangle> triangles{{0, 4, 1}, {1, 4, 3}, {1, 3, 2}, {5, 6, 9}, {6, 8, 9}, {6, 7, 8}};
    for (std::uint32_t k = 0; k < 5; ++k) {
        const std::uint32_t next = (k + 1) % 5;
        triangles.push_back({k, next, next + 5});
        triangles.push_back({k, next + 5, k + 5});
    }
    const CarveResult result = fill(world, make_cutter(corners, triangles).value(), {});
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(room_info(result.world, {1})->merged_into, RoomId{1});
    EXPECT_EQ(area_of(result.world, {0}), 16 - 2);
    EXPECT_EQ(locate(result.world, {3.5, 3.5, 1.2}), in_room(0));
    EXPECT_EQ(locate(result.world, {4.5, 3.5, 1.2}), in_room(1));
}

/// Fills at every place of a portal: its rim, its middle, flush with it.
TEST(CarveRooms, FillsAtAPortal) {
    scenes::Rng rng(3);
    int clipped = 0;
    for (int k = 0; k < 150 && !HasFailure(); ++k) {
        SCOPED_TRACE(k);
        World world = two_halves(rng.chance(0.5));
        for (int edits = 0; edits < 3; ++edits) {
            Vec3 at{rng.uniform(3.2, 4.8), rng.uniform(-0.3, 4.3), rng.uniform(-0.3, 4.3)};
            if (rng.chance(0.3))
                for (int axis = 0; axis < 3; ++axis) at[axis] = std::round(at[axis] * 2) / 2;
            const auto shape = CutterShape(rng.below(3));
            const double before = area_of(world, {0});
            const CarveResult result = cut(world, shape, at, rng.chance(0.3) ? 1 : rng.uniform(0.2, 1.2), edits != 1);
            ASSERT_NE(result.status, CarveStatus::kRefused) << result.error.text();
            if (!result.done()) continue;
            test::expect_sound_world(result.world);
            expect_casts_agree(result.world, {4, 2, 2}, 2.5, rng, 40);
            EXPECT_EQ(room_info(result.world, {1})->merged_into, RoomId{1});
            clipped += area_of(result.world, {0}) < before - 1e-6;
            world = result.world;
        }
        EXPECT_EQ(hash_world(unpack_world(pack_world(world), "test").value()), hash_world(world));
    }
    EXPECT_GT(clipped, 60);
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
    int holed = 0, alone = 0;
    for (int k = 0; k < 60 && !HasFailure(); ++k) {
        World world = assemble_world(two_halves_parts(40)).value();
        for (int cuts = 0; cuts < 3; ++cuts) {
            Vec3 at{rng.uniform(0, 80), rng.uniform(0, 40), rng.uniform(0, 40)};
            at[int(rng.below(3))] = 0;
            if (rng.chance(0.3)) at.x = rng.uniform(39.2, 40.8);
            const CarveResult result = cut(world, CutterShape::kRocky, at, 1, rng.chance(0.3));
            ASSERT_NE(result.status, CarveStatus::kRefused) << result.error.text();
            test::expect_sound_world(result.world);
            expect_casts_agree(result.world, at, 3, rng, 60);
            world = result.world;
        }
        portal_count(world) == 1 ? ++alone : ++holed;
    }
    EXPECT_GT(holed, 5);
    EXPECT_GT(alone, 5);
}

CarveResult cut_box(const World& world, const Vec3& low, const Vec3& high) {
    return carve(world, test::box_mesh(low, high).cutter().value(), {});
}

/// A box that ends in a portal's plane touches the other room's walls along an edge alone: it takes nothing of them.
TEST(CarveRooms, AHoleAlongAPortalIsTheRoomsWhoseWallItTook) {
    const World world = two_halves();
    for (const std::uint32_t room : {0u, 1u}) {
        const double x = room == 0 ? 3 : 4;
        const CarveResult result = cut_box(world, {x, 1, -0.5}, {x + 1, 2, 0.5});
        ASSERT_TRUE(result.done());
        test::expect_sound_world(result.world);
        EXPECT_EQ(portal_count(result.world), 1u);
        EXPECT_EQ(locate(result.world, {x + 0.5, 1.5, -0.25}), in_room(room));
    }
}

/// In the rock, along an edge of a room's walls: nothing of a wall goes, so it is a room of its own.
TEST(CarveRooms, APocketThatTouchesWallsAlongAnEdgeIsARoom) {
    const World world = two_halves();
    for (const double y : {-1.0, 1.0}) {
        const CarveResult result = cut_box(world, {1, y, -1}, {2, y + 1, 0});
        ASSERT_TRUE(result.done());
        test::expect_sound_world(result.world);
        const bool at_edge = y < 0;
        EXPECT_EQ(result.world.room_count(), at_edge ? 3u : 2u);
        EXPECT_EQ(locate(result.world, {1.5, y + 0.5, -0.5}), in_room(at_edge ? 2 : 0));
    }
}

/// Beside a doorway of the depot, through a wall of a metre, ending in its far side's plane, and deeper than the floor:
/// where edges of the walls end on one line, edges of the pocket end as well. (tests/full/full_blasts.cpp, depot,
/// seed=1 case=0.)
TEST(CarveRooms, EdgesOnOneLineEndWhereThoseOfWallsDo) {
    const World world = make_world(test::depot_level()).value();
    const CarveResult result = cut_box(world, {4, 14, 3.75}, {7.5, 15.5, 6.75});
    ASSERT_TRUE(result.done());
    test::expect_sound_world(result.world);
    EXPECT_EQ(reference::unclosed_room(result.world), "");
}

/// Rooms stay apart, however many holes there are, and portals grow no faster than craters.
TEST(CarveRooms, TheDepotKeepsItsRoomsAndPortals) {
    struct Count {
        std::size_t rooms = 0, portals = 0;
        explicit Count(const World& world) {
            for (std::uint32_t k = 0; k < world.room_count(); ++k)
                rooms += room_info(world, {k})->merged_into == RoomId{k};
            for (std::uint32_t k = 0; k < portal_count(world); ++k) portals += portal_info(world, {k})->polygons > 0;
        }
    };
    World world = make_world(test::depot_level()).value();
    const Count before(world);
    ASSERT_GE(before.rooms, 22u);
    const Box box = world.bounds();
    scenes::Rng rng(16);
    const std::size_t craters = test::sample(200);
    for (std::size_t done = 0; done < craters;) {
        Sphere start;
        for (int axis = 0; axis < 3; ++axis) start.centre[axis] = rng.uniform(box.low[axis], box.high[axis]);
        const Vec3 path = rng.direction() * 50.0;
        if (locate(world, start.centre).where != Where::kAir) continue;
        const Hit hit = cast(world, start, path);
        if (!hit.touched()) continue;
        const Pose pose{hit.point, random_turn(rng.next()), rng.uniform(0.4, 1.2)};
        CarveOptions options;
        if (rng.chance(0.5)) options.from = start.centre;
        const CarveResult result = carve(world, make_crater(CutterShape::kRocky, rng.next()), pose, options);
        if (!result.done()) continue;
        world = result.world;
        ++done;
        if (done % 50 > 0 && done < craters) continue;
        const Count after(world);
        EXPECT_GE(after.rooms, before.rooms);
        EXPECT_GE(after.portals, before.portals);
        EXPECT_LE(after.portals, before.portals + done);
    }
    test::expect_sound_world(world);
    EXPECT_EQ(reference::unclosed_room(world), "");
}

TEST(CarveRooms, ManyCutsInBuildings) {
    for (const bool outdoors : {false, true}) {
        const DividedBuilding building({.rooms_x = 4, .rooms_y = 4, .rooms_z = 2, .outdoors = outdoors, .seed = 11});
        World world = assemble_world(building.parts()).value(), one_room = make_world(building.level()).value();
        scenes::Rng rng(outdoors ? 5 : 6);
        std::size_t done = 0, holed = 0, alone = 0;
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
            EXPECT_GE(result.world.face_count(), plain.world.face_count()) << "divided where rooms meet";
            expect_casts_agree(result.world, pose.position, 2, rng, 150);
            const WorldDiff diff = diff_worlds(world, result.world);
            EXPECT_EQ(diff.removed.size(), result.report.faces_removed);
            EXPECT_EQ(diff.added.size(), result.report.faces_added);
            const std::vector<World> both{world, result.world};
            EXPECT_EQ(bytes_alone(result.world, world), memory_used(both) - memory_used(world));
            portal_count(result.world) > portal_count(world) ? ++holed : ++alone;
            world = result.world;
            one_room = plain.world;
        }
        EXPECT_GT(done, 20u);
        EXPECT_GT(holed, 3u);
        EXPECT_GT(alone, 7u);
        const World read = unpack_world(pack_world(world), "test").value();
        EXPECT_EQ(hash_world(read), hash_world(world));
    }
}

}  // namespace
}  // namespace firma

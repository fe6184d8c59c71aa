// SPDX-License-Identifier: MIT
// Fills where portals touch each other, and not along an edge that both have: rooms stay apart.
#include <gtest/gtest.h>

#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "tests/carve/cutters.h"
#include "tests/world/hand_made_rooms.h"
#include "world/assemble_world.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// A hall 8 m wide, of three rooms. Room 0 lies below z = 0, and above it, up to two slopes that come up from the
/// middle of its ceiling, room 1; room 2 lies above these. The slopes touch the inside of the portal between rooms 0
/// and 1.
WorldParts wedge_parts() {
    const auto at = test::at_metres;
    test::HandMadeRooms rooms(3);
    const GridPoint south = at(0, -1, 0), north = at(0, 7, 0);
    rooms.add(0, {at(-4, 0, -4), at(0, -1, -4), at(4, 0, -4), at(4, 6, -4), at(0, 7, -4), at(-4, 6, -4)});
    rooms.add(0, {at(-4, 0, -4), at(-4, 6, -4), at(-4, 6, 0), at(-4, 0, 0)});
    rooms.add(0, {at(4, 0, -4), at(4, 0, 0), at(4, 6, 0), at(4, 6, -4)});
    rooms.add(0, {at(4, 0, -4), at(0, -1, -4), south, at(4, 0, 0)});
    rooms.add(0, {at(0, -1, -4), at(-4, 0, -4), at(-4, 0, 0), south});
    rooms.add(0, {at(-4, 6, -4), at(0, 7, -4), north, at(-4, 6, 0)});
    rooms.add(0, {at(0, 7, -4), at(4, 6, -4), at(4, 6, 0), north});
    rooms.add(1, {at(-4, 0, 0), at(-4, 6, 0), at(-4, 6, 4), at(-4, 0, 4)});
    rooms.add(1, {at(4, 0, 0), at(4, 0, 4), at(4, 6, 4), at(4, 6, 0)});
    rooms.add(1, {south, at(-4, 0, 0), at(-4, 0, 4)});
    rooms.add(1, {south, at(4, 0, 4), at(4, 0, 0)});
    rooms.add(1, {north, at(-4, 6, 4), at(-4, 6, 0)});
    rooms.add(1, {north, at(4, 6, 0), at(4, 6, 4)});
    rooms.add(2, {at(-4, 0, 4), at(-4, 6, 4), at(4, 6, 4), at(4, 0, 4)});
    rooms.add(2, {south, at(-4, 0, 4), at(4, 0, 4)});
    rooms.add(2, {north, at(4, 6, 4), at(-4, 6, 4)});
    rooms.add_portal(1, 0, {{at(-4, 0, 0), south, at(4, 0, 0), at(4, 6, 0), north, at(-4, 6, 0)}});
    rooms.add_portal(1, 2, {{south, at(-4, 0, 4), at(-4, 6, 4), north}, {south, north, at(4, 6, 4), at(4, 0, 4)}});
    return rooms.parts;
}

TEST(FillsBetweenPortals, OneThatTouchesTheInsideOfAnotherDoesNotDivideIt) {
    const World hall = assemble_world(wedge_parts()).value();
    test::expect_sound_world(hall);
    struct Body {
        Vec3 low, high;
    };
    const Body bodies[] = {{{1, 2, -0.5}, {2, 3, 0.5}},        // in one portal alone, with the others beside it
                           {{-1, 2, -0.5}, {1.5, 3, 0.5}},     // where they touch
                           {{-1, -0.5, -0.5}, {1.5, 6, 0.5}},  // likewise, and along most of it
                           {{-1, 2, -0.5}, {0, 3, 0.5}},       // with an edge along it
                           {{-1, 2, 0}, {1, 3, 1}},            // flush with one of them
                           {{-1, 2, -1}, {1, 3, 0}}};
    for (const bool cut_before : {false, true})
        for (const Body& body : bodies) {
            SCOPED_TRACE(body.low.y);
            World world = hall;
            // A pillar beside it, which divides rims.
            if (cut_before) world = fill(world, test::box_mesh({-0.5, 4, -1}, {0.5, 5, 1}).cutter().value(), {}).world;
            const CarveResult result = fill(world, test::box_mesh(body.low, body.high).cutter().value(), {});
            ASSERT_TRUE(result.done());
            test::expect_sound_world(result.world);
            for (std::uint32_t room = 0; room < 3; ++room)
                EXPECT_EQ(room_info(result.world, {room})->merged_into, RoomId{room});
            EXPECT_EQ(portal_count(result.world), 2u);
            EXPECT_EQ(locate(result.world, {3, 1, -0.1}).room, RoomId{0});
            EXPECT_EQ(locate(result.world, {-3, 1, 0.1}).room, RoomId{1});
            EXPECT_EQ(locate(result.world, {0, 1, 1.5}).room, RoomId{2});
            const CarveResult hole = carve(result.world, make_crater(CutterShape::kRocky, 3), {.position = body.high});
            ASSERT_TRUE(hole.done());
            test::expect_sound_world(hole.world);
        }
}

/// What a fill leaves of a portal may be thinner than rounding: a strip 1/4,000 of a step wide along another body.
TEST(FillsBetweenPortals, OneThatLeavesAStripThinnerThanRounding) {
    World world = assemble_world(wedge_parts()).value();
    const auto put = [&](const test::TriangleMesh& mesh) {
        const CarveResult result = fill(world, mesh.cutter().value(), {});
        ASSERT_TRUE(result.done());
        world = result.world;
        test::expect_sound_world(world);
    };
    put(test::box_mesh({1, 1, -0.5}, {3, 2, 0.5}));
    put(test::box_mesh({1, 1.5, -0.5}, {1.5, 3, 0.5}));
    put(test::box_mesh({2.5, 1.5, -0.5}, {3, 3, 0.5}));
    // Between these three, its lower side turned so that it lies 1/4095 of a step above y = 2 where z = 0.
    constexpr double kStep = 1 / kInputSteps;
    test::TriangleMesh turned = test::box_mesh({1.25, 2, -0.5}, {2.75, 2.75, 0.5 - kStep});
    for (Vec3& vertex : turned.vertices)
        if (vertex.y == 2) vertex.y += vertex.z < 0 ? -kStep : kStep;
    put(turned);
    for (std::uint32_t room = 0; room < 3; ++room) EXPECT_EQ(room_info(world, {room})->merged_into, RoomId{room});
    EXPECT_EQ(portal_count(world), 2u);
}

/// A body in one room of which a corner lies on a portal: each of its faces bounds that room.
TEST(FillsBetweenPortals, OneThatTouchesAPortalInAPoint) {
    const World hall = assemble_world(wedge_parts()).value();
    const auto tip = [](double x, double height) {
        test::TriangleMesh mesh;
        mesh.vertices = {{x, 2, 0}, {x - 0.25, 2.25, height}, {x + 0.25, 2.25, height}, {x, 1.5, height}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
        if (height < 0) mesh.turn_over();
        return mesh.cutter().value();
    };
    for (const bool below : {false, true}) {
        World world = hall;
        for (const double x : {2.0, -2.0}) {
            const CarveResult result = fill(world, tip(x, below ? -0.5 : 0.5), {});
            ASSERT_TRUE(result.done());
            world = result.world;
            test::expect_sound_world(world);
        }
        EXPECT_EQ(room_info(world, {below ? 0u : 1u})->faces, room_info(hall, {below ? 0u : 1u})->faces + 8);
        EXPECT_EQ(room_info(world, {below ? 1u : 0u})->faces, room_info(hall, {below ? 1u : 0u})->faces);
    }
}

}  // namespace
}  // namespace firma

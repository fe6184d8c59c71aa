// SPDX-License-Identifier: MIT
// Cuts at an edge where a room has portals only, no face: the room does not lie in the way, but its portals change.
#include <gtest/gtest.h>

#include <vector>

#include "firma/carve.h"
#include "firma/edit_log.h"
#include "firma/rooms.h"
#include "firma/versions.h"
#include "scenes/blast_worlds.h"
#include "scenes/blasts.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_logs.h"
#include "tests/world/hand_made_rooms.h"
#include "world/assemble_world.h"
#include "world/world_data.h"

namespace firma {
namespace {

constexpr int kStrips = 9, kStripLength = 2;  ///< along y; metres

/// A hall 8 m wide and 4 m high. Room 2 is what lies above two slopes that come up from the middle of the floor; below
/// these lie room 0, at -x, and room 1. A portal for each slope and strip.
WorldParts valley_parts() {
    const auto at = test::at_metres;
    test::HandMadeRooms rooms(3);
    for (int strip = 0; strip < kStrips; ++strip) {
        const int a = strip * kStripLength, b = a + kStripLength;
        rooms.add(0, {at(-4, a, 0), at(0, a, 0), at(0, b, 0), at(-4, b, 0)});
        rooms.add(0, {at(-4, a, 0), at(-4, b, 0), at(-4, b, 4), at(-4, a, 4)});
        rooms.add(1, {at(0, a, 0), at(4, a, 0), at(4, b, 0), at(0, b, 0)});
        rooms.add(1, {at(4, a, 0), at(4, a, 4), at(4, b, 4), at(4, b, 0)});
        rooms.add(2, {at(-4, a, 4), at(-4, b, 4), at(4, b, 4), at(4, a, 4)});
        rooms.add_portal(0, 2, {{at(0, a, 0), at(-4, a, 4), at(-4, b, 4), at(0, b, 0)}});
        rooms.add_portal(1, 2, {{at(0, a, 0), at(0, b, 0), at(4, b, 4), at(4, a, 4)}});
    }
    const int end = kStrips * kStripLength;
    rooms.add(0, {at(0, 0, 0), at(-4, 0, 0), at(-4, 0, 4)});
    rooms.add(1, {at(0, 0, 0), at(4, 0, 4), at(4, 0, 0)});
    rooms.add(2, {at(0, 0, 0), at(-4, 0, 4), at(4, 0, 4)});
    rooms.add(0, {at(0, end, 0), at(-4, end, 4), at(-4, end, 0)});
    rooms.add(1, {at(0, end, 0), at(4, end, 0), at(4, end, 4)});
    rooms.add(2, {at(0, end, 0), at(4, end, 4), at(-4, end, 4)});
    return rooms.parts;
}

/// More portals than a room lists: it has an index over them, which each cut must keep up.
TEST(CarvePortalEdges, ARoomThatOnlyHasPortalsThereKeepsUp) {
    World world = assemble_world(valley_parts()).value();
    test::expect_sound_world(world);
    ASSERT_GT(room_info(world, {2})->portals.size(), Cells::kListed);
    const auto cut_at = [&](const Vec3& place) {
        const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, 3), {.position = place, .scale = 0.3});
        EXPECT_TRUE(cut.done());
        EXPECT_EQ(cut.world.room_count(), 3u);
        test::expect_sound_world(cut.world);
        for (const std::uint32_t portal : {4u, 5u})  // of the strip from 4 m to 6 m
            EXPECT_EQ(&cut.world.data().cells.portal(portal) == &world.data().cells.portal(portal),
                      place.z > 0 && portal == 5u);
        return cut.world;
    };
    for (const double y : {4.6, 5.4}) {
        SCOPED_TRACE(y);
        const World before = world;
        world = cut_at({0, y, 0});
        EXPECT_EQ(world.data().faces_of(2).hash, before.data().faces_of(2).hash);  // none of its faces was met
    }
    cut_at({-4, 5, 4});  // where a portal that these changed meets the ceiling
}

/// The world after so many commands of a case of `full_logs --what repair --seed 1`.
World after_commands(std::uint64_t number, scenes::BlastWorld kind, std::size_t count) {
    scenes::Rng rng(0x9E3779B97F4A7C15ull ^ (number + 1) * 0xD1B54A32D192ED03ull);
    World world = scenes::with_closed_doors(scenes::blast_world(kind, 1'000'003 + number), 1.0 / 3, rng);
    std::vector<EditCommand> commands = reference::random_commands(world, 100, rng);
    commands.resize(count);
    for (const EditCommand& command : commands) world = apply(world, command).world;
    return world;
}

/// A fill's faces end along a portal's rim that no face had: both have one edge from then on, which a later cut divides
/// in both. The 44th command of this log is such a fill, the 57th such a cut.
TEST(CarvePortalEdges, AFillThatEndsAtARimSharesItsEdges) {
    test::expect_sound_world(after_commands(146, scenes::BlastWorld::kInRock, 57));
}

/// Two parts of a wall that the last cut takes meet in a corner alone, through which only a line passes in what stays:
/// the edge ends there all the same, as the portal that the parts become has it in two.
TEST(CarvePortalEdges, PartsThatMeetInACornerHaveEdgesUpToIt) {
    test::expect_sound_world(after_commands(112, scenes::BlastWorld::kMany, 84));
}

}  // namespace
}  // namespace firma

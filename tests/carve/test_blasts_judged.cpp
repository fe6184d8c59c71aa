// SPDX-License-Identifier: MIT
// A few blasts in worlds with rooms and doors, each judged by all that must hold of rooms; ./test --full makes ten
// thousand, in maps of OpenArena too.
//
// What the judge told of the library broken on purpose, in 800 blasts of full_blasts each (2026-11-26), in cases:
// - the room that the shot came from is the last choice (room_edit.cpp): 43
// - edges of portals are not divided: 29 of 61 blasts in the world "lattice" alone
// - a portal that is divided is open: 122
// - a piece of a new portal is left out: 212
// - a fill clips no portal: 106
// - a new portal is closed: 245
// - all pockets' faces are of the first one's room: 32
// - rooms become one unasked: 143
// - cavities are pockets of their own (find_pockets.cpp): 3
// - faces of which edges alone are divided count as taken (cut_job.cpp): 2
// - faces that meet two and two share edges (clip_sheets.cpp): 1
#include <gtest/gtest.h>

#include <string>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "scenes/blast_worlds.h"
#include "scenes/blasts.h"
#include "tests/reference/judge_blast.h"
#include "tests/sample.h"

namespace firma {
namespace {

reference::BlastTally judge(const World& world, const std::string& name, std::uint64_t seed, std::size_t count) {
    scenes::Rng rng(seed);
    const World shut = scenes::with_closed_doors(world, 1.0 / 3, rng);
    const auto blasts = scenes::room_blasts(scenes::blast_places(shut), count, rng);
    const reference::BlastTally tally =
        reference::judge_blasts(shut, blasts, name + " seed=" + std::to_string(seed), seed);
    EXPECT_EQ(tally.failed, 0u);
    for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
    EXPECT_EQ(tally.cuts, count);
    EXPECT_EQ(tally.cuts, tally.done + tally.nothing + tally.refused);
    EXPECT_EQ(tally.blamed, 0u);
    return tally;
}

TEST(Blasts, InTheDepotHoldWhatMustHoldOfRooms) {
    const World depot =
        with_rules(make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value(), {}).value();
    const reference::BlastTally all = judge(depot, "depot", 1, test::sample(24));
    EXPECT_GE(all.done, 3u);
    EXPECT_GE(all.points, 20u);
}

TEST(Blasts, InSmallWorldsHoldWhatMustHoldOfRooms) {
    reference::BlastTally all;
    for (std::size_t kind = 0; kind < scenes::kBlastWorldNames.size(); ++kind)
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const std::string name(scenes::kBlastWorldNames[kind]);
            SCOPED_TRACE(name);
            all.add(judge(scenes::blast_world(scenes::BlastWorld(kind), seed), name, seed, 12));
        }
    EXPECT_GE(all.portals_made, 5u);
    EXPECT_GE(all.portal_sides, 5u);
    EXPECT_GE(all.rooms_made, 1u);
    EXPECT_GE(all.crossings, 20u);
    EXPECT_GE(all.door_casts, 20u);
    EXPECT_GE(all.open_casts, 20u);
    EXPECT_GE(all.filled, 3u);
    EXPECT_GE(all.shot_from, 10u);
}

TEST(Blasts, SameSeedsMakeSameBlasts) {
    const World world = scenes::blast_world(scenes::BlastWorld::kLattice, 1);
    const auto make = [&](std::uint64_t seed) {
        scenes::Rng rng(seed);
        const World shut = scenes::with_closed_doors(world, 1.0 / 3, rng);
        return scenes::room_blasts(scenes::blast_places(shut), 200, rng);
    };
    const auto a = make(5), b = make(5), c = make(6);
    std::array<int, scenes::kBlastNames.size()> of_family{};
    int fills = 0, others = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_TRUE(a[k].cut.cutter.valid());
        EXPECT_EQ(a[k].cut.pose.position, b[k].cut.pose.position);
        EXPECT_EQ(a[k].from, b[k].from);
        others += a[k].cut.pose.position != c[k].cut.pose.position;
        ++of_family[std::size_t(a[k].family)];
        fills += a[k].cut.kind == CarveKind::kFill;
    }
    EXPECT_GT(others, 190);
    for (const int count : of_family) EXPECT_GE(count, 5);
    EXPECT_TRUE(fills > 20 && fills < 80) << fills;
}

}  // namespace
}  // namespace firma

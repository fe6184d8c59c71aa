// SPDX-License-Identifier: MIT
// Portals are chosen with the level joined once.
#include "brush/choose_portals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "join/join_brushes.h"
#include "tests/openarena_maps.h"
#include "tests/sample.h"

namespace firma {
namespace {

/// @return how often it was joined: whole or in part
std::size_t expect_joined_once(const BrushLevel& level) {
    const AirGrid grid = AirGrid::make(level, 1'000'000).value();
    const std::vector<Narrow> narrows = find_narrows(grid, {});
    const PortalChoice choice = choose_portals(level, grid, narrows, {}).value();
    EXPECT_GT(choice.narrows.size(), 0u);
    EXPECT_TRUE(choice.rounds.front().whole);
    EXPECT_EQ(std::count_if(choice.rounds.begin(), choice.rounds.end(), [](const JoinRound& it) { return it.whole; }),
              1);
    std::size_t faces = 0;
    for (std::size_t k = 1; k < choice.rounds.size(); ++k) faces = std::max(faces, choice.rounds[k].faces);
    EXPECT_LT(faces * 2, choice.rounds.front().faces);

    // Joined from scratch, each of them divides two rooms.
    BrushLevel divided = level;
    for (const std::uint32_t k : choice.narrows) add_portal(divided, grid, narrows[k]);
    const std::unique_ptr<JoinedLevel> joined = join_brushes(divided).value();
    std::set<std::uint32_t> sources;
    for (const JoinPortal& portal : joined->portals) sources.insert(portal.source);
    for (std::size_t b = level.brushes.size(); b < divided.brushes.size(); ++b)
        EXPECT_TRUE(sources.contains(divided.brushes[b].first_side)) << b;
    return choice.rounds.size();
}

TEST(ChoosePortals, TheDepotIsJoinedOnce) {
    BrushLevel level = read_brush_level(FIRMA_ROOT "/levels/depot.map").value();
    for (Brush& brush : level.brushes)
        if (brush.kind == BrushKind::kPortal) brush.kind = BrushKind::kData;
    EXPECT_GE(expect_joined_once(level), 4u);
}

/// Planes are moved in some of them.
TEST(ChoosePortals, MapsAreJoinedOnce) {
    const std::vector<std::string> some =
        test::sampled<std::string>({"aggressor", "ctf_gate1", "czest2ctf", "kaos2", "oa_koth1", "sleekgrinder"});
    std::size_t seen = 0;
    for (const std::filesystem::path& path : openarena_maps()) {
        if (std::find(some.begin(), some.end(), path.stem().string()) == some.end()) continue;
        SCOPED_TRACE(path);
        ++seen;
        expect_joined_once(read_brush_level(path.string()).value());
    }
    if (seen == 0) GTEST_SKIP() << kNoOpenArena;
    EXPECT_EQ(seen, some.size());
}

}  // namespace
}  // namespace firma

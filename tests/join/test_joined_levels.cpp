// SPDX-License-Identifier: MIT
// Whole levels, joined and judged: our demo level and, where they are, some maps of OpenArena; ./test --full takes all.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/openarena_maps.h"
#include "tests/reference/judge_joined.h"
#include "tests/sample.h"

namespace firma {
namespace {

reference::JoinedVerdict judge_file(const std::string& path) {
    return reference::judge_joined(read_brush_level(path).value(), 7, 100);
}

TEST(JoinedLevels, TheDepot) {
    const reference::JoinedVerdict verdict = judge_file(FIRMA_ROOT "/levels/depot.map");
    EXPECT_EQ(verdict.fault, "");
    EXPECT_EQ(verdict.planes_moved, 0u);
    EXPECT_EQ(verdict.left_out, 0u);
    EXPECT_GT(verdict.points, 80u);
    EXPECT_GE(verdict.crossings, verdict.portals);
    EXPECT_GT(verdict.volume, 100'000);
}

/// Small ones, with and without area portals; czest1dm and delta are of those in which planes are moved.
TEST(JoinedLevels, SomeMapsOfOpenArena) {
    const std::vector<std::string> some =
        test::sampled<std::string>({"aggressor", "am_galmevish", "czest1dm", "delta", "kaos2", "oa_dm5"});
    std::size_t judged = 0;
    for (const std::filesystem::path& path : openarena_maps()) {
        if (std::find(some.begin(), some.end(), path.stem().string()) == some.end()) continue;
        ++judged;
        const reference::JoinedVerdict verdict = judge_file(path.string());
        EXPECT_EQ(verdict.fault, "") << path;
        EXPECT_EQ(verdict.left_out, 0u) << path;
        EXPECT_TRUE(verdict.portals == 0 || verdict.crossings > 0) << path;
    }
    if (judged == 0) GTEST_SKIP() << kNoOpenArena;
    EXPECT_EQ(judged, some.size());
}

}  // namespace
}  // namespace firma

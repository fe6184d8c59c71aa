// SPDX-License-Identifier: MIT
// Same worlds everywhere: hashes after cuts of several families, the same for every compiler and its options.
#include <gtest/gtest.h>

#include "base/hasher.h"
#include "tests/reference/judge_cut.h"

namespace firma {
namespace {

TEST(SameBits, WorldsAfterAHundredCuts) {
    const Level ours = read_level(FIRMA_ROOT "/levels/first.obj").value();
    Hasher hasher;
    int done = 0;
    for (const scenes::CutFamily& family : scenes::cut_families()) {
        const scenes::CutCase it = scenes::make_cut_case(family, 9, 0, ours);
        World world = make_world(it.level).value();
        for (std::size_t k = 0; k < it.cuts.size() && k < 8; ++k) {
            const CarveResult result = reference::make_cut(world, it.cuts[k]);
            done += result.done();
            world = result.world;
        }
        hasher.add(hash_world(world));
    }
    EXPECT_GE(done, 100);
    EXPECT_EQ(hasher.value(), 1769331680462763490ull) << hasher.value();
}

}  // namespace
}  // namespace firma

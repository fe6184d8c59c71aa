// SPDX-License-Identifier: MIT
// Parts that are carved in their own frame; portals that a shut door closes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "firma/carve.h"
#include "firma/part_edits.h"
#include "firma/rooms.h"
#include "tests/brush/depot_level.h"
#include "tests/moving/part_worlds.h"

namespace firma {
namespace {

/// A blast at a place of the world takes of a turned part what lies there.
TEST(PartEdits, BlastsTakeOfAPartWhereItIs) {
    scenes::Rng rng(41);
    const Cutter crater = make_crater({}, 7);
    for (int k = 0; k < 6; ++k) {
        MovingPart part(test::box_world({-2, -2, -1}, {2, 2, 0}), test::random_motion(rng, k % 3, 1));
        const double fraction = 0.25 * k / 2;
        const Vec3 on_top = test::part_point(part.motion, fraction, {0.5, 0.25, 0});
        Pose blast;
        blast.position = on_top;
        blast.rotation = random_turn(rng.next());
        blast.scale = 0.5;
        const Pose seen = pose_in_part(part, fraction, blast);
        // The same point of the cutter, by the world and by the part.
        const Vec3 of_cutter{0.3, -0.7, 0.2};
        const Vec3 in_world = blast.position + matrix_of(normalised(blast.rotation)) * of_cutter * blast.scale;
        const Vec3 in_part = seen.position + matrix_of(seen.rotation) * of_cutter * seen.scale;
        EXPECT_LT(length(test::part_point(part.motion, fraction, in_part) - in_world), 1e-12);
        const World empty;
        const auto gap = [&] { return closest(Scene{empty, {&part, 1}}, on_top, kEverywhere, fraction).distance; };
        EXPECT_LT(gap(), 1e-9);
        const CarveResult cut = carve(part.world(), crater, seen);
        ASSERT_NE(cut.world.version(), part.world().version());
        part.set_world(cut.world);
        EXPECT_GT(gap(), 0.1);
    }
}

TEST(PartEdits, DoorsClosePortalsThatTheyCover) {
    const World depot = make_world(test::depot_level()).value();
    std::size_t closed = 0;
    for (std::uint32_t k = 0; k < portal_count(depot); ++k) {
        const PortalInfo info = portal_info(depot, {k}).value();
        const Vec3 size = info.bounds.high - info.bounds.low, middle = (info.bounds.low + info.bounds.high) * 0.5;
        const Vec3 half = size * 0.5 + Vec3{0.0625, 0.0625, 0.0625};
        RigidMotion motion;
        motion.position = middle;
        const auto has = [&](const MovingPart& part) {
            const std::vector<PortalId> found = portals_closed_by(depot, part);
            return std::count(found.begin(), found.end(), PortalId{k}) == 1;
        };
        EXPECT_TRUE(has(MovingPart(test::box_world(-half, half), motion))) << k;
        const int longest = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        Vec3 part_of_it = half, aside;
        part_of_it[longest] *= 0.5;
        aside[longest] = 2 * half[longest];
        EXPECT_FALSE(has(MovingPart(test::box_world(-part_of_it, part_of_it), motion))) << k;
        motion.position = middle + aside;  // open
        EXPECT_FALSE(has(MovingPart(test::box_world(-half, half), motion))) << k;
        ++closed;
    }
    EXPECT_GT(closed, 10u);
    MovingPart bad(test::leaf_world());
    bad.motion.path.x = NAN;
    EXPECT_TRUE(portals_closed_by(depot, bad).empty());
}

}  // namespace
}  // namespace firma

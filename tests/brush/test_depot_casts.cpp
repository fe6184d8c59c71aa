// SPDX-License-Identifier: MIT
// The depot: casts by room equal casts against all faces, with doors open and closed, and after craters.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "tests/brush/casts_agree.h"
#include "tests/brush/depot_level.h"

namespace firma {
namespace {

TEST(DepotCasts, ByRoomAsAgainstAllFaces) {
    World world = make_world(test::depot_level()).value();
    expect_casts_agree(world, 1, 12'000);
    for (std::uint32_t k = 0; k < portal_count(world); k += 3) world = *set_portal_open(world, {k}, false);
    expect_casts_agree(world, 2, 12'000);
}

TEST(DepotCasts, AfterCraters) {
    World world = make_world(test::depot_level()).value();
    scenes::Rng rng(5);
    const Box box = world.bounds();
    int done = 0;
    for (int k = 0; k < 120 && done < 25; ++k) {
        const Vec3 start = some_point(world, box, rng);
        const Vec3 direction = rng.direction();
        if (locate(world, start).where != Where::kAir) continue;
        const Hit hit = cast(world, {start, 0}, direction * 50.0);
        if (!hit.touched()) continue;
        Pose pose;
        pose.position = hit.point;
        pose.scale = rng.uniform(0.4, 1.2);
        const CarveResult result = carve(world, make_crater(CutterShape::kRocky, rng.next()), pose);
        if (!result.done()) continue;
        world = result.world;
        ++done;
        const std::optional<WorldFault> fault = check_world(world);
        ASSERT_FALSE(fault) << "cut " << k << ": " << fault->what;
    }
    EXPECT_GE(done, 20);
    EXPECT_FALSE(check_solid(world));
    expect_casts_agree(world, 3, 12'000);
}

}  // namespace
}  // namespace firma

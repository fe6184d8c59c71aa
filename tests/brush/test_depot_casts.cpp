// SPDX-License-Identifier: MIT
// The depot: casts by room equal casts against all faces, with doors open and closed, and after craters.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "scenes/rng.h"

namespace firma {
namespace {

World depot() {
    const std::string path = FIRMA_ROOT "/levels/depot.map";
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return make_world(read_map(text, path).value()).value();
}

/// Anywhere in the air, half of the time near a portal.
Vec3 some_point(const World& world, const Box& box, scenes::Rng& rng) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(box.low[axis], box.high[axis]);
    const std::uint32_t id = rng.below(std::uint32_t(portal_count(world)));
    const PortalInfo portal = portal_info(world, {id});
    if (portal.polygons.empty() || rng.chance(0.3)) return point;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = (portal.bounds.low[axis] + portal.bounds.high[axis]) / 2;
        point[axis] = middle + rng.uniform(-1, 1);
    }
    return point;
}

void expect_casts_agree(const World& world, std::uint64_t seed, int casts) {
    scenes::Rng rng(seed);
    const Box box = world.bounds();
    int asked = 0, passed = 0;
    for (int k = 0; k < casts && !testing::Test::HasFailure(); ++k) {
        Sphere sphere;
        sphere.centre = some_point(world, box, rng);
        sphere.radius = rng.chance(0.4) ? 0 : rng.uniform(0.01, 0.6);
        const Vec3 direction = rng.direction();
        const Vec3 path = direction * rng.uniform(0.1, 60);
        const Location start = locate(world, sphere.centre);
        if (start.kind != Location::Kind::kRoom || closest(world, sphere.centre, sphere.radius + 1e-5)) continue;
        SCOPED_TRACE(testing::Message() << "cast " << k << " from room " << start.room.value);
        const Hit all = cast(world, sphere, path), by_room = cast(world, sphere, path, {.room = start.room});
        EXPECT_EQ(by_room.status, all.status);
        EXPECT_EQ(by_room.fraction, all.fraction);
        EXPECT_EQ(by_room.face, all.face);
        EXPECT_EQ(by_room.portal, all.portal);
        EXPECT_EQ(by_room.room, all.room);
        ++asked;
        passed += by_room.rooms_passed > 1;
    }
    EXPECT_GT(asked, casts / 5);
    EXPECT_GT(passed, asked / 20);
}

TEST(DepotCasts, ByRoomAsAgainstAllFaces) {
    World world = depot();
    expect_casts_agree(world, 1, 12'000);
    for (std::uint32_t k = 0; k < portal_count(world); k += 3) world = set_portal_open(world, {k}, false);
    expect_casts_agree(world, 2, 12'000);
}

TEST(DepotCasts, AfterCraters) {
    World world = depot();
    scenes::Rng rng(5);
    const Box box = world.bounds();
    int done = 0;
    for (int k = 0; k < 120 && done < 25; ++k) {
        const Vec3 start = some_point(world, box, rng);
        const Vec3 direction = rng.direction();
        if (locate(world, start).kind != Location::Kind::kRoom) continue;
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

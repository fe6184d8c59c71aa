// SPDX-License-Identifier: MIT
// Casts by room equal casts against all faces, in any world with portals.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "firma/firma.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/reference/judge_rooms.h"

namespace firma {

/// Anywhere in the air, half of the time near a portal.
inline Vec3 some_point(const World& world, const Box& box, scenes::Rng& rng) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(box.low[axis], box.high[axis]);
    const std::uint32_t id = rng.below(std::uint32_t(portal_count(world)));
    const PortalInfo portal = *portal_info(world, {id});
    if (portal.polygons == 0 || rng.chance(0.3)) return point;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = (portal.bounds.low[axis] + portal.bounds.high[axis]) / 2;
        point[axis] = middle + rng.uniform(-1, 1);
    }
    return point;
}

/// From the air, clear of all faces: by room as against all faces.
inline void expect_casts_agree(const World& world, std::uint64_t seed, int casts) {
    scenes::Rng rng(seed);
    const Box box = world.bounds();
    int asked = 0, passed = 0;
    for (int k = 0; k < casts && !testing::Test::HasFailure(); ++k) {
        Sphere sphere;
        sphere.centre = some_point(world, box, rng);
        sphere.radius = rng.chance(0.4) ? 0 : rng.uniform(0.01, 0.6);
        const Vec3 direction = rng.direction();
        const Vec3 path = direction * rng.uniform(0.1, 60);
        std::uint32_t rooms_passed = 0;
        EXPECT_EQ(reference::judge_cast_by_room(world, sphere, path, rooms_passed), "") << "cast " << k;
        asked += rooms_passed > 0;
        passed += rooms_passed > 1;
    }
    EXPECT_GT(asked, casts / 5);
    EXPECT_GT(passed, asked / 20);
}

}  // namespace firma

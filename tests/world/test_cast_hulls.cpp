// SPDX-License-Identifier: MIT
// Hulls through worlds: what the pair function says of each face, the earliest of all, by any way through the rooms.
#include <gtest/gtest.h>

#include <algorithm>

#include "firma/hull.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/cast_families.h"
#include "scenes/divided_building.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::Rng;

/// A box turned any way, or the hull of some points on a sphere and the origin.
Hull any_hull(Rng& rng, double size) {
    if (rng.chance(0.5)) {
        const Vec3 x = rng.direction(), aside = cross(x, rng.direction()), y = aside * (1 / length(aside));
        const Vec3 half{rng.uniform(0.2, 1) * size, rng.uniform(0.2, 1) * size, rng.uniform(0.2, 1) * size};
        return make_box(half * 0.57, {x, y, cross(x, y)}).value();
    }
    std::vector<Vec3> points{{0, 0, 0}};
    for (int k = 4 + int(rng.below(12)); k > 0; --k) points.push_back(rng.direction() * size);
    return make_hull(points).value();
}

/// By every face, one by one.
Hit by_each_face(const World& world, const Hull& hull, const Vec3& at, const Vec3& path, Sides sides) {
    Hit best;
    each_face(world, [&](const FaceView& face) {
        const PolygonHit hit = cast_polygon(hull, at, path, face.corners, face.two_sided ? Sides::kBoth : sides);
        if (hit && (!best || hit.fraction < best.fraction ||
                    (hit.fraction == best.fraction && face.ref().id < best.face.id))) {
            static_cast<PolygonHit&>(best) = hit;
            best.face = face.ref();
        }
        return true;
    });
    return best;
}

TEST(CastHulls, MeetTheEarliestOfAllFaces) {
    Rng rng(3);
    int touched = 0;
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 11, 0);
        const Result<World> made = make_world(scenes::level_of(scene.polygons, scene.two_sided));
        ASSERT_TRUE(made.ok()) << family.name;
        const World& world = made.value();
        for (const scenes::CastQuery& query : scene.casts) {
            const double size = query.sphere.radius > 1e-6 && query.sphere.radius < 1e6 ? query.sphere.radius : 0.5;
            const Hull hull = any_hull(rng, size);
            const Sides sides = rng.chance(0.5) ? Sides::kBoth : Sides::kFront;
            const Vec3 &at = query.sphere.centre, &path = query.path;
            const Hit hit = cast(world, hull, at, path, {.sides = sides});
            if (hit.status == Status::kInvalid) continue;
            const Hit expected = by_each_face(world, hull, at, path, sides);
            ASSERT_EQ(hit.status, expected.status) << family.name;
            touched += bool(hit);
            if (hit) {
                EXPECT_EQ(hit.fraction, expected.fraction) << family.name;
                EXPECT_EQ(hit.face, expected.face) << family.name;
                EXPECT_EQ(hit.point, expected.point) << family.name;
                EXPECT_EQ(hit.normal, expected.normal) << family.name;
                EXPECT_GE(hit.safe_fraction, 0);
                EXPECT_LE(hit.safe_fraction, hit.fraction);
            }
            const Status any = cast_any(world, hull, at, path, {.sides = sides});
            EXPECT_EQ(any == Status::kHit || any == Status::kInitialOverlap, bool(hit)) << family.name;
            std::vector<Hit> hits;
            EXPECT_EQ(cast_all(world, hull, at, path, hits, {.sides = sides}), hit.status);
            ASSERT_EQ(hits.empty(), !hit);
            if (hit) {
                EXPECT_EQ(hits[0].face, hit.face);
                EXPECT_EQ(hits[0].fraction, hit.fraction);
            }
        }
    }
    EXPECT_GT(touched, 200);
}

TEST(CastHulls, AnswerAlikeByRoomAndOverAllFaces) {
    Rng rng(8);
    int touched = 0, passed = 0;
    for (const double jitter : {0.0, 0.2}) {
        const scenes::DividedBuilding building({.jitter = jitter, .closed = jitter > 0 ? 0.4 : 0, .seed = 4});
        const World world = assemble_world(building.parts()).value();
        for (int k = 0; k < 400; ++k) {
            const double size = rng.uniform(0.05, 0.4);
            const Hull hull = any_hull(rng, size);
            const Vec3 at = building.point_in_air(size, rng), path = rng.direction() * rng.uniform(0.1, 30);
            RoomTrail trail;
            const Hit over_all = cast(world, hull, at, path);
            const Hit by_room = cast(world, hull, at, path, {.room = kLocateRoom, .trail = &trail});
            ASSERT_EQ(by_room.status, over_all.status);
            EXPECT_EQ(by_room.fraction, over_all.fraction);
            EXPECT_EQ(by_room.face, over_all.face);
            EXPECT_EQ(by_room.portal, over_all.portal);
            touched += bool(over_all);
            passed += trail.count > 1;
        }
    }
    EXPECT_GT(touched, 200);
    EXPECT_GT(passed, 50);
}

TEST(CastHulls, SayWhatCannotBeAsked) {
    const World world =
        make_world(scenes::level_of(std::vector<scenes::GridPolygon>{{{0, 0, 0}, {262144, 0, 0}, {0, 262144, 0}}}))
            .value();
    const Hull box = make_box({0.5, 0.5, 0.5}).value();
    EXPECT_EQ(cast(world, box, {0, 0, 2}, {0, 0, -4}).fraction, 0.375);
    EXPECT_EQ(cast(world, Hull(), {0, 0, 2}, {0, 0, -4}).status, Status::kInvalid);
    EXPECT_EQ(cast(world, box, {0, NAN, 2}, {0, 0, -4}).status, Status::kInvalid);
    EXPECT_EQ(cast(world, box, {0, 0, 2}, {0, 0, -0x1p210}).status, Status::kInvalid);
    EXPECT_EQ(cast(world, box, {0, 0, 2}, {0, 0, 0}).status, Status::kMiss);
    EXPECT_FALSE(make_box({0.5, 0, 0.5}).ok());
    EXPECT_FALSE(
        make_hull(std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}).ok());  // not around (0, 0, 0)
    EXPECT_EQ(box.corners().size(), 8u);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Capsules through worlds: what the pair function says of each face, the earliest of all, by any way through the rooms.
#include <gtest/gtest.h>

#include <algorithm>

#include "firma/capsule.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/cast_families.h"
#include "scenes/divided_building.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::Rng;

Capsule any_capsule(Rng& rng, const Vec3& middle, double size) {
    const double half = rng.chance(0.1) ? 0 : rng.uniform(0, 0.7) * size;
    return make_capsule(middle, rng.direction(), half, rng.chance(0.1) ? 0 : size - half);
}

/// By every face, one by one.
Hit capsule_by_each_face(const World& world, const Capsule& capsule, const Vec3& path, Sides sides) {
    Hit best;
    each_face(world, [&](const FaceView& face) {
        const PolygonHit hit = cast_polygon(capsule, path, face.corners, face.two_sided ? Sides::kBoth : sides);
        if (hit && (!best || hit.fraction < best.fraction ||
                    (hit.fraction == best.fraction && face.ref().id < best.face.id))) {
            static_cast<PolygonHit&>(best) = hit;
            best.face = face.ref();
        }
        return true;
    });
    return best;
}

TEST(CastCapsules, MeetTheEarliestOfAllFaces) {
    Rng rng(3);
    int touched = 0;
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 11, 0);
        const Result<World> made = make_world(scenes::level_of(scene.polygons, scene.two_sided));
        ASSERT_TRUE(made.ok()) << family.name;
        const World& world = made.value();
        for (const scenes::CastQuery& query : scene.casts) {
            const double size = query.sphere.radius > 1e-6 && query.sphere.radius < 1e6 ? query.sphere.radius : 0.5;
            const Capsule capsule = any_capsule(rng, query.sphere.centre, size);
            const Sides sides = rng.chance(0.5) ? Sides::kBoth : Sides::kFront;
            const Vec3& path = query.path;
            const Hit hit = cast(world, capsule, path, {.sides = sides});
            if (hit.status == Status::kInvalid) continue;
            const Hit expected = capsule_by_each_face(world, capsule, path, sides);
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
            const Status any = cast_any(world, capsule, path, {.sides = sides});
            EXPECT_EQ(any == Status::kHit || any == Status::kInitialOverlap, bool(hit)) << family.name;
            std::vector<Hit> hits;
            EXPECT_EQ(cast_all(world, capsule, path, hits, {.sides = sides}), hit.status);
            ASSERT_EQ(hits.empty(), !hit);
            if (hit) {
                EXPECT_EQ(hits[0].face, hit.face);
                EXPECT_EQ(hits[0].fraction, hit.fraction);
            }
        }
    }
    EXPECT_GT(touched, 200);
}

TEST(CastCapsules, AnswerAlikeByRoomAndOverAllFaces) {
    Rng rng(8);
    int touched = 0, passed = 0;
    for (const double jitter : {0.0, 0.2}) {
        const scenes::DividedBuilding building({.jitter = jitter, .closed = jitter > 0 ? 0.4 : 0, .seed = 4});
        const World world = assemble_world(building.parts()).value();
        for (int k = 0; k < 400; ++k) {
            const double size = rng.uniform(0.05, 0.4);
            const Capsule capsule = any_capsule(rng, building.point_in_air(size, rng), size);
            const Vec3 path = rng.direction() * rng.uniform(0.1, 30);
            RoomTrail trail;
            const Hit over_all = cast(world, capsule, path);
            const Hit by_room = cast(world, capsule, path, {.room = kLocateRoom, .trail = &trail});
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

TEST(CastCapsules, OfNoLengthAnswerAsSpheresToTheBit) {
    Rng rng(12);
    int touched = 0;
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 21, 0);
        const Result<World> made = make_world(scenes::level_of(scene.polygons, scene.two_sided));
        ASSERT_TRUE(made.ok()) << family.name;
        for (const scenes::CastQuery& query : scene.casts) {
            const Sphere& sphere = query.sphere;
            const Hit hit = cast(made.value(), Capsule(sphere.centre, sphere.centre, sphere.radius), query.path);
            const Hit expected = cast(made.value(), sphere, query.path);
            ASSERT_EQ(hit.status, expected.status) << family.name;
            EXPECT_EQ(hit.fraction, expected.fraction);
            EXPECT_EQ(hit.safe_fraction, expected.safe_fraction);
            EXPECT_EQ(hit.feature, expected.feature);
            EXPECT_EQ(hit.feature_index, expected.feature_index);
            EXPECT_EQ(hit.face, expected.face);
            if (hit.status == Status::kInvalid) continue;  // what is not a number does not equal itself
            EXPECT_EQ(hit.centre, expected.centre);
            EXPECT_EQ(hit.point, expected.point);
            EXPECT_EQ(hit.normal, expected.normal);
            touched += bool(hit);
        }
    }
    EXPECT_GT(touched, 200);
}

TEST(CastCapsules, SayWhatCannotBeAsked) {
    const World world =
        make_world(scenes::level_of(std::vector<scenes::GridPolygon>{{{0, 0, 0}, {262144, 0, 0}, {0, 262144, 0}}}))
            .value();
    const auto fall = [&](const Capsule& capsule, const Vec3& path) { return cast(world, capsule, path); };
    EXPECT_EQ(fall({{0, 0, 2}, {0, 0, 4}, 0.5}, {0, 0, -4}).fraction, 0.375);
    EXPECT_EQ(fall({{0, 0, 2}, {0, 0, 4}, -0.5}, {0, 0, -4}).status, Status::kInvalid);
    EXPECT_EQ(fall({{0, NAN, 2}, {0, 0, 4}, 0.5}, {0, 0, -4}).status, Status::kInvalid);
    EXPECT_EQ(fall({{0, 0, 2}, {0, 0, 4}, 0.5}, {0, 0, -0x1p210}).status, Status::kInvalid);
    EXPECT_EQ(fall({{0, 0, 2}, {0, 0, 4}, 0.5}, {0, 0, 0}).status, Status::kMiss);
}

}  // namespace
}  // namespace firma

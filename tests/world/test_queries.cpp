// SPDX-License-Identifier: MIT
// Questions by visitor, in batches, of rays; what is moved away; what a miss looks like.
#include "firma/queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "firma/carve.h"
#include "firma/rooms.h"
#include "scenes/divided_building.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "tests/lent_threads.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

const World& building() {
    static const World world =
        assemble_world(
            scenes::DividedBuilding({.rooms_x = 4, .rooms_y = 3, .rooms_z = 2, .closed = 0.3, .seed = 3}).parts())
            .value();
    return world;
}

std::vector<CastInput> some_casts(std::size_t count, std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Box bounds = building().bounds();
    std::vector<CastInput> casts(count);
    for (CastInput& one : casts) {
        for (int axis = 0; axis < 3; ++axis) one.sphere.centre[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        one.sphere.radius = rng.chance(0.5) ? 0 : rng.uniform(0.05, 0.4);
        const Vec3 direction = rng.direction();
        one.path = direction * rng.uniform(0.5, 30);
    }
    return casts;
}

bool same(const Hit& a, const Hit& b) {
    return a.status == b.status && a.fraction == b.fraction && a.safe_fraction == b.safe_fraction &&
           a.centre == b.centre && a.point == b.point && a.normal == b.normal && a.face == b.face &&
           a.portal == b.portal && a.material == b.material;
}

TEST(Queries, AMissGoesToTheEndAndWhatIsInvalidNowhere) {
    const World world;
    const Hit miss = cast(world, {{1, 2, 3}, 0.5}, {4, 0, -8});
    EXPECT_EQ(miss.status, Status::kMiss);
    EXPECT_FALSE(miss);
    EXPECT_EQ(miss.fraction, 1);
    EXPECT_EQ(miss.safe_fraction, 1);
    EXPECT_EQ(miss.centre, (Vec3{5, 2, -5}));
    EXPECT_FALSE(miss.face.valid());
    const Hit still = cast(world, {{1, 2, 3}, 0.5}, {0, 0, 0});
    EXPECT_EQ(still.fraction, 1);
    EXPECT_EQ(still.centre, (Vec3{1, 2, 3}));
    const Hit invalid = cast(world, {{1, 2, 3}, -1}, {4, 0, -8});
    EXPECT_EQ(invalid.status, Status::kInvalid);
    EXPECT_FALSE(invalid);
    EXPECT_EQ(invalid.fraction, 0);
    EXPECT_EQ(invalid.safe_fraction, 0);
    EXPECT_EQ(invalid.centre, (Vec3{1, 2, 3}));
    const PolygonHit alone = cast_polygon({{0, 0, 5}, 1}, {0, 0, -1}, std::array{Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}});
    EXPECT_EQ(alone.fraction, 1);
    EXPECT_EQ(alone.centre, (Vec3{0, 0, 4}));
}

TEST(Queries, ARayIsASphereWithoutRadius) {
    for (const CastInput& one : some_casts(500, 1)) {
        const Ray ray{one.sphere.centre, one.path};
        EXPECT_TRUE(same(cast(building(), ray), cast(building(), {ray.start, 0}, ray.path)));
        EXPECT_EQ(cast_any(building(), ray), cast_any(building(), {ray.start, 0}, ray.path));
    }
}

TEST(Queries, EachHitComesOnceAndAVisitorShortensAndStops) {
    std::size_t several = 0;
    for (const CastInput& one : some_casts(2000, 2)) {
        std::vector<Hit> all, each;
        const Status status = cast_all(building(), one.sphere, one.path, all);
        const auto keep = [&](const Hit& hit) {
            each.push_back(hit);
            return 1.0;
        };
        EXPECT_EQ(cast_each(building(), one.sphere, one.path, keep) == Status::kMiss, status == Status::kMiss);
        std::sort(each.begin(), each.end(), [](const Hit& a, const Hit& b) {
            return a.fraction != b.fraction ? a.fraction < b.fraction
                   : a.face.id != b.face.id ? a.face.id < b.face.id
                                            : a.portal < b.portal;
        });
        ASSERT_TRUE(std::equal(all.begin(), all.end(), each.begin(), each.end(), same));
        several += all.size() > 1;

        // By shortening to what counts: the first with an odd id, as the list has it.
        const auto odd = [](const Hit& hit) { return hit.face.valid() && hit.face.id.value % 2 == 1; };
        double first = 1;
        cast_each(building(), one.sphere, one.path, [&](const Hit& hit) {
            if (!odd(hit)) return 1.0;
            EXPECT_LE(hit.fraction, first) << "told of what lies after the last that counted";
            first = hit.fraction;
            return hit.fraction;
        });
        const auto found = std::find_if(all.begin(), all.end(), odd);
        EXPECT_EQ(first, found == all.end() ? 1 : found->fraction);

        std::size_t calls = 0;
        const auto stop = [&](const Hit&) {
            ++calls;
            return 0.0;
        };
        cast_each(building(), one.sphere, one.path, stop);
        EXPECT_EQ(calls, all.empty() ? 0u : 1u);
    }
    EXPECT_GT(several, 500u);
    const auto never = [](const Hit&) -> double { throw 1; };
    EXPECT_EQ(cast_each(building(), {{0, 0, 0}, -1}, {1, 0, 0}, never), Status::kInvalid);
}

void run_nothing(std::size_t, void (*)(void*, std::size_t), void*, void*) {}

TEST(Queries, ABatchAnswersAsOneByOne) {
    const std::vector<CastInput> casts = some_casts(1500, 3);
    std::vector<Hit> hits(casts.size()), threaded(casts.size());
    CastCounts alone, batched, spread;
    EXPECT_TRUE(cast_batch(building(), casts, hits, {.counts = &batched}));
    const test::LentThreads threads(3);
    const Tasks& tasks = threads.tasks;
    const Tasks lazy{run_nothing, nullptr};
    EXPECT_TRUE(cast_batch(building(), casts, threaded, {.counts = &spread}, &tasks));
    for (std::size_t k = 0; k < casts.size(); ++k) {
        const Hit hit = cast(building(), casts[k].sphere, casts[k].path, {.counts = &alone});
        EXPECT_TRUE(same(hit, hits[k]));
        EXPECT_TRUE(same(hit, threaded[k]));
    }
    EXPECT_EQ(alone.faces, batched.faces);
    EXPECT_EQ(alone.faces, spread.faces);
    EXPECT_FALSE(cast_batch(building(), casts, threaded, {}, &lazy));
    for (const Hit& hit : threaded) EXPECT_EQ(hit.status, Status::kInvalid);
    EXPECT_FALSE(cast_batch(building(), casts, std::span(hits).first(3)));
    EXPECT_EQ(hits[0].status, Status::kInvalid);
    EXPECT_TRUE(cast_batch(building(), {}, {}));
}

TEST(Queries, TheWayOutOfAnOverlapLeadsOut) {
    std::size_t behind = 0, deep = 0;
    for (const CastInput& one : some_casts(1500, 4)) {
        const Sphere sphere{one.sphere.centre, 0.6};
        std::vector<Overlap> all, each;
        overlap(building(), sphere, all);
        overlap_each(building(), sphere, [&](const Overlap& overlap) {
            each.push_back(overlap);
            return true;
        });
        EXPECT_EQ(all.size(), each.size());
        for (const Overlap& found : all) {
            EXPECT_NEAR(length(found.direction), 1, 1e-12);
            EXPECT_GE(found.depth, 0);
            const Vec3 out = sphere.centre + found.direction * (found.depth + 1e-9);
            if (found.face.valid()) {
                EXPECT_FALSE(overlap({out, sphere.radius - 1e-9}, building().face(found.face)->corners));
            }
            behind += found.depth > sphere.radius;
            deep += found.depth > 0.3;
        }
        std::size_t calls = 0;
        overlap_each(building(), sphere, [&](const Overlap&) { return ++calls < 2; });
        EXPECT_EQ(calls, std::min<std::size_t>(all.size(), 2));
    }
    EXPECT_GT(behind, 20u);
    EXPECT_GT(deep, 100u);
}

std::set<std::uint32_t> seen(const auto& where) {
    std::set<std::uint32_t> ids;
    const auto add = [&](const FaceView& face) {
        EXPECT_TRUE(ids.insert(face.id.value).second) << "twice";
        EXPECT_EQ(face.corners[0], to_metres(face.corner));
        return true;
    };
    if constexpr (std::is_same_v<decltype(where), const World&>)
        EXPECT_TRUE(each_face(building(), add));
    else
        EXPECT_TRUE(each_face(building(), where, add));
    return ids;
}

TEST(Queries, FacesOfABoxARoomARegion) {
    const std::vector<Face> faces = building().faces();
    EXPECT_EQ(seen(building()).size(), faces.size());
    std::map<RoomId, std::set<std::uint32_t>> of_room;
    for (const Face& face : faces) of_room[face.room].insert(face.id.value);
    for (std::uint32_t room = 0; room < building().room_count(); ++room) EXPECT_EQ(seen(RoomId{room}), of_room[{room}]);
    EXPECT_EQ(seen(kAnyRoom).size(), faces.size());
    EXPECT_TRUE(seen(RoomId{100000}).empty());

    scenes::Rng rng(5);
    const Box bounds = building().bounds();
    for (int k = 0; k < 200; ++k) {
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = rng.uniform(bounds.low[axis] - 1, bounds.high[axis] + 1);
            box.low[axis] = k % 3 ? a : std::round(a);
            box.high[axis] = box.low[axis] + (k % 5 ? rng.uniform(0, 3) : 0);
        }
        std::set<std::uint32_t> expected;
        for (const Face& face : faces) {
            Box own;
            for (const Vec3& corner : face.corners) own.add(corner);
            bool meets = true;
            for (int axis = 0; axis < 3; ++axis)
                meets = meets && own.low[axis] <= box.high[axis] && own.high[axis] >= box.low[axis];
            if (meets) expected.insert(face.id.value);
        }
        EXPECT_EQ(seen(box), expected) << k;
    }
    EXPECT_TRUE(seen(Box{}).empty());
    EXPECT_TRUE(seen(Box{{NAN, 0, 0}, {1, 1, 1}}).empty());
    EXPECT_TRUE(seen(Box{{1e9, 0, 0}, {2e9, 1, 1}}).empty());

    const World wide = make_world(scenes::room_grid({8, 6, 2})).value();
    std::size_t sum = 0;
    for (const RegionHash& region : hash_regions(wide))
        each_face(wide, region.region, [&](const FaceView&) { return ++sum > 0; });
    EXPECT_EQ(sum, wide.face_count()) << "each face is in one region";
    EXPECT_GT(hash_regions(wide).size(), 2u);
    each_face(wide, Region{1 << 20, 0, 0}, [&](const FaceView&) { return ++sum > 0; });
    EXPECT_EQ(sum, wide.face_count());
    int calls = 0;
    EXPECT_FALSE(each_face(wide, [&](const FaceView&) { return ++calls < 3; }));
    EXPECT_EQ(calls, 3);
}

TEST(Queries, WhatIsMovedAwayIsEmptyAndNotBroken) {
    World world = building();
    const World moved = std::move(world);
    EXPECT_EQ(moved.face_count(), building().face_count());
    EXPECT_EQ(world.face_count(), 0u);  // NOLINT(bugprone-use-after-move): that is what is asked
    EXPECT_FALSE(cast(world, {{1, 1, 1}, 0.2}, {0, 0, -9}));
    EXPECT_EQ(check_world(world), std::nullopt);
    world = moved;
    World other;
    other = std::move(world);
    EXPECT_EQ(world.room_count(), 1u);
    Solid solid = moved.solid();
    const Solid taken = std::move(solid);
    EXPECT_EQ(solid.face_count(), 0u);
    EXPECT_EQ(locate(solid, {0, 0, 0}), Where::kAir);
    CarveJob job(moved, make_crater(CutterShape::kRocky, 1), {});
    CarveJob elsewhere = std::move(job);
    EXPECT_TRUE(job.run(INFINITY));
    EXPECT_TRUE(job.finished());
    EXPECT_FALSE(job.broken());
    EXPECT_EQ(job.result().status, CarveStatus::kRefused);
    EXPECT_TRUE(elsewhere.run(INFINITY));
    Cutter cutter = make_crater(CutterShape::kRocky, 1);
    const Cutter kept = std::move(cutter);
    EXPECT_FALSE(cutter.valid());
    EXPECT_TRUE(cutter.vertices().empty());
    EXPECT_TRUE(cutter.triangles().empty());
    EXPECT_EQ(cutter.name(), "");
    EXPECT_EQ(carve(moved, cutter, {}).status, CarveStatus::kRefused);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// What holds things, and what edits, fills and undo take of it: in closed form on simple ground, and in the depot,
// where only what is near a change is looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "firma/carve.h"
#include "firma/support.h"
#include "scenes/level_cuts.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/moving/part_worlds.h"

namespace firma {
namespace {

SupportedThing thing_at(const Box& box, SupportKind kind = SupportKind::kTouches, double reach = 0) {
    SupportedThing thing;
    thing.entity = 7;
    thing.kind = kind;
    thing.box = box;
    thing.reach = reach;
    return thing;
}

Supports supports_of(const World& world, const std::vector<SupportedThing>& things) {
    return find_supports(world, things).value();
}

World without_box(const World& world, const Vec3& low, const Vec3& high) {
    const CarveResult cut = carve(world, test::box_mesh(low, high).cutter().value(), {});
    EXPECT_TRUE(cut.done());
    return cut.world;
}

World with_box(const World& world, const Vec3& low, const Vec3& high) {
    const CarveResult filled = fill(world, test::box_mesh(low, high).cutter().value(), {});
    EXPECT_TRUE(filled.done());
    return filled.world;
}

TEST(Support, ABoxOnTheGroundStandsOnItsFootprint) {
    const World ground = test::ground();
    const Supports held = supports_of(ground, {thing_at({{0, 0, 0}, {2, 1, 1}})});
    ASSERT_EQ(held.things[0].faces.size(), 1u);
    EXPECT_NEAR(held.things[0].area, 2, 1e-9);
    EXPECT_TRUE(ground.face_info(held.things[0].faces[0].face));
    EXPECT_EQ(supports_of(ground, {thing_at({{0, 0, 0.5}, {2, 1, 1}})}).things[0].area, 0) << "half a metre above";
    EXPECT_NEAR(supports_of(ground, {thing_at({{0, 0, 0.5}, {2, 1, 1}}, SupportKind::kTouches, 0.5)}).things[0].area, 2,
                1e-9);
    EXPECT_NEAR(supports_of(ground, {thing_at({{0, 0, -0.25}, {2, 1, 1}})}).things[0].area, 2, 1e-9) << "sunk in";
}

TEST(Support, AnEditTellsHowMuchItTook) {
    const World ground = test::ground();
    const Supports held = supports_of(ground, {thing_at({{0, 0, 0}, {2, 1, 1}}), thing_at({{50, 0, 0}, {51, 1, 1}})});
    // Far from both on the same face: other faces are in its place, and hold as much.
    const World far = without_box(ground, {20, 0, -1}, {21, 1, 1});
    SupportDiff diff = diff_supports(held, diff_worlds(ground, far), far);
    for (const SupportChange& change : diff.changes) {
        EXPECT_EQ(change.loss, SupportLoss::kNone);
        EXPECT_NEAR(change.after, change.before, 1e-9);
    }
    // Half of it.
    const World half = without_box(far, {1, -1, -1}, {3, 3, 1});
    const SupportDiff less = diff_supports(diff.after, diff_worlds(far, half), half);
    const auto first =
        std::find_if(less.changes.begin(), less.changes.end(), [](const auto& it) { return it.thing == 0; });
    ASSERT_NE(first, less.changes.end());
    EXPECT_EQ(first->loss, SupportLoss::kSome);
    EXPECT_EQ(first->entity, 7u);
    EXPECT_FALSE(first->lost.empty());
    EXPECT_NEAR(first->before, 2, 1e-9);
    EXPECT_NEAR(first->after, 1, 1e-9);
    EXPECT_FALSE(first->buried);
    // All of it: the walls of the pit do not hold.
    const World none = without_box(half, {-1, -1, -1}, {3, 3, 1});
    const SupportDiff all = diff_supports(less.after, diff_worlds(half, none), none);
    const auto gone =
        std::find_if(all.changes.begin(), all.changes.end(), [](const auto& it) { return it.thing == 0; });
    ASSERT_NE(gone, all.changes.end());
    EXPECT_EQ(gone->loss, SupportLoss::kAll);
    EXPECT_EQ(gone->after, 0);
    // Undo: something holds it again, and it is what did at first.
    const SupportDiff back = diff_supports(all.after, diff_worlds(none, ground), ground);
    ASSERT_FALSE(back.changes.empty());
    EXPECT_EQ(back.changes[0].loss, SupportLoss::kNone);
    EXPECT_EQ(back.changes[0].before, 0);
    EXPECT_NEAR(back.changes[0].after, 2, 1e-9);
    EXPECT_EQ(back.after.things[0].faces, held.things[0].faces);
    EXPECT_EQ(back.after.world_hash, held.world_hash);
    // The same world: nothing.
    EXPECT_TRUE(diff_supports(held, ground).changes.empty());
}

TEST(Support, WhatIsFilledInIsBuried) {
    const World ground = test::ground();
    const Supports held = supports_of(ground, {thing_at({{0, 0, 0}, {1, 1, 1}})});
    const World filled = with_box(ground, {-1, -1, -1}, {2, 2, 2});
    const SupportDiff diff = diff_supports(held, diff_worlds(ground, filled), filled);
    ASSERT_EQ(diff.changes.size(), 1u);
    EXPECT_EQ(diff.changes[0].loss, SupportLoss::kAll);
    EXPECT_TRUE(diff.changes[0].buried);
}

/// Ids go on from the same number after an undo: another edit's faces have those of the one undone.
TEST(Support, AnotherEditAfterAnUndoIsSeen) {
    const World ground = test::ground();
    const Supports at_first = supports_of(ground, {thing_at({{0, 0, 0}, {4, 4, 1}})});
    const World one = without_box(ground, {1, 1, -1}, {3, 3, 1}), two = without_box(ground, {1, 1, -1}, {2, 2, 1});
    const SupportDiff there = diff_supports(at_first, one);
    ASSERT_EQ(there.changes.size(), 1u);
    EXPECT_NEAR(there.changes[0].after, 12, 1e-9);
    const SupportDiff other = diff_supports(there.after, two);
    ASSERT_EQ(other.changes.size(), 1u);
    EXPECT_NEAR(other.changes[0].before, 12, 1e-9);
    EXPECT_NEAR(other.changes[0].after, 15, 1e-9);
    EXPECT_FALSE(other.changes[0].lost.empty());
}

TEST(Support, WhatStandsIsPutDownAndWhatHangsFindsTheNearest) {
    const World ground = test::ground();
    const Supports put_down = supports_of(ground, {thing_at({{0, 0, 3}, {1, 1, 5}}, SupportKind::kStands, 10),
                                                   thing_at({{0, 0, 13}, {1, 1, 15}}, SupportKind::kStands, 10)});
    EXPECT_NEAR(put_down.things[0].lowered, 3, 1e-9);
    EXPECT_NEAR(put_down.things[0].area, 1, 1e-9);
    EXPECT_EQ(put_down.things[1].area, 0) << "too high";
    // A ceiling over the ground, nearer to the lamp; and a shelf at the edge of which half a crate stands.
    const World covered = with_box(with_box(ground, {-4, -4, 4}, {8, 8, 5}), {20, 0, 2}, {22, 2, 3});
    const Supports both = supports_of(covered, {thing_at({{0, 0, 3.5}, {0.5, 0.5, 3.75}}, SupportKind::kHangs, 1),
                                                thing_at({{0, 0, 2}, {0.5, 0.5, 2.25}}, SupportKind::kHangs, 1),
                                                thing_at({{21.5, 0, 8}, {22.5, 1, 9}}, SupportKind::kStands, 100)});
    EXPECT_NEAR(both.things[0].area, 0.25, 1e-9);
    EXPECT_NEAR(both.things[0].reach, 0.251, 1e-9);
    EXPECT_EQ(both.things[1].area, 0) << "both are farther than a metre";
    EXPECT_NEAR(both.things[2].lowered, 5, 1e-9);
    EXPECT_NEAR(both.things[2].area, 0.5, 1e-9);
    // A floor above does not count, nor what is above it: it is put down on the one below.
    const Supports between = supports_of(with_box(ground, {-4, -4, 4}, {8, 8, 5}),
                                         {thing_at({{0, 0, 2}, {1, 1, 3}}, SupportKind::kStands, 100)});
    EXPECT_NEAR(between.things[0].lowered, 2, 1e-9);
    // Without the shelf it lost its stand, although there is ground below.
    const World bare = without_box(covered, {19, -1, 1.5}, {23, 3, 3.5});
    const SupportDiff diff = diff_supports(both, diff_worlds(covered, bare), bare);
    ASSERT_EQ(diff.changes.size(), 1u);
    EXPECT_EQ(diff.changes[0].thing, 2u);
    EXPECT_EQ(diff.changes[0].loss, SupportLoss::kAll);
}

TEST(Support, APartTouchesByItsFacesWhereverItIsTurned) {
    const World ground = test::ground();
    MovingPart part(test::box_world({-0.5, -0.5, 0}, {0.5, 0.5, 2}));
    part.motion.rotation = turn_by({0, 0, 0.7});
    part.motion.path = {0, 0, 1};
    SupportedThing thing;
    thing.sides = support_sides(part);
    ASSERT_EQ(thing.sides.size(), 6u);
    EXPECT_NEAR(supports_of(ground, {thing}).things[0].area, 1, 1e-9);
    thing.sides = support_sides(part, 0.5);
    EXPECT_EQ(supports_of(ground, {thing}).things[0].area, 0) << "half a metre up";
    part.motion.path.x = NAN;
    EXPECT_TRUE(support_sides(part).empty());
}

TEST(Support, BadThingsAreTold) {
    const World ground = test::ground();
    const auto fails = [&](const SupportedThing& thing) {
        const Result<Supports> found = find_supports(ground, {thing_at({{0, 0, 0}, {1, 1, 1}}), thing});
        return !found && found.error().code == ErrorCode::kInvalid &&
               found.error().reason.find("thing 1") != std::string::npos;
    };
    EXPECT_TRUE(fails(thing_at({})));
    EXPECT_TRUE(fails(thing_at({{0, 0, NAN}, {1, 1, 1}})));
    EXPECT_TRUE(fails(thing_at({{0, 0, 0}, {1, 1, 1}}, SupportKind::kStands, -1)));
    EXPECT_TRUE(fails(thing_at({{0, 0, 0}, {1, 1, 1}}, SupportKind::kStands, INFINITY)));
    SupportedThing thing = thing_at({{0, 0, 0}, {1, 1, 1}});
    thing.sides.push_back({{{0, 0, 0}, {1, 0, 0}}, {0, 0, 1}, 0});
    EXPECT_TRUE(fails(thing));
    thing.sides[0].corners.push_back({0, 1, 0});
    EXPECT_FALSE(fails(thing));
    thing.sides[0].normal = {0, 0, 2};
    EXPECT_TRUE(fails(thing));
}

/// Boxes all over the depot, most of them against walls or on floors.
std::vector<SupportedThing> scattered(const World& world, scenes::Rng& rng, std::size_t count) {
    std::vector<SupportedThing> things;
    const std::vector<Face> faces = world.faces();
    while (things.size() < count) {
        const Face& face = faces[rng.below(std::uint32_t(faces.size()))];
        Vec3 middle;
        for (const Vec3& corner : face.corners) middle += corner * (1.0 / double(face.corners.size()));
        const Vec3 half{rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.5)};
        const double out =
            std::fabs(face.normal.x) * half.x + std::fabs(face.normal.y) * half.y + std::fabs(face.normal.z) * half.z;
        middle += face.normal * out;
        const auto kind = SupportKind(rng.below(3));
        things.push_back(thing_at({middle - half, middle + half}, kind, kind == SupportKind::kTouches ? 0 : 2));
    }
    return things;
}

bool same_changes(const std::vector<SupportChange>& a, const std::vector<SupportChange>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SupportChange& p, const SupportChange& q) {
        return p.thing == q.thing && p.loss == q.loss && p.lost == q.lost && p.before == q.before && p.after == q.after;
    });
}

/// What is looked at near a change alone is what all would be; and every face that went is told.
TEST(Support, NearAChangeAsEverywhereInTheDepot) {
    World world = test::depot_world();
    scenes::Rng rng(5);
    Supports held = supports_of(world, scattered(world, rng, 120));
    const World first = world;
    const Supports at_first = held;
    std::size_t with = 0, lost_all = 0, lost_some = 0;
    for (const Support& support : held.things) with += support.area > 0;
    EXPECT_GT(with, 80u);
    const scenes::CutPlaces places = scenes::cut_places(world);
    for (std::uint64_t index = 0; index < 8; ++index)
        for (const scenes::CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts::kSpread, 11, index)) {
            Pose pose = order.pose;
            pose.scale *= 3;
            const CarveResult cut = index % 4 == 3 ? fill(world, order.cutter, pose) : carve(world, order.cutter, pose);
            if (!cut.done()) continue;
            const WorldDiff diff = diff_worlds(world, cut.world);
            const SupportDiff near = diff_supports(held, diff, cut.world), all = diff_supports(held, cut.world);
            ASSERT_TRUE(same_changes(near.changes, all.changes)) << index;
            for (std::size_t k = 0; k < held.things.size(); ++k) {
                ASSERT_EQ(near.after.things[k].faces, all.after.things[k].faces);
                // Whoever stood on a face that went is told.
                const auto went = [&](const SupportFace& face) {
                    return std::any_of(diff.removed.begin(), diff.removed.end(),
                                       [&](const FaceInfo& it) { return it.id == face.face.id; });
                };
                const bool must = std::any_of(held.things[k].faces.begin(), held.things[k].faces.end(), went);
                const bool told = std::any_of(near.changes.begin(), near.changes.end(),
                                              [&](const SupportChange& change) { return change.thing == k; });
                ASSERT_TRUE(told || !must) << index << " " << k;
            }
            for (const SupportChange& change : near.changes) {
                lost_all += change.loss == SupportLoss::kAll;
                lost_some += change.loss == SupportLoss::kSome;
            }
            held = near.after;
            world = cut.world;
        }
    EXPECT_GT(lost_all, 3u);
    EXPECT_GT(lost_some, 3u);
    // Undo of all of it.
    const SupportDiff back = diff_supports(held, diff_worlds(world, first), first);
    for (std::size_t k = 0; k < held.things.size(); ++k)
        EXPECT_EQ(back.after.things[k].faces, at_first.things[k].faces) << k;
    EXPECT_EQ(hash_world(first), back.after.world_hash);
}

}  // namespace
}  // namespace firma

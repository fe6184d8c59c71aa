// SPDX-License-Identifier: MIT
// Loose pieces: which ones a cut finds, what they are, and what stays.
#include <gtest/gtest.h>

#include "firma/brush_world.h"
#include "firma/chunk.h"
#include "firma/save.h"
#include "firma/versions.h"
#include "scenes/cut_levels.h"
#include "scenes/grid_polygons.h"
#include "scenes/rng.h"
#include "tests/brush/depot_level.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_chunks.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

constexpr ChunkOptions kNoCrumbs{.min_volume = 0, .density = 2000};

CarveOptions with_chunks(const ChunkOptions& chunks = kNoCrumbs) {
    CarveOptions options;
    options.chunks = chunks;
    return options;
}

World put_box(const World& world, const Vec3& low, const Vec3& high) {
    const CarveResult result = fill(world, test::box_mesh(low, high).cutter().value(), {});
    EXPECT_TRUE(result.done()) << result.error.reason;
    return result.world;
}

World take_box(const World& world, const Vec3& low, const Vec3& high, CarveResult& result,
               const CarveOptions& options = with_chunks()) {
    result = carve(world, test::box_mesh(low, high).cutter().value(), {}, options);
    EXPECT_TRUE(result.done()) << result.error.reason;
    return result.world;
}

/// A hall in the rock with a bridge from wall to wall, 1 m wide and half a metre thick.
World hall_with_bridge() {
    const World hall = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    return put_box(hall, {0, 5, 4}, {20, 6, 4.5});
}

TEST(Chunks, ABridgeShotAtBothEnds) {
    const World world = with_anchors(hall_with_bridge());
    CarveResult result;
    const World one_end = take_box(world, {1, 4, 3}, {2, 7, 5}, result);
    EXPECT_TRUE(result.chunks.empty());
    EXPECT_EQ(result.report.chunks, 0u);
    const World both = take_box(one_end, {17, 4, 3}, {18, 7, 5}, result);
    ASSERT_EQ(result.chunks.size(), 1u);
    const Chunk& chunk = result.chunks[0];
    EXPECT_EQ(chunk.mass.volume, 15 * 0.5);
    EXPECT_EQ(chunk.mass.mass, 2000 * 15 * 0.5);
    EXPECT_EQ(chunk.origin + chunk.mass.centre, (Vec3{9.5, 5.5, 4.25}));
    EXPECT_EQ(chunk.mass.inertia[0].x, 15000.0 / 12 * (1 + 0.25));
    EXPECT_EQ(result.report.chunks, 1u);
    EXPECT_EQ(result.report.chunk_volume, 7.5);
    EXPECT_EQ(result.report.crumbs, 0u);
    EXPECT_EQ(result.report.volume, 0.5) << "what the cutter took is counted alone";
    EXPECT_EQ(both.version(), one_end.version() + 1);
    EXPECT_EQ(locate(both.solid(), {9, 5.5, 4.25}), Where::kAir);
    EXPECT_EQ(locate(both.solid(), {0.5, 5.5, 4.25}), Where::kSolid) << "the stubs stay";
    EXPECT_EQ(locate(both.solid(), {19, 5.5, 4.25}), Where::kSolid);
    test::expect_sound_world(both);
    EXPECT_FALSE(check_solid(chunk.solid));
}

/// A cutter of two parts, one at each end: what hangs between them is one piece, whichever end leads to it.
TEST(Chunks, ShotAtBothEndsAtOnce) {
    const World world = with_anchors(hall_with_bridge());
    test::TriangleMesh mesh = test::box_mesh({1, 4, 3}, {2, 7, 5});
    mesh.add(test::box_mesh({17, 4, 3}, {18, 7, 5}));
    const CarveResult cut = carve(world, mesh.cutter().value(), {}, with_chunks());
    ASSERT_TRUE(cut.done());
    ASSERT_EQ(cut.chunks.size(), 1u);
    EXPECT_EQ(cut.chunks[0].mass.volume, 15 * 0.5);
    EXPECT_EQ(cut.report.chunk_volume, 7.5);
    test::expect_sound_world(cut.world);
}

TEST(Chunks, AreLeftHangingUnlessAskedFor) {
    const World world = with_anchors(hall_with_bridge());
    CarveResult result;
    World cut = take_box(world, {1, 4, 3}, {2, 7, 5}, result, {});
    cut = take_box(cut, {17, 4, 3}, {18, 7, 5}, result, {});
    EXPECT_TRUE(result.chunks.empty());
    EXPECT_EQ(locate(cut.solid(), {9, 5.5, 4.25}), Where::kSolid);
    EXPECT_EQ(result.report.times.chunks, 0);
}

/// The walls of the hall have fewer faces than what stands in it.
TEST(Chunks, TheSmallestGroupMayBeTheOneThatStays) {
    World world = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    world = put_box(world, {9, 5, 0}, {11, 7, 1});
    for (int k = 0; k < 9; ++k)
        world = put_box(world, {5 + k * 1.0, 2.0 + 0.25 * (k % 3), 1}, {5.75 + k * 1.0, 10, 1.5 + 0.25 * (k % 4)});
    world = with_anchors(put_box(world, {3, 5, 1.25}, {17, 7, 1.5}));
    CarveResult result;
    const World cut = take_box(world, {8.5, 4.5, 0.25}, {11.5, 7.5, 0.75}, result);
    ASSERT_EQ(result.chunks.size(), 1u);
    EXPECT_GT(result.chunks[0].mass.volume, 20);
    EXPECT_EQ(locate(cut.solid(), {10, 6, 0.125}), Where::kSolid);
    test::expect_sound_world(cut);
}

TEST(Chunks, WhatHangsFreeStays) {
    World world = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    world = with_anchors(put_box(world, {5, 5, 3}, {9, 7, 4}));  // a floating platform
    CarveResult result;
    World cut = take_box(world, {6, 4, 2}, {7, 8, 5}, result);
    EXPECT_TRUE(result.chunks.empty()) << "it and its parts";
    EXPECT_EQ(locate(cut.solid(), {5.5, 6, 3.5}), Where::kSolid);
    EXPECT_EQ(locate(cut.solid(), {8, 6, 3.5}), Where::kSolid);
    // Until the author says otherwise.
    cut = with_anchors(world, {.hanging = false});
    cut = take_box(cut, {6, 4, 2}, {7, 8, 5}, result);
    EXPECT_EQ(result.chunks.size(), 2u) << "nothing holds either part";
    // What is put there later stays as well.
    world = put_box(world, {12, 5, 3}, {16, 7, 4});
    cut = take_box(world, {13, 4, 2}, {14, 8, 5}, result);
    EXPECT_TRUE(result.chunks.empty());
}

/// A fill that swallows what hung there, or joins something else as well: the bodies that its faces bound alone hang
/// free, and no others.
TEST(Chunks, BodiesOfAFillThatHangFreeStay) {
    World world = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    world = with_anchors(world, {.hanging = false});
    const World pebble = with_anchors(put_box(world, {6, 5.5, 3.25}, {7, 6.5, 3.75}), {.hanging = false});
    CarveResult result;
    World cut = take_box(put_box(pebble, {5, 5, 3}, {9, 7, 4}), {6, 4, 2}, {7, 8, 5}, result);
    EXPECT_TRUE(result.chunks.empty()) << "it swallowed the pebble";
    EXPECT_EQ(locate(cut.solid(), {5.5, 6, 3.5}), Where::kSolid);
    EXPECT_EQ(locate(cut.solid(), {8, 6, 3.5}), Where::kSolid);

    // Two boxes in one cutter: one in the air, one into the wall.
    test::TriangleMesh two = test::box_mesh({5, 5, 3}, {9, 7, 4});
    const test::TriangleMesh other = test::box_mesh({15, 5, 3}, {21, 7, 4});
    const auto first = std::uint32_t(two.vertices.size());
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const CutterTriangle& t : other.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const CarveResult filled = fill(world, two.cutter().value(), {});
    ASSERT_TRUE(filled.done()) << filled.error.reason;
    cut = take_box(filled.world, {6, 4, 2}, {7, 8, 5}, result);
    EXPECT_TRUE(result.chunks.empty());
    take_box(cut, {17, 4, 2}, {18, 8, 5}, result);
    ASSERT_EQ(result.chunks.size(), 1u) << "what the wall held";
    EXPECT_EQ(result.chunks[0].mass.volume, 2 * 2 * 1.0);
    test::expect_sound_world(cut);
}

TEST(Chunks, TheAuthorSaysWhatHolds) {
    // A slab in the open, with a tower on it.
    World world = make_world(test::box_level({0, 0, 0}, {20, 20, 1})).value();
    world = put_box(world, {9, 9, 1}, {11, 11, 9});
    CarveResult result;
    take_box(with_anchors(world), {8, 8, 2}, {12, 12, 3}, result);
    EXPECT_TRUE(result.chunks.empty()) << "all of it hangs free";
    // Its lower side, face 4 of the level, holds it up.
    World held = with_anchors(world, {.hanging = false, .materials = {}, .sources = {4}});
    World cut = take_box(held, {8, 8, 2}, {12, 12, 3}, result);
    ASSERT_EQ(result.chunks.size(), 1u);
    EXPECT_EQ(result.chunks[0].mass.volume, 4 * 6.0);
    EXPECT_EQ(locate(cut.solid(), {10, 10, 1.5}), Where::kSolid);
    // So may a material.
    CarveOptions steel;
    steel.material = "steel";
    world = take_box(world, {9, 9, 8}, {11, 11, 9.5}, result, steel);
    held = with_anchors(world, {.hanging = false, .materials = {"steel"}, .sources = {4}});
    take_box(held, {8, 8, 2}, {12, 12, 3}, result);
    EXPECT_TRUE(result.chunks.empty()) << "the tower's top holds";
}

TEST(Chunks, VolumesHold) {
    const World hall = hall_with_bridge();
    CarveResult result;
    const auto chunks_with = [&](const Box& volume) {
        World world = with_anchors(hall, {.volumes = {volume}});
        world = take_box(world, {1, 4, 3}, {2, 7, 5}, result);
        take_box(world, {17, 4, 3}, {18, 7, 5}, result);
        return result.chunks.size();
    };
    EXPECT_EQ(chunks_with({{9, 5, 4.5}, {10, 6, 5}}), 0u) << "the deck reaches the volume's rim";
    EXPECT_EQ(chunks_with({{9, 5, 4.5625}, {10, 6, 5}}), 1u) << "it lies above";
    EXPECT_EQ(chunks_with({{9, 5.25, 4.125}, {10, 5.75, 4.25}}), 0u) << "it lies within the deck";
    EXPECT_EQ(chunks_with({{19, 5, 4}, {20, 6, 5}}), 1u) << "it holds what stays";
    EXPECT_EQ(chunks_with({{10, 5, 4.5}, {9, 6, 5}}), 1u) << "it is empty";
    // What reached into it is shot away: the pillar's foot holds no longer.
    World world = make_world(test::box_level({0, 0, 0}, {4, 4, 10})).value();
    world = with_anchors(world, {.hanging = false, .volumes = {{{0, 0, -1}, {4, 4, 0.5}}}});
    take_box(world, {-1, -1, -1}, {5, 5, 1}, result);
    EXPECT_EQ(result.chunks.size(), 1u);
    // The depot's author says what holds.
    const std::vector<Box> volumes = anchor_volumes(test::depot_level());
    ASSERT_GE(volumes.size(), 4u);
    EXPECT_EQ(volumes[0], (Box{{-1, 0, 9.75}, {26, 14, 10.75}})) << "the hall's roof";
}

/// What held a piece may be gone though it is in one piece still.
TEST(Chunks, TheAnchorItselfMayBeShotAway) {
    World world = make_world(test::box_level({0, 0, 0}, {20, 20, 20})).value();
    world = with_anchors(world, {.hanging = false, .materials = {}, .sources = {4}});
    CarveResult result;
    const World cut = take_box(world, {-1, -1, -1}, {21, 21, 1}, result);
    ASSERT_EQ(result.chunks.size(), 1u);
    EXPECT_EQ(result.chunks[0].mass.volume, 20 * 20 * 19);
    EXPECT_EQ(cut.face_count(), 0u);
}

/// A hollow goes with the piece around it; what hangs free in it stays.
TEST(Chunks, HollowsGoWithTheirPiece) {
    World world = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    world = put_box(world, {9, 5, 0}, {11, 7, 1});
    world = put_box(world, {7, 3, 1}, {13, 9, 7});
    CarveResult result;
    world = take_box(world, {8, 4, 2}, {12, 8, 6}, result, {});
    world = with_anchors(put_box(world, {9, 5, 3}, {11, 7, 5}));
    world = take_box(world, {9.5, 5.5, 3.5}, {10.5, 6.5, 4.5}, result);
    EXPECT_TRUE(result.chunks.empty());
    const World cut = take_box(world, {8.5, 4.5, 0.25}, {11.5, 7.5, 0.75}, result);
    ASSERT_EQ(result.chunks.size(), 1u);
    EXPECT_EQ(result.chunks[0].mass.volume, 6 * 6 * 6 - 4 * 4 * 4 + 4 * 0.25);
    EXPECT_EQ(measure_solid(result.chunks[0].solid).volume, result.chunks[0].mass.volume);
    EXPECT_EQ(locate(cut.solid(), {9.25, 6, 4}), Where::kSolid) << "the body in the hollow";
    EXPECT_EQ(locate(cut.solid(), {10, 6, 4}), Where::kAir) << "and its own hollow";
    EXPECT_EQ(locate(cut.solid(), {7.5, 6, 4}), Where::kAir);
    test::expect_sound_world(cut);
}

/// A cutter with a hollow leaves a ball that touches nothing.
TEST(Chunks, FromWithinACutter) {
    test::TriangleMesh mesh;
    const auto add_box = [&](double half, bool inward) {
        test::TriangleMesh box = test::box_mesh({-half, -half, -half}, {half, half, half});
        if (inward) box.turn_over();
        mesh.add(box);
    };
    add_box(2, false);
    add_box(1, true);
    const World rock = with_anchors(make_world(test::box_level({0, 0, 0}, {8, 8, 8}, true)).value());
    const CarveResult result = carve(rock, mesh.cutter().value(), {.position = {20, 4, 4}}, with_chunks());
    ASSERT_TRUE(result.done());
    ASSERT_EQ(result.chunks.size(), 1u);
    EXPECT_EQ(result.chunks[0].mass.volume, 8);
    EXPECT_EQ(locate(result.world.solid(), {20, 4, 4}), Where::kAir);
    // Where it swallows the hall, what was a column in it comes loose as well.
    World hall = with_anchors(
        put_box(make_world(test::box_level({0, 0, 0}, {1, 1, 2}, true)).value(), {0.25, 0.25, 0}, {0.75, 0.75, 2}));
    const CarveResult all = carve(hall, mesh.cutter().value(), {.position = {0.5, 0.5, 1}}, with_chunks());
    ASSERT_TRUE(all.done());
    ASSERT_EQ(all.chunks.size(), 2u) << "the rock around the hall, and the column, as high as the hall";
    EXPECT_EQ(all.chunks[0].mass.volume + all.chunks[1].mass.volume, 8 - 2 + 0.5);
    test::expect_sound_world(all.world);
}

/// A cutter around what it leaves of the rock beside a hollow, which opens the hall as well.
TEST(Chunks, WhatHungInAHollow) {
    CarveResult result;
    World world = with_anchors(make_world(test::box_level({0, 0, 0}, {8, 8, 8}, true)).value());
    world = take_box(world, {8.75, 3.25, 3.25}, {10.25, 4.75, 4.75}, result);
    test::TriangleMesh mesh = test::box_mesh({7.75, 1.75, 1.75}, {12.25, 6.25, 6.25});
    test::TriangleMesh inner = test::box_mesh({9, 3, 3}, {11, 5, 5});
    inner.turn_over();
    mesh.add(inner);
    const CarveResult cut = carve(world, mesh.cutter().value(), {}, with_chunks());
    ASSERT_TRUE(cut.done());
    ASSERT_EQ(cut.chunks.size(), 1u);
    EXPECT_EQ(cut.chunks[0].mass.volume, 2 * 2 * 2 - 1.25 * 1.5 * 1.5);
    EXPECT_EQ(locate(cut.world.solid(), {10.75, 4, 4}), Where::kAir);
    test::expect_sound_world(cut.world);
}

/// What only the cutter bounds comes off nothing: no face is looked for, however large the level.
TEST(Chunks, ANewHollowIsNoReasonToSearch) {
    CarveResult result;
    World world = with_anchors(hall_with_bridge());
    world = take_box(world, {4, 4, -2}, {6, 6, 0}, result);
    // It touches the pit along an edge, and is not open to it.
    world = take_box(world, {6, 4, -4}, {8, 6, -2}, result);
    EXPECT_TRUE(result.chunks.empty());
    EXPECT_EQ(result.report.faces_searched, 0u);
    test::expect_sound_world(world);
    // A cutter of two parts, one in the rock and one in the floor.
    test::TriangleMesh mesh = test::box_mesh({10, 4, -3}, {12, 6, -2});
    mesh.add(test::box_mesh({10, 4, -1}, {12, 6, 1}));
    const CarveResult two = carve(world, mesh.cutter().value(), {}, with_chunks());
    ASSERT_TRUE(two.done());
    EXPECT_TRUE(two.chunks.empty());
    EXPECT_EQ(two.report.faces_searched, 0u);
    EXPECT_EQ(two.report.volume, 4 + 4);
}

/// Where the two ends of a pillar are seen to end in rock, no face around the room is looked for.
TEST(Chunks, APillarCutInTwoIsNoReasonToGoAroundTheRoom) {
    scenes::Rng rng(7);
    World world = with_anchors(make_world(scenes::level_of(scenes::bumpy_rooms(rng, 1, 18, {}).faces)).value());
    world = put_box(world, {5, 5, -1}, {6, 6, 7});
    CarveResult result;
    world = take_box(world, {4, 4, 2}, {7, 7, 4}, result);
    EXPECT_TRUE(result.chunks.empty());
    EXPECT_GT(world.face_count(), 1000u);
    EXPECT_GT(result.report.faces_searched, 0u);
    EXPECT_LT(result.report.faces_searched, 100u);
}

TEST(Chunks, CrumbsAreCountedAndGone) {
    const World world = with_anchors(hall_with_bridge());
    CarveResult result;
    const World one_end = take_box(world, {1, 4, 3}, {2, 7, 5}, result);
    const World both =
        take_box(one_end, {17, 4, 3}, {18, 7, 5}, result, with_chunks({.min_volume = 7.75, .density = 1}));
    EXPECT_TRUE(result.chunks.empty());
    EXPECT_EQ(result.report.crumbs, 1u);
    EXPECT_EQ(result.report.crumb_volume, 7.5);
    EXPECT_EQ(result.report.chunks, 0u);
    EXPECT_EQ(locate(both.solid(), {9, 5.5, 4.25}), Where::kAir);
    test::expect_sound_world(both);
}

TEST(Chunks, KeepSourcesAndMaterials) {
    World world = hall_with_bridge();
    CarveOptions options = with_chunks();
    options.material = "charred";
    CarveResult result;
    // Nothing was said of what holds: what hangs free now.
    const World before = take_box(world, {1, 4, 3}, {2, 7, 5}, result, options);
    ASSERT_TRUE(before.data().anchors);
    EXPECT_TRUE(*before.data().anchors == *with_anchors(world).data().anchors);
    world = take_box(before, {17, 4, 3}, {18, 7, 5}, result, options);
    ASSERT_EQ(result.chunks.size(), 1u);
    const World body = make_world(result.chunks[0].solid).value();
    std::uint32_t charred = 0;
    while (world.material_name(charred) != "charred") ++charred;
    int ends = 0, sides = 0;
    for (const Face& face : body.faces()) {
        if (face.material == charred) {
            ++ends;
            EXPECT_TRUE(face.source_edit == 2 || face.source_edit == 3);
            EXPECT_EQ(std::abs(face.normal.x), 1);
        } else {
            ++sides;
            EXPECT_EQ(face.source_edit, 1u) << "of the fill that made the bridge";
            EXPECT_EQ(face.normal.x, 0);
        }
    }
    EXPECT_GE(ends, 2);
    EXPECT_GE(sides, 4);
    EXPECT_EQ(result.chunks[0].solid.edits(), 3u);
    const WorldDiff diff = diff_worlds(before, world);
    EXPECT_EQ(diff.removed.size(), result.report.faces_removed) << "in one";
    EXPECT_EQ(diff.added.size(), result.report.faces_added);
}

/// In its frame, also into several.
TEST(Chunks, AreCutOn) {
    CarveResult result;
    World world = take_box(with_anchors(hall_with_bridge()), {1, 4, 3}, {2, 7, 5}, result);
    world = take_box(world, {17, 4, 3}, {18, 7, 5}, result);
    ASSERT_EQ(result.chunks.size(), 1u);
    const Chunk& chunk = result.chunks[0];
    Pose pose;
    pose.scale = 1;
    pose.position = Vec3{9, 5.5, 4.25} - chunk.origin;
    const SolidResult cut = subtract(chunk.solid, make_crater(CutterShape::kRocky, 5), pose);
    ASSERT_TRUE(cut.done());
    const std::vector<Solid> parts = connected_pieces(cut.solid);
    ASSERT_EQ(parts.size(), 2u);
    double sum = 0;
    for (const Solid& part : parts) {
        EXPECT_FALSE(check_solid(part));
        sum += mass_properties(part, 1).volume;
        EXPECT_EQ(part.edits(), cut.solid.edits());
    }
    EXPECT_NEAR(sum, chunk.mass.volume - cut.report.volume, 1e-12);
    EXPECT_TRUE(same_solid(unite(parts[0], cutter_from_solid(parts[1]).value(), {}).solid, cut.solid));
}

TEST(ConnectedPieces, WithTheirHollows) {
    EXPECT_TRUE(connected_pieces(Solid()).empty());
    Level level = test::box_level({0, 0, 0}, {10, 10, 10});
    test::add_box(level, {1, 1, 1}, {5, 5, 5}, true);
    test::add_box(level, {2, 2, 2}, {4, 4, 4});
    test::add_box(level, {2.5, 2.5, 2.5}, {3.5, 3.5, 3.5}, true);
    test::add_box(level, {6, 6, 6}, {8, 8, 8}, true);
    test::add_box(level, {20, 0, 0}, {21, 1, 1});
    const Solid all = make_solid(level).value();
    const std::vector<Solid> pieces = connected_pieces(all);
    ASSERT_EQ(pieces.size(), 3u);
    EXPECT_EQ(measure_solid(pieces[0]).volume, 1000 - 64 - 8);
    EXPECT_EQ(measure_solid(pieces[1]).volume, 8 - 1);
    EXPECT_EQ(measure_solid(pieces[2]).volume, 1);
    for (const Solid& piece : pieces) EXPECT_FALSE(piece.rock_outside());
    const Solid one = make_solid(test::box_level({0, 0, 0}, {1, 1, 1})).value();
    ASSERT_EQ(connected_pieces(one).size(), 1u);
    EXPECT_EQ(hash_solid(connected_pieces(one)[0]), hash_solid(one));

    Level cave = test::box_level({0, 0, 0}, {10, 10, 10}, true);
    test::add_box(cave, {20, 0, 0}, {25, 5, 5}, true);
    test::add_box(cave, {2, 2, 2}, {3, 3, 3});
    const std::vector<Solid> of_cave = connected_pieces(make_solid(cave).value());
    ASSERT_EQ(of_cave.size(), 2u);
    EXPECT_TRUE(of_cave[0].rock_outside());
    EXPECT_EQ(measure_solid(of_cave[0]).volume, -1000 - 125);
    EXPECT_EQ(measure_solid(of_cave[1]).volume, 1);
}

/// Slices and several edits as one give the same.
TEST(Chunks, InSlicesAndInEdits) {
    CarveResult result;
    const World world = take_box(with_anchors(hall_with_bridge()), {1, 4, 3}, {2, 7, 5}, result);
    const Cutter crater = make_crater(CutterShape::kRocky, 1);
    const Pose pose = test::pose_at(17, 5.5, 4.25, 1.3);
    const CarveResult at_once = carve(world, crater, pose, with_chunks());
    ASSERT_EQ(at_once.chunks.size(), 1u);
    CarveJob job(world, crater, pose, with_chunks());
    int slices = 1;
    while (!job.run(0)) ++slices;
    EXPECT_GT(slices, 10);
    WorldEdit edit(world);
    const CarveResult in_edit = edit.carve(crater, pose, with_chunks());
    const CarveResult from_file = carve(unpack_world(pack_world(world), "test").value(), crater, pose, with_chunks());
    for (const CarveResult& again : {in_edit, job.result(), from_file}) {
        ASSERT_EQ(again.chunks.size(), 1u);
        EXPECT_EQ(hash_world(again.world), hash_world(at_once.world));
        EXPECT_EQ(hash_solid(again.chunks[0].solid), hash_solid(at_once.chunks[0].solid));
        EXPECT_EQ(again.chunks[0].mass.inertia, at_once.chunks[0].mass.inertia);
        EXPECT_EQ(again.chunks[0].origin, at_once.chunks[0].origin);
    }
    EXPECT_EQ(edit.finish().version(), world.version() + 1);
}

/// The depot's bridge, 14 m from wall to wall, with its rails; and a pillar.
TEST(Chunks, TheDepotsBridge) {
    World world = with_anchors(make_world(test::depot_level()).value());
    const reference::HangingFaces hanging = reference::hanging_faces(world);
    EXPECT_GT(hanging.size(), 0u) << "the outer side of the depot's hull";
    const Cutter rocky = make_crater(CutterShape::kRocky, 3);
    std::size_t loose = 0;
    for (const Pose& pose : {test::pose_at(4.75, 3.25, 3, 1.2), test::pose_at(14, 2, 3.75, 2.2),
                             test::pose_at(14, 12, 3.75, 2.2), test::pose_at(4.75, 3.25, 7, 1.2)}) {
        const CarveResult result = carve(world, rocky, pose, with_chunks());
        ASSERT_TRUE(result.done()) << result.error.reason;
        const reference::ChunkVerdict verdict =
            reference::judge_chunks(world, hanging, result, carve(world, rocky, pose));
        ASSERT_EQ(verdict.fault, "");
        loose += verdict.loose;
        world = result.world;
    }
    EXPECT_GE(loose, 2u);
    EXPECT_EQ(locate(world.solid(), {14, 7, 3.75}), Where::kAir);
}

TEST(Chunks, ShotsInTheDepotAsAFloodOfEverythingFinds) {
    World world = with_anchors(make_world(test::depot_level()).value());
    const reference::HangingFaces hanging = reference::hanging_faces(world);
    std::size_t loose = 0, done = 0;
    scenes::Rng rng(11);
    for (int k = 0; k < test::sample(100); ++k) {
        Pose pose;  // at the bridge, and the crane over it
        pose.position = {rng.uniform(12, 18), rng.uniform(0, 14), rng.uniform(2, 10)};
        pose.rotation = random_turn(rng.next());
        pose.scale = rng.uniform(0.4, 2);
        const Cutter cutter = make_crater(rng.chance(0.5) ? CutterShape::kRocky : CutterShape::kBox, rng.next());
        const CarveResult result = carve(world, cutter, pose, with_chunks());
        const reference::ChunkVerdict verdict =
            reference::judge_chunks(world, hanging, result, carve(world, cutter, pose));
        ASSERT_EQ(verdict.fault, "") << "cut " << k;
        loose += verdict.loose;
        done += result.done();
        world = result.world;
    }
    EXPECT_GT(done, std::size_t(test::sample(50)));
    EXPECT_GE(loose, std::size_t(test::sample(5)));
}

/// Pillars, bridges and slabs in a hall, shot at until little is left: the search finds what a flood of all faces
/// finds.
TEST(Chunks, AsAFloodOfEverythingFinds) {
    std::size_t loose = 0, done = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(test::sample(10)); ++seed) {
        const reference::ChunkHallVerdict verdict = reference::judge_chunk_hall(seed, 60);
        EXPECT_EQ(verdict.fault, "") << "seed " << seed;
        loose += verdict.loose;
        done += verdict.done;
    }
    EXPECT_GT(done, std::size_t(test::sample(300)));
    EXPECT_GT(loose, std::size_t(test::sample(60)));
}

/// Its cut 76 cuts a beam at two places that do not know of each other, and each leads to the piece between them.
/// (tests/full/full_chunks.cpp, seed 1)
TEST(Chunks, APieceIsFoundOnce) {
    const reference::ChunkHallVerdict verdict = reference::judge_chunk_hall((std::uint64_t(1) << 32) + 101, 77);
    EXPECT_EQ(verdict.fault, "");
    EXPECT_GT(verdict.loose, 20u);
}

}  // namespace
}  // namespace firma

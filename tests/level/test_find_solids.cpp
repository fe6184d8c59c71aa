// SPDX-License-Identifier: MIT
// Which pieces of a level can be carved, and why others cannot; and that what can be is sound.
#include "level/find_solids.h"

#include <gtest/gtest.h>

#include "level/pair_edges.h"
#include "scenes/rng.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using test::add_box;
using test::add_polygon;
using test::box_level;

std::size_t solid_count(const LevelSolids& found) {
    return std::size_t(std::count(found.solid.begin(), found.solid.end(), true));
}

void expect_sound(const Level& level, double volume) {
    const World world = make_world(level).value();
    EXPECT_FALSE(check_world(world));
    const auto fault = check_solid(world);
    EXPECT_FALSE(fault) << fault->what << " at " << fault->at.x << " " << fault->at.y << " " << fault->at.z;
    EXPECT_EQ(measure_solid(world).volume, volume);
}

TEST(FindSolids, ABox) {
    const LevelSolids found = find_solids(box_level({0, 0, 0}, {1, 2, 3}));
    EXPECT_EQ(solid_count(found), 6u);
    EXPECT_FALSE(found.rock_outside);
    EXPECT_TRUE(found.notes.empty());
    EXPECT_TRUE(found.stored.empty());
    expect_sound(box_level({0, 0, 0}, {1, 2, 3}), 6);
}

TEST(FindSolids, ARoomInRock) {
    const LevelSolids found = find_solids(box_level({0, 0, 0}, {1, 2, 3}, true));
    EXPECT_EQ(solid_count(found), 6u);
    EXPECT_TRUE(found.rock_outside);
    expect_sound(box_level({0, 0, 0}, {1, 2, 3}, true), -6);
}

TEST(FindSolids, AnOpenBoxNamesItsHole) {
    Level level = box_level({0, 0, 0}, {1, 1, 1});
    level.faces.pop_back();
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 0u);
    ASSERT_EQ(found.notes.size(), 1u);
    const SolidNote& note = found.notes[0];
    EXPECT_EQ(note.what, SolidNoteKind::kOpenEdge);
    EXPECT_EQ(note.faces, 5u);
    EXPECT_EQ(note.at.z, 1) << "around the missing lid";
    EXPECT_EQ(note.to.z, 1);
    EXPECT_EQ(length(note.to - note.at), 1);
    EXPECT_LT(note.source, 4u) << "one of its neighbours";
}

TEST(FindSolids, ASeparateOpenQuadHarmsNothing) {
    Level level = box_level({0, 0, 0}, {1, 1, 1});
    add_polygon(level, {{3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 0}});
    add_polygon(level, {{0.5, 0.5, 0.5}, {2, 0.5, 0.5}, {2, 0.6, 0.5}, {0.5, 0.6, 0.5}});  // through a wall
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 6u);
    EXPECT_FALSE(found.solid[6]);
    ASSERT_EQ(found.notes.size(), 2u);
    EXPECT_EQ(found.notes[0].source, 6u);
    EXPECT_EQ(found.notes[1].source, 7u);
    expect_sound(level, 1);
}

TEST(FindSolids, TwoSidedFacesAndVerticesOffTheGrid) {
    Level level = box_level({0, 0, 0}, {1, 1, 1});
    add_box(level, {3, 0, 0}, {4, 1, 1});
    level.faces[2].two_sided = true;
    for (GridPoint& p : level.vertices)
        if (p == snap({4, 1, 1}).value()) p = {p.x + 1, p.y + 1, p.z + 1};
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 0u);
    ASSERT_EQ(found.notes.size(), 2u);
    EXPECT_EQ(found.notes[0].what, SolidNoteKind::kTwoSided);
    EXPECT_EQ(found.notes[0].source, 2u);
    EXPECT_EQ(found.notes[1].what, SolidNoteKind::kOffGrid);
    EXPECT_EQ(found.notes[1].at.x, 4 + 1 / kSurfaceSteps);
}

TEST(FindSolids, BoxesThatCross) {
    Level level = box_level({0, 0, 0}, {2, 2, 2});
    add_box(level, {1, 1, 1}, {3, 3, 3});
    add_box(level, {5, 0, 0}, {6, 1, 1});
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 6u) << "the third one";
    ASSERT_EQ(found.notes.size(), 2u);
    EXPECT_EQ(found.notes[0].what, SolidNoteKind::kCrossing);
    EXPECT_LT(found.notes[0].source, 6u);
    EXPECT_EQ(found.notes[0].other / 6, 1u) << "one of the other box's";
    EXPECT_EQ(found.notes[1].source / 6, 1u);
    EXPECT_LT(found.notes[1].other, 6u);
    expect_sound(level, 1);
}

TEST(FindSolids, BoxesThatTouch) {
    Level wall = box_level({0, 0, 0}, {2, 2, 2});
    add_box(wall, {2, 0.5, 0.5}, {3, 1.5, 1.5});
    EXPECT_EQ(solid_count(find_solids(wall)), 0u) << "faces that overlap";
    Level same = box_level({0, 0, 0}, {2, 2, 2});
    add_box(same, {2, 0, 0}, {4, 2, 2});
    EXPECT_EQ(solid_count(find_solids(same)), 0u) << "a face in common, there twice";
    Level corner = box_level({0, 0, 0}, {2, 2, 2});
    add_polygon(corner, {{2, 1, 1}, {3, 1, 1}, {3, 2, 1}});  // a tetrahedron with its point on the wall
    add_polygon(corner, {{2, 1, 1}, {3, 2, 1}, {3, 1, 2}});
    add_polygon(corner, {{2, 1, 1}, {3, 1, 2}, {3, 1, 1}});
    add_polygon(corner, {{3, 1, 1}, {3, 1, 2}, {3, 2, 1}});
    EXPECT_EQ(solid_count(find_solids(corner)), 0u) << "a corner on a face";
}

TEST(FindSolids, BoxesThatShareAVertex) {
    Level level = box_level({0, 0, 0}, {1, 1, 1});
    add_box(level, {1, 1, 1}, {2, 2, 2});
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 12u);
    EXPECT_TRUE(found.notes.empty());
    EXPECT_TRUE(found.stored.empty());
    expect_sound(level, 2);
}

Level sharing_an_edge() {
    Level level = box_level({-4, -4, -4}, {0, 0, 4});
    add_box(level, {0, 0, -4}, {4, 4, 4});
    return level;
}

TEST(FindSolids, BoxesThatShareAnEdge) {
    const Level level = sharing_an_edge();
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 12u);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.stored.size(), 4u) << "the faces on the edge";
    std::vector<std::pair<const SolidEdge*, Vec3>> doubled;
    for (const auto& [face, exact] : found.stored)
        for (const SolidUse& use : exact->uses)
            if (use.edge().doubled) doubled.emplace_back(&use.edge(), exact->normal);
    ASSERT_EQ(doubled.size(), 4u);
    for (const auto& [edge, normal] : doubled) {
        std::vector<Vec3> partners;
        for (const auto& [other, direction] : doubled)
            if (other == edge && direction != normal) partners.push_back(direction);
        ASSERT_EQ(partners.size(), 1u) << "two copies, two faces each";
        EXPECT_EQ(dot(partners[0], normal), 0);
        EXPECT_TRUE((normal + partners[0] == Vec3{1, -1, 0}) || (normal + partners[0] == Vec3{-1, 1, 0}))
            << "both look into the same quarter of air";
    }
    expect_sound(level, 256);
}

/// Along z, at 0, 120 and 240 degrees or so, all with one edge in common.
Level three_wedges(double height) {
    Level level = test::empty_level();
    const Vec3 rim[6] = {{4, 1, 0}, {4, -1, 0}, {-1, 4, 0}, {-3, 3, 0}, {-3, -3, 0}, {-1, -4, 0}};
    const Vec3 up{0, 0, height}, o;
    for (int k = 0; k < 6; k += 2) {
        Vec3 a = rim[k], b = rim[k + 1];
        if (a.x * b.y - a.y * b.x < 0) std::swap(a, b);
        add_polygon(level, {o, b, a});
        add_polygon(level, {o + up, a + up, b + up});
        add_polygon(level, {o, a, a + up, o + up});
        add_polygon(level, {a, b, b + up, a + up});
        add_polygon(level, {b, o, o + up, b + up});
    }
    return level;
}

TEST(FindSolids, SolidsAroundOneEdge) {
    const Level level = three_wedges(2);
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 15u);
    EXPECT_EQ(found.stored.size(), 6u);
    expect_sound(level, 8 + 9 + 9);
}

TEST(FindSolids, FacesThatLieOnEachOther) {
    // The same triangle from both sides: closed, without volume.
    Level level = test::empty_level();
    add_polygon(level, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    add_polygon(level, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});
    const LevelSolids found = find_solids(level);
    EXPECT_EQ(solid_count(found), 0u);
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_EQ(found.notes[0].what, SolidNoteKind::kCrossing);
    // Twice the same box: each edge four times.
    Level twice = box_level({0, 0, 0}, {1, 1, 1});
    add_box(twice, {0, 0, 0}, {1, 1, 1});
    const LevelSolids folded = find_solids(twice);
    EXPECT_EQ(solid_count(folded), 0u);
    ASSERT_EQ(folded.notes.size(), 1u);
    EXPECT_EQ(folded.notes[0].what, SolidNoteKind::kFoldedEdge);
}

TEST(FindSolids, ShellsInShells) {
    Level level = box_level({4, 4, 4}, {5, 5, 5});           // a stone in the room
    add_box(level, {0, 0, 0}, {10, 10, 10});                 // a block of rock
    add_box(level, {1, 1, 1}, {9, 9, 9}, true);              // a room in it
    add_box(level, {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});  // a solid in the solid
    add_box(level, {6, 6, 6}, {7, 7, 7}, true);              // a hollow in the air
    add_box(level, {20, 0, 0}, {21, 1, 1}, true);            // another, outside
    const LevelSolids found = find_solids(level);
    EXPECT_FALSE(found.rock_outside);
    EXPECT_EQ(solid_count(found), 18u);
    ASSERT_EQ(found.notes.size(), 3u);
    for (std::uint32_t k = 0; k < 3; ++k) {
        EXPECT_EQ(found.notes[k].what, SolidNoteKind::kWrongWay);
        EXPECT_EQ(found.notes[k].source / 6, 3 + k);
    }
    expect_sound(level, 1000 - 512 + 1);
}

/// Octahedra in each other, turned outward and inward by turns, their corners along three directions at right angles.
Level onion(int shells, bool tilted) {
    constexpr double kTilted[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
    Level level = test::empty_level();
    for (int shell = shells; shell > 0; --shell) {
        const auto corner = [&](int axis, bool back) {
            const double radius = (back ? -0.05 : 0.05) * shell;
            Vec3 p;
            for (int k = 0; k < 3; ++k) p[k] = tilted ? radius * kTilted[axis][k] : axis == k ? radius : 0;
            return to_metres(snap(p).value());
        };
        for (int octant = 0; octant < 8; ++octant) {
            std::vector<Vec3> face{corner(0, octant & 1), corner(1, octant & 2), corner(2, octant & 4)};
            const bool mirrored = ((octant ^ octant >> 1 ^ octant >> 2) & 1) != 0;
            if (mirrored != ((shells - shell) % 2 != 0)) std::swap(face[1], face[2]);
            add_polygon(level, face);
        }
    }
    return level;
}

std::uint64_t work_of(const SolidWork& work) {
    return work.of_pairs() + work.on_rays;
}

// Finding 9 (F9): time grew with the square of the shells.
TEST(FindSolids, AnOnionTakesLittleMoreThanInProportion) {
    for (const bool tilted : {false, true}) {
        const LevelSolids small = find_solids(onion(250, tilted)), large = find_solids(onion(1000, tilted));
        EXPECT_EQ(solid_count(small), 8u * 250);
        EXPECT_EQ(solid_count(large), 8u * 1000);
        EXPECT_LT(work_of(large.work), 6 * work_of(small.work)) << "four times the faces, and a few bins more a face";
        EXPECT_LE(large.work.on_rays, 2u * 8 * 1000) << "a ray or two";
    }
}

TEST(FindSolids, ARottenOnionIsJudgedAsShellByShell) {
    Level level = onion(700, false);
    add_box(level, {9, 9, 9}, {9.5, 9.5, 9.5});            // between two shells
    add_box(level, {13.01, 11, 9}, {13.02, 11.01, 9.01});  // through none
    add_box(level, {1, 1, 1}, {1.5, 1.5, 1.5});            // through some
    add_box(level, {40, 0, 0}, {41, 1, 1}, true);          // outside, and inward
    const LevelSolids found = find_solids(level);
    std::size_t crossing = 0;
    for (const SolidNote& note : found.notes) crossing += note.what == SolidNoteKind::kCrossing;
    // x + y + z of the boxes, in twentieths of a metre: from 540 to 570, and from 60 to 90; shells at whole numbers.
    EXPECT_EQ(crossing, 31u + 1 + 31u + 1);
    // Without 31 shells the next one is turned as the last one around it; so is the box outside, as a hollow in the
    // air.
    EXPECT_EQ(found.notes.size(), crossing + 3);
    EXPECT_EQ(found.notes.back().what, SolidNoteKind::kWrongWay);
    EXPECT_EQ(solid_count(found), 8u * (700 - 64) + 6);
}

TEST(FindSolids, WhatWouldTakeTooLongIsCastableOnly) {
    Level level = onion(40, false);
    add_box(level, {30, 0, 0}, {31, 1, 1});
    const SolidMesh mesh = solid_mesh(level);
    for (const std::uint64_t pairs_with_boxes : {0, 64}) {
        SolidPieces pieces = join_pieces(mesh);
        pieces.limits = {pairs_with_boxes, 300, 0};
        const FaceTree tree = good_faces(mesh, pieces);
        refuse_crossing(mesh, tree, pieces);
        refuse_wrong_way(mesh, tree, pieces);
        std::size_t refused = 0;
        for (const SolidPieces::Piece& piece : pieces.pieces) {
            if (!piece.note) continue;
            EXPECT_EQ(piece.note->what, SolidNoteKind::kTooComplex);
            ++refused;
        }
        if (pairs_with_boxes == 0)
            EXPECT_GT(refused, 30u) << "by pairs";
        else
            EXPECT_EQ(refused, 0u) << "boxes are enough, and so is one ray";
    }
    SolidPieces pieces = join_pieces(mesh);
    pieces.limits = {64, 0, 0};
    const FaceTree tree = good_faces(mesh, pieces);
    refuse_wrong_way(mesh, tree, pieces);
    ASSERT_TRUE(pieces.pieces.back().note) << "the box is larger than the innermost shell, whose ray was the last";
    EXPECT_EQ(pieces.pieces.back().note->what, SolidNoteKind::kTooComplex);
    EXPECT_FALSE(pieces.pieces.front().note) << "known from that ray";
}

TEST(FindSolids, RockOutsideIsWhatTheOutermostPieceSays) {
    // The largest piece is a block inside a room that reaches farther, thin as it is.
    Level level = box_level({0, 0, 0}, {10, 10, 10}, true);
    add_box(level, {0.5, 0.5, 0.5}, {9.5, 9.5, 9.5});
    const LevelSolids found = find_solids(level);
    EXPECT_TRUE(found.rock_outside);
    EXPECT_EQ(solid_count(found), 12u);
    expect_sound(level, 729 - 1000);
}

TEST(PairSides, AsAnglesSay) {
    scenes::Rng rng(7);
    int paired = 0;
    for (int k = 0; k < 2000; ++k) {
        // Rays around the z axis; apexes anywhere above them.
        std::vector<InputPoint> points = {{0, 0, 0}, {0, 0, 10}};
        std::vector<EdgeSide> uses;
        std::vector<std::uint32_t> apexes;
        const std::uint32_t count = 2 * (1 + rng.below(4));
        for (std::uint32_t i = 0; i < count; ++i) {
            InputPoint p;
            do {
                p.x = std::int32_t(rng.below(9)) - 4;
                p.y = std::int32_t(rng.below(9)) - 4;
            } while (p.x == 0 && p.y == 0);
            p.z = std::int32_t(rng.below(20)) - 5;
            points.push_back(p);
            i % 2 == 0 ? uses.emplace_back(0, 1, i) : uses.emplace_back(1, 0, i);
            apexes.push_back(i + 2);
        }
        std::vector<std::uint32_t> order(count);
        for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
        const auto angle = [&](std::uint32_t i) {
            return std::atan2(double(points[i + 2].y), double(points[i + 2].x));
        };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
        bool alternate = true;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t here = order[i], next = order[(i + 1) % count];
            alternate &= uses[here].upward != uses[next].upward && angle(here) != angle(next);
        }
        const auto pairs = pair_sides(points, uses, apexes);
        EXPECT_EQ(!pairs.empty(), alternate) << k;
        if (pairs.empty()) continue;
        ++paired;
        EXPECT_EQ(pairs.size(), count / 2);
        for (const auto& [up, down] : pairs) {
            EXPECT_TRUE(uses[up].upward);
            const auto at = std::size_t(std::find(order.begin(), order.end(), up) - order.begin());
            EXPECT_EQ(order[(at + 1) % count], down) << k;
        }
    }
    EXPECT_GT(paired, 300);
}

TEST(FindSolids, CutsBesideADoubledEdge) {
    World world = make_world(sharing_an_edge()).value();
    // Into faces that have the edge, and across edges next to it, but not through it.
    for (const Vec3& at : {Vec3{-2, 0, 0}, {2, 0, 1}, {0, -2, -1}, {0, 2, 2}, {-3, 0, 4}}) {
        const CarveResult result = carve(world, make_crater(CutterShape::kRocky, 1), {.position = at});
        ASSERT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
        world = result.world;
        const auto fault = check_solid(world);
        ASSERT_FALSE(fault) << fault->what;
        ASSERT_FALSE(check_world(world));
    }
}

/// Carves and fills along an edge at x = y = 0 where solids touch. A cut whose new face would have a hole that touches
/// its rim at the edge is refused: faces have no such loops. One in thirty here.
void expect_edits_along(const Level& level, double low, double high, std::uint64_t seed) {
    World world = make_world(level).value();
    double volume = measure_solid(world).volume;
    scenes::Rng rng(seed);
    int done = 0;
    for (int k = 0; k < 24; ++k) {
        Pose pose;
        pose.position.x = rng.uniform(-0.5, 0.5);
        pose.position.y = rng.uniform(-0.5, 0.5);
        pose.position.z = rng.uniform(low, high);
        pose.rotation = random_turn(std::uint64_t(k));
        pose.scale = rng.uniform(0.3, 1.1);
        const Cutter cutter = make_crater(CutterShape(k % 5), std::uint64_t(k));
        const CarveResult result = k % 3 == 2 ? fill(world, cutter, pose) : carve(world, cutter, pose);
        done += result.done();
        if (result.status == CarveStatus::kRefused) {
            EXPECT_NE(result.error.reason.find("degenerate position"), std::string::npos) << result.error.reason;
        }
        world = result.world;
        const auto fault = check_solid(world);
        ASSERT_FALSE(fault) << k << ": " << fault->what;
        ASSERT_FALSE(check_world(world));
        if (result.done()) volume -= result.report.volume;
        EXPECT_NEAR(measure_solid(world).volume, volume, 1e-9);
    }
    EXPECT_GE(done, 21);
}

TEST(FindSolids, CutsThroughADoubledEdge) {
    World world = make_world(sharing_an_edge()).value();
    for (int k = 0; k < 4; ++k) {
        const Pose pose{{0.1, 0.2, -4.0 + 2 * k}, random_turn(std::uint64_t(k)), 0.8};
        const CarveResult result = carve(world, make_crater(CutterShape(k % 2), std::uint64_t(k)), pose);
        ASSERT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
        world = result.world;
        ASSERT_FALSE(check_solid(world));
    }
}

TEST(FindSolids, EditsAlongADoubledEdge) {
    expect_edits_along(sharing_an_edge(), -4, 4, 1);
    Level rooms = box_level({-6, -6, -6}, {0, 0, 6}, true);
    add_box(rooms, {0, 0, -6}, {6, 6, 6}, true);
    expect_edits_along(rooms, -6, 6, 2);
    Level tiled = box_level({-14, -14, -14}, {0, 0, 14});
    add_box(tiled, {0, 0, -14}, {14, 14, 14});
    expect_edits_along(tiled, -14, 14, 3);
    expect_edits_along(three_wedges(6), 0, 6, 4);
}

}  // namespace
}  // namespace firma

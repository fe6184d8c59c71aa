// SPDX-License-Identifier: MIT
// Cutters that are solids, such that cuts have made too: exact by quarter turns and whole steps, by their facets else.
#include <gtest/gtest.h>

#include <cmath>

#include "carve/place_cutter.h"
#include "carve/pose_turn.h"
#include "firma/carve.h"
#include "firma/solid.h"
#include "scenes/lattice_solids.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using namespace test;

constexpr double kRoot = 0.70710678118654752;  // of a half
constexpr Quaternion kTurns[24] = {
    {0, 0, 0, 1},          {1, 0, 0, 0},           {0, 1, 0, 0},           {0, 0, 1, 0},          {kRoot, 0, 0, kRoot},
    {-kRoot, 0, 0, kRoot}, {0, kRoot, 0, kRoot},   {0, -kRoot, 0, kRoot},  {0, 0, kRoot, kRoot},  {0, 0, -kRoot, kRoot},
    {kRoot, kRoot, 0, 0},  {kRoot, -kRoot, 0, 0},  {kRoot, 0, kRoot, 0},   {kRoot, 0, -kRoot, 0}, {0, kRoot, kRoot, 0},
    {0, kRoot, -kRoot, 0}, {0.5, 0.5, 0.5, 0.5},   {-0.5, 0.5, 0.5, 0.5},  {0.5, -0.5, 0.5, 0.5}, {0.5, 0.5, -0.5, 0.5},
    {0.5, 0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5, 0.5}, {-0.5, 0.5, -0.5, 0.5}, {0.5, -0.5, -0.5, 0.5}};

Solid done(const SolidResult& result) {
    EXPECT_TRUE(result.done()) << (result.status == CarveStatus::kNothing ? "nothing" : result.error.text());
    const auto fault = check_solid(result.solid);
    EXPECT_FALSE(fault) << fault->what;
    return result.solid;
}

Cutter cutter_of(const Solid& solid) {
    const Result<Cutter> cutter = cutter_from_solid(solid, "chunk");
    EXPECT_TRUE(cutter) << cutter.error().text();
    return cutter.value();
}

Solid solid_of(const Cutter& cutter, const Pose& pose) {
    return done(unite(Solid(), cutter, pose));
}

/// A random grid point within `reach` metres.
Vec3 grid_point(scenes::Rng& rng, double reach) {
    const auto steps = [&] { return std::floor(rng.uniform(-reach, reach) * kInputSteps) / kInputSteps; };
    const double x = steps(), y = steps(), z = steps();
    return {x, y, z};
}

/// A crater of random shape, turned at random.
struct Blast {
    Cutter cutter;
    Pose pose;
};
Blast blast(scenes::Rng& rng, double reach, double size) {
    Blast made;
    made.cutter = make_crater(CutterShape(rng.below(5)), rng.next());
    made.pose.rotation = random_turn(rng.next());
    made.pose.position = grid_point(rng, reach);
    made.pose.scale = size * rng.uniform(0.5, 1);
    return made;
}

/// A cutter as it is once placed: at any quarter turn its vertices stay where they are on the grid.
Cutter placed_mesh(const Blast& blast) {
    const PlacedCutter placed = place_cutter(blast.cutter, blast.pose).value();
    std::vector<Vec3> vertices;
    for (const InputPoint& p : placed.vertices) vertices.push_back(to_metres(to_surface(p)));
    return make_cutter(vertices, placed.triangles).value();
}

/// A block of 4 m with bites taken out of it.
Solid bitten_block(scenes::Rng& rng, int bites) {
    Solid solid = make_solid(box_level({-2, -2, -2}, {2, 2, 2})).value();
    for (int k = 0; k < bites; ++k) {
        const Blast at = blast(rng, 2.5, 1);
        const SolidResult result = subtract(solid, at.cutter, at.pose);
        if (result.done()) solid = result.solid;
    }
    return solid;
}

TEST(SolidCutters, EveryQuarterTurnIsRecognised) {
    for (std::size_t k = 0; k < 24; ++k) {
        Pose pose;
        pose.rotation = kTurns[k];
        const auto turn = grid_turn(pose);
        ASSERT_TRUE(turn) << k;
        for (std::size_t j = 0; j < k; ++j) {
            pose.rotation = kTurns[j];
            const auto other = grid_turn(pose);
            EXPECT_FALSE(std::equal(turn->from, turn->from + 3, other->from) &&
                         std::equal(turn->sign, turn->sign + 3, other->sign))
                << "the same turn twice";
        }
        for (double& part : pose.rotation) part = double(float(kTurns[k][std::size_t(&part - &pose.rotation[0])]));
        EXPECT_TRUE(grid_turn(pose)) << "as floats";
    }
    Pose pose;
    pose.rotation = {0, 0, 1e-6, 1};
    EXPECT_FALSE(grid_turn(pose));
    pose = {};
    pose.scale = 1 + 1e-15;
    EXPECT_FALSE(grid_turn(pose));
    pose = {};
    pose.position = {1 / kInputSteps * 0.5, 1 / kInputSteps * 1.5, -1 / kInputSteps * 0.75};
    EXPECT_EQ(grid_turn(pose)->move, (InputPoint{0, 2, -1})) << "halves to even";
    pose.position.x = 1e300;
    EXPECT_FALSE(grid_turn(pose));
}

TEST(SolidCutters, CutAsTheMeshThatTheyAreMadeOf) {
    scenes::Rng rng(1);
    int cuts = 0;
    for (int round = 0; round < sample(60); ++round) {
        const Solid target = bitten_block(rng, 2);
        Pose snapped = pose_at(0, 0, 0);
        Blast at = blast(rng, 0, 1);
        at.pose.position = {};
        const Solid crater = solid_of(at.cutter, at.pose);
        const Cutter mesh = placed_mesh(at);
        snapped.rotation = kTurns[round % 24];
        snapped.position = grid_point(rng, 2.5);
        for (const bool fills : {false, true}) {
            const auto cut = fills ? unite : subtract;
            const SolidResult by_mesh = cut(target, mesh, snapped, {}),
                              by_solid = cut(target, cutter_of(crater), snapped, {});
            ASSERT_EQ(by_mesh.status, by_solid.status) << by_solid.error.text();
            if (!by_mesh.done()) continue;
            ++cuts;
            EXPECT_TRUE(same_solid(by_mesh.solid, done(by_solid)));
            EXPECT_NEAR(by_mesh.report.volume, by_solid.report.volume, 1e-9 * std::abs(by_mesh.report.volume));
        }
    }
    EXPECT_GT(cuts, sample(60));
}

TEST(SolidCutters, WhatACutTookIsTakenOutAndPutBack) {
    scenes::Rng rng(2);
    int chunks = 0;
    for (int round = 0; round < sample(60); ++round) {
        const Solid whole = bitten_block(rng, 3);
        const Blast at = blast(rng, 2, 1.5);
        const SolidResult cut = subtract(whole, at.cutter, at.pose);
        if (!cut.done()) continue;
        ++chunks;
        const Solid chunk = done(subtract(whole, cutter_of(cut.solid), {}));
        EXPECT_NEAR(measure_solid(chunk).volume, cut.report.volume, 1e-9);
        EXPECT_TRUE(same_solid(done(subtract(whole, cutter_of(chunk), {})), cut.solid));
        EXPECT_TRUE(same_solid(done(unite(cut.solid, cutter_of(chunk), {})), whole));
        EXPECT_EQ(subtract(cut.solid, cutter_of(chunk), {}).status, CarveStatus::kNothing);
        EXPECT_EQ(unite(whole, cutter_of(chunk), {}).status, CarveStatus::kNothing);
        EXPECT_EQ(done(subtract(chunk, cutter_of(chunk), {})).face_count(), 0u);
        EXPECT_EQ(done(subtract(chunk, cutter_of(whole), {})).face_count(), 0u);
    }
    EXPECT_GT(chunks, sample(30));
}

TEST(SolidCutters, TurnAndMoveExactly) {
    scenes::Rng rng(3);
    int chunks = 0;
    for (int round = 0; round < sample(48); ++round) {
        // What a block and a crater have in common, turned as one and turned apart.
        const Blast at = blast(rng, 1.5, 1.5);
        const Cutter crater = placed_mesh(at);
        const Cutter block = make_crater(CutterShape::kBox, 0);
        const auto in_common = [&](const Pose& pose) {
            const Solid all = solid_of(block, pose);
            const SolidResult rest = subtract(all, crater, pose);
            return rest.status == CarveStatus::kNothing ? Solid() : done(subtract(all, cutter_of(done(rest)), {}));
        };
        const Solid chunk = in_common({});
        if (chunk.face_count() == 0) continue;
        ++chunks;
        Pose pose;
        pose.rotation = kTurns[round % 24];
        pose.position = grid_point(rng, 100);
        EXPECT_TRUE(same_solid(solid_of(cutter_of(chunk), pose), in_common(pose)));
    }
    EXPECT_GT(chunks, sample(24));
}

TEST(SolidCutters, ReachTheRimAndNoFarther) {
    scenes::Rng rng(4);
    const Solid block = bitten_block(rng, 6);
    const Cutter cutter = cutter_of(block);
    int cuts = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true})
            for (const Quaternion& turn : {kTurns[0], kTurns[1], kTurns[17]}) {
                Pose pose;
                pose.rotation = turn;
                const Box turned = solid_of(cutter, pose).bounds();
                const double last = upper ? kWorldRim - 1 / kInputSteps : -kWorldRim;
                const double reach = upper ? turned.high[axis] : turned.low[axis];
                pose.position[axis] =
                    last - (upper ? std::ceil(reach * kInputSteps) : std::floor(reach * kInputSteps)) / kInputSteps;
                for (int other = 0; other < 3; ++other)
                    if (other != axis) pose.position[other] = 8000;
                const Solid placed = solid_of(cutter, pose);
                EXPECT_NEAR(measure_solid(placed).volume, measure_solid(block).volume, 1e-6);
                // Off-grid points at the rim are cut and put back.
                const Blast at = blast(rng, 1, 1);
                Pose blast_pose = at.pose;
                blast_pose.position = pose.position;
                blast_pose.position[axis] += upper ? -1 : 1;
                const SolidResult cut = subtract(placed, at.cutter, blast_pose);
                if (cut.done()) {
                    ++cuts;
                    EXPECT_FALSE(check_solid(cut.solid));
                    const Solid chunk = done(subtract(placed, cutter_of(cut.solid), {}));
                    EXPECT_TRUE(same_solid(done(unite(cut.solid, cutter_of(chunk), {})), placed));
                }
                pose.position[axis] += (upper ? 2 : -2) / kInputSteps;
                const SolidResult beyond = unite(Solid(), cutter, pose);
                ASSERT_EQ(beyond.status, CarveStatus::kRefused);
                EXPECT_EQ(beyond.error.code, ErrorCode::kOutOfRange);
            }
    EXPECT_GT(cuts, 9);
}

TEST(SolidCutters, AtAnyOtherPoseAreWhatTheirFacetsBound) {
    scenes::Rng rng(5);
    int placed = 0, refused = 0;
    for (int round = 0; round < sample(60); ++round) {
        const Solid whole = bitten_block(rng, 3);
        Pose pose;
        pose.rotation = random_turn(rng.next());
        pose.position = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
        pose.scale = rng.uniform(0.5, 1.5);
        const SolidResult result = unite(Solid(), cutter_of(whole), pose);
        if (!result.done()) {
            ++refused;
            EXPECT_NE(result.error.reason.find("near "), std::string::npos) << result.error.text();
            continue;
        }
        ++placed;
        EXPECT_FALSE(check_solid(result.solid));
        const double expected = measure_solid(whole).volume * pose.scale * pose.scale * pose.scale;
        // Each corner moves by up to half a step an axis, over the whole surface.
        EXPECT_NEAR(measure_solid(result.solid).volume, expected, measure_solid(result.solid).area / kInputSteps);
        EXPECT_NEAR(result.report.volume, -measure_solid(result.solid).volume, 1e-9);
    }
    EXPECT_GT(placed, refused);
    RecordProperty("refused", refused);
    // Walls nearer than the grid's steps fall together.
    Pose tiny;
    tiny.scale = 1e-5;
    const SolidResult none = unite(Solid(), cutter_of(bitten_block(rng, 1)), tiny);
    ASSERT_EQ(none.status, CarveStatus::kRefused);
    EXPECT_EQ(none.error.code, ErrorCode::kInvalid);
    EXPECT_NE(none.error.text().find("encloses no volume"), std::string::npos) << none.error.text();
}

TEST(SolidCutters, TouchingThemselvesAlongAnEdge) {
    Level level = box_level({0, 0, 0}, {1, 1, 1});
    add_box(level, {1, 1, 0}, {2, 2, 1});
    const Solid two = make_solid(level).value();
    ASSERT_EQ(two.face_count(), 12u);
    const Solid block = make_solid(box_level({-1, -1, 0}, {3, 3, 1})).value();
    for (const Quaternion& turn : kTurns) {
        Pose pose;
        pose.rotation = turn;
        const Solid target = solid_of(cutter_of(block), pose);
        const Solid cut = done(subtract(target, cutter_of(two), pose));
        EXPECT_DOUBLE_EQ(measure_solid(cut).volume, 14);
        EXPECT_TRUE(same_solid(done(unite(cut, cutter_of(two), pose)), target));
    }
}

TEST(SolidCutters, CutWorldsAsAnyCutterDoes) {
    scenes::Rng rng(6);
    const Level level = box_level({-4, -4, -4}, {4, 4, 4}, true);
    const World world = make_world(level).value();
    const Solid chunk = bitten_block(rng, 3);
    Pose pose = pose_at(4, 0, 1);
    pose.rotation = kTurns[5];
    const CarveResult at_once = carve(world, cutter_of(chunk), pose);
    ASSERT_EQ(at_once.status, CarveStatus::kDone) << at_once.error.text();
    expect_sound_world(at_once.world);
    CarveJob job(world, cutter_of(chunk), pose);
    while (!job.run(1)) {
    }
    EXPECT_EQ(hash_world(job.result().world), hash_world(at_once.world));
    EXPECT_EQ(carve(at_once.world, cutter_of(chunk), pose).status, CarveStatus::kNothing);
    // What it took, and what of it lies in the room's air.
    const CarveResult filled = fill(at_once.world, cutter_of(chunk), pose);
    ASSERT_EQ(filled.status, CarveStatus::kDone) << filled.error.text();
    EXPECT_TRUE(same_solid(filled.world, fill(world, cutter_of(chunk), pose).world));

    CarveRules rules;
    rules.zones.push_back({"vault", {{5, -1, 0}, {6, 1, 2}}, 1});
    const World guarded = make_world(level, {{}, {}, rules}).value();
    const CarveResult cut_short = carve(guarded, cutter_of(chunk), pose);
    ASSERT_EQ(cut_short.status, CarveStatus::kDone) << cut_short.error.text();
    EXPECT_EQ(cut_short.report.cut_short, 1u);
    EXPECT_LT(cut_short.report.volume, at_once.report.volume);
    expect_sound_world(cut_short.world);
    rules.zones[0] = {"vault", {{-9, -9, -9}, {9, 9, 9}}, 0.5};  // the cutter's middle lies in it
    const CarveResult smaller = carve(make_world(level, {{}, {}, rules}).value(), cutter_of(chunk), pose);
    ASSERT_EQ(smaller.status, CarveStatus::kDone) << smaller.error.text();
    EXPECT_EQ(smaller.report.scale, 0.5);
    expect_sound_world(smaller.world);
}

TEST(SolidCutters, AreRefusedWhereTheyBoundNothing) {
    const Result<Cutter> none = cutter_from_solid(Solid(), "void");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().text(), "void: nothing of it is solid");
    const Result<Cutter> rock = cutter_from_solid(make_solid(box_level({0, 0, 0}, {1, 1, 1}, true)).value());
    ASSERT_FALSE(rock);
    EXPECT_EQ(rock.error().text(), "its rock reaches to infinity");
    const Cutter cutter = cutter_of(make_solid(box_level({0, 0, 0}, {1, 1, 1})).value());
    EXPECT_EQ(cutter.vertices().size(), 8u);
    EXPECT_EQ(cutter.triangles().size(), 12u);
    Pose pose;
    pose.rotation = {0, 0, 0, 0};
    EXPECT_EQ(unite(Solid(), cutter, pose).error.text(), "chunk: the rotation is zero or not finite");
    pose = pose_at(8191.5, 0, 0);
    EXPECT_NE(unite(Solid(), cutter, pose).error.text().find("lies outside the world"), std::string::npos);
}

}  // namespace
}  // namespace firma

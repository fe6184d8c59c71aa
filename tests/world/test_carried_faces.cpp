// SPDX-License-Identifier: MIT
// What is castable only and goes with pieces that come loose, and what a shot takes that is cut short before the solid.
#include <gtest/gtest.h>

#include <string>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/queries.h"
#include "firma/save.h"
#include "firma/versions.h"
#include "firma/world_patch.h"
#include "tests/carve/cutters.h"
#include "tests/solid/solid_levels.h"
#include "tests/world/matter_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

using map_text::box;
using test::box_mesh;
using test::brush_world;
using test::pose_at;

/// Of castable-only faces with a material: square metres.
double area_of(const World& world, const std::string& material) {
    double area = 0;
    for (const Face& face : world.faces()) {
        if (face.solid || world.material_name(face.material) != material) continue;
        Vec3 sum;
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            sum = sum + cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0]);
        area += length(sum) / 2;
    }
    return area;
}

std::size_t open_count(const World& world) {
    return world.face_count() - world.solid().face_count();
}

/// A floor, a post, a beam of 8 m that it alone holds, and something besides.
World world_with_beam(const std::string& more) {
    AnchorRules rules;
    rules.hanging = false;
    rules.materials = {"floor"};
    return with_anchors(
        brush_world(box({-20, -20, -2}, {20, 20, 0}, "floor") + box({-4, -0.5, 0}, {-3.5, 0.5, 3}, "post") +
                    box({-4, -0.5, 3}, {4, 0.5, 3.5}, "beam") + more),
        rules);
}

/// Cuts a box away, so that one piece leaves: what holds of any such edit.
CarveResult drop(const World& world, const Vec3& low, const Vec3& high, double volume) {
    const Cutter cutter = box_mesh(low, high).cutter().value();
    CarveOptions options;
    options.chunks = ChunkOptions{};
    const CarveResult result = carve(world, cutter, {}, options);
    EXPECT_TRUE(result.done()) << result.error.text();
    EXPECT_EQ(result.chunks.size(), 1u);
    EXPECT_NEAR(result.report.chunk_volume, volume, 1e-9);

    EXPECT_FALSE(check_world(result.world));
    const std::uint64_t hash = hash_world(result.world);
    CarveJob job(world, cutter, {}, options);
    while (!job.run(0)) {
    }
    EXPECT_EQ(hash_world(job.result().world), hash);
    EXPECT_EQ(hash_world(unpack_world(pack_world(result.world), "it").value()), hash);
    EXPECT_EQ(hash_world(apply_patch(world, make_patch(world, result.world), "it").value()), hash);
    EXPECT_EQ(hash_world(carve(rebuild_index(world, {}), cutter, {}, options).world), hash);
    const WorldDiff diff = diff_worlds(world, result.world);
    EXPECT_EQ(diff.removed.size(), result.report.faces_removed);
    EXPECT_EQ(diff.added.size(), result.report.faces_added);
    // Those that are not as they were.
    std::size_t gone = open_count(world);
    for (const Face& face : result.world.faces()) gone -= !face.solid && face.id.value < world.data().next_face();
    EXPECT_EQ(result.report.open_removed + result.report.open_trimmed, gone);
    return result;
}

/// Cuts the post through, and the beam from it: the beam from x = -3 on leaves.
CarveResult drop_beam(const World& world) {
    return drop(world, {-4.5, -1, 2}, {-3, 1, 4}, 3.5);
}

TEST(CarriedFaces, WhatStandsOnAPieceAloneGoesWithIt) {
    // A clip flush on the beam, a pane that stands on it, a clip around it that does not touch its sides.
    const World world =
        world_with_beam(box({-2, -0.5, 3.5}, {3, 0.5, 3.75}, "clip") + box({0, -0.125, 3.5}, {2, 0.125, 5}, "glass") +
                        box({-1, -0.75, 2.75}, {1, 0.75, 3.75}, "weapclip"));
    EXPECT_TRUE(cast(world, Ray{{2.5, 0.25, 10}, {0, 0, -20}}).fraction < 0.4);
    const CarveResult result = drop_beam(world);
    EXPECT_EQ(open_count(result.world), 0u);
    EXPECT_EQ(result.report.open_removed, open_count(world));
    EXPECT_EQ(result.report.open_trimmed, 0u);
    EXPECT_EQ(result.report.panes, 1u);
    EXPECT_GT(result.report.clips, 8u);
    for (const double x : {-1.5, 0.5, 2.5})
        EXPECT_EQ(cast(result.world, Ray{{x, 0.25, 10}, {0, 0, -20}}).fraction, 0.5) << x;
}

TEST(CarriedFaces, WhatSomethingElseHoldsStays) {
    // A grating: what is below the beam stands on the floor, what is above it on the beam. A clip between the beam and
    // a wall, another that does not touch it. A pool around it.
    const World world =
        world_with_beam(box({1, -0.25, 0}, {2, 0.25, 6}, "{grate") + box({6, -3, 0}, {7, 3, 6}, "wall") +
                        box({3, -0.25, 3.25}, {6, 0.25, 4}, "clip") + box({-2, -0.5, 3.75}, {0, 0.5, 4}, "weapclip") +
                        box({0, -1, 3}, {1, 1, 4}, "*water"));
    const CarveResult result = drop_beam(world);
    EXPECT_EQ(area_of(result.world, "{grate"), 2 * 3 * (1 + 0.5));
    EXPECT_EQ(area_of(world, "{grate"), 2 * 5.5 * (1 + 0.5) + 0.5);
    for (const char* const stays : {"clip", "weapclip", "*water"}) {
        EXPECT_GT(area_of(world, stays), 0);
        EXPECT_EQ(area_of(result.world, stays), area_of(world, stays)) << stays;
    }
    EXPECT_EQ(result.report.clips, 0u);
    EXPECT_EQ(result.report.open_removed, 5u);
}

TEST(CarriedFaces, ACraterAndAPieceTakeOfOneFace) {
    // As a mesh, where sheets lie within solid, too. The beam is held by its side at x = -4 alone.
    Level level = test::empty_level();
    level.materials = {"", "through", "lying", "along", "down", "standing", "floor"};
    test::add_box(level, {-20, -20, -2}, {20, 20, 0});
    test::add_box(level, {-4, -0.5, 1}, {4, 0.5, 2});
    const auto sheet = [&](std::uint32_t material, const std::vector<Vec3>& corners) {
        test::add_polygon(level, corners);
        level.faces.back().material = material;
    };
    sheet(1, {{-6, -1, 1.5}, {6, -1, 1.5}, {6, 1, 1.5}, {-6, 1, 1.5}});
    sheet(2, {{0, -0.25, 2}, {1, -0.25, 2}, {1, 0.25, 2}, {0, 0.25, 2}});
    sheet(3, {{-3.75, -0.25, 2}, {-2, -0.25, 2}, {-2, 0.25, 2}, {-3.75, 0.25, 2}});
    sheet(4, {{-3.75, 0.375, 2}, {-3.75, 0.5, 2}, {-2, 0.5, 2}, {-2, 0.375, 2}});
    sheet(5, {{1, 0, 2}, {2, 0, 2}, {2, 0, 3}, {1, 0, 3}});
    sheet(6, {{-1, 0, 0}, {0, 0, 0}, {0, 0, 3}, {-1, 0, 3}});
    const World world = with_anchors(make_world(level).value(), {.hanging = false, .sources = {6}});
    ASSERT_EQ(open_count(world), 6u);
    const CarveResult result = drop(world, {-3.5, -0.75, 0.5}, {-3, 0.75, 2.5}, 7);
    EXPECT_EQ(area_of(result.world, "through"), 24 - 0.5 * 1.5 - 7 * 1);
    EXPECT_EQ(area_of(result.world, "lying"), 0) << "on it, and on nothing else";
    EXPECT_EQ(area_of(result.world, "along"), 0.25 * 0.5) << "on what stays, too";
    EXPECT_EQ(area_of(result.world, "down"), 1.25 * 0.125) << "looks at it: it bounds nothing of the piece";
    EXPECT_EQ(area_of(result.world, "standing"), 0);
    EXPECT_EQ(area_of(result.world, "floor"), 2);
    EXPECT_EQ(result.report.open_removed, 2u);
    EXPECT_EQ(result.report.open_trimmed, 4u);
}

TEST(CarriedFaces, RulesKeepThem) {
    const World world = world_with_beam(box({-2, -0.5, 3.5}, {3, 0.5, 3.75}, "clip"));
    CarveRules rules;
    rules.open_faces = false;
    const CarveResult result = drop_beam(with_rules(world, rules).value());
    EXPECT_EQ(open_count(result.world), open_count(world));
}

/// A window of glass in a wall that may not be carved.
World vault() {
    WorldOptions options;
    options.matters = default_matters();
    Matter hard;
    hard.name = "vault";
    hard.hardness = 1;
    options.matters->matters.push_back(hard);
    options.matters->patterns.insert(options.matters->patterns.begin(),
                                     {"vault", std::uint32_t(options.matters->matters.size() - 1)});
    return brush_world(box({0, 0, 0}, {4, 1, 6}, "vault") + box({6, 0, 0}, {10, 1, 6}, "vault") +
                           box({4, 0, 0}, {6, 1, 2}, "vault") + box({4, 0, 4}, {6, 1, 6}, "vault") +
                           box({4, 0.375, 2}, {6, 0.625, 4}, "glass"),
                       options);
}

TEST(OpenFacesAlone, AShotCutShortTakesThem) {
    const World world = vault();
    const Cutter rock = make_crater(CutterShape::kRocky, 1);
    const Pose pose = pose_at(5, 0.5, 3, 1.6);
    const CarveResult shot = carve(world, rock, pose);
    ASSERT_TRUE(shot.done()) << shot.error.text();
    EXPECT_EQ(shot.error.text(), Error{}.text());
    EXPECT_GT(shot.report.cut_short, 0u);
    EXPECT_EQ(shot.report.panes, 2u) << "a side each: the wall covers the others";
    EXPECT_EQ(shot.report.volume, 0);
    EXPECT_EQ(open_count(shot.world), 0u);
    EXPECT_FALSE(check_world(shot.world));
    EXPECT_TRUE(same_solid(shot.world.solid(), world.solid()));
    EXPECT_EQ(shot.world.solid().edits(), 1u);

    // Once it is gone there is nothing else.
    const CarveResult again = carve(shot.world, rock, pose);
    EXPECT_EQ(again.status, CarveStatus::kRefused);
    EXPECT_EQ(again.error.reason, "matter vault may not be carved");
    EXPECT_EQ(hash_world(again.world), hash_world(shot.world));

    // A fill takes none, and where open faces stay the shot is refused.
    CarveRules rules;
    rules.open_faces = false;
    const CarveResult kept = carve(with_rules(world, rules).value(), rock, pose);
    EXPECT_EQ(kept.status, CarveStatus::kRefused);
    EXPECT_EQ(kept.error.reason, "matter vault may not be carved");
}

TEST(OpenFacesAlone, WhatLiesInAProtectedPieceStays) {
    // A sheet of wire from the air into a wall of hardness 1: what is in the wall is not the cutter's.
    WorldOptions options;
    options.matters = default_matters();
    options.matters->matters[*matter_named(*options.matters, "steel")].hardness = 1;
    const World world =
        brush_world(box({0, 0, 0}, {4, 4, 4}, "steel") + box({3, 1, 1}, {5, 1.25, 1.25}, "{grate"), options);
    const Cutter cutter = box_mesh({3.5, 0.5, 0.5}, {4.5, 2, 2}).cutter().value();
    const CarveResult shot = carve(world, cutter, {});
    ASSERT_TRUE(shot.done()) << shot.error.text();
    EXPECT_FALSE(check_world(shot.world));
    EXPECT_NEAR(area_of(shot.world, "{grate"), area_of(world, "{grate") - 0.5 * 4 * 0.25, 1e-9);
    EXPECT_EQ(shot.report.volume, 0);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Clips that stand on a wall: where a cut takes the wall from under them, what stands straight over the hole goes, and
// nothing else; judged by rays through the hole and beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/save.h"
#include "firma/versions.h"
#include "firma/world_patch.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/carve/winding.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"
#include "tests/world/matter_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

using map_text::box;
using test::box_mesh;
using test::brush_world;
using test::pose_at;

/// 10 m wide, 1 m thick from y = 0 to 1.
std::string wall() {
    return box({0, 0, 0}, {10, 1, 4}, "stone");
}
/// Flush on the wall's face at y = 0.
std::string slab() {
    return box({2, -0.25, 0.5}, {8, 0, 3.5}, "clip");
}

/// What holds of any edit.
CarveResult cut(const World& before, const Cutter& cutter, const Pose& pose = {}) {
    CarveResult result = carve(before, cutter, pose);
    EXPECT_TRUE(result.done()) << result.error.text();
    const auto fault = check_world(result.world);
    EXPECT_FALSE(fault) << fault->what;
    const std::uint64_t hash = hash_world(result.world);
    CarveJob job(before, cutter, pose);
    while (!job.run(0)) {
    }
    EXPECT_EQ(hash_world(job.result().world), hash);
    EXPECT_EQ(hash_world(unpack_world(pack_world(result.world), "it").value()), hash);
    EXPECT_EQ(hash_world(apply_patch(before, make_patch(before, result.world), "it").value()), hash);
    EXPECT_EQ(hash_world(carve(rebuild_index(before, {}), cutter, pose).world), hash);
    EXPECT_EQ(carve(result.world, cutter, pose).status, CarveStatus::kNothing);
    return result;
}

/// Whether a walker's ray along y, from 3 m in front of the wall to 3 m behind it, meets nothing.
bool is_open(const World& world, double x, double z) {
    return !cast(world, Ray{{x, -3, z}, {0, 7, 0}}, {.mask = kStopsWalk}).touched();
}

/// Where such a ray ends.
double stops_at(const World& world, double x, double z) {
    const Hit hit = cast(world, Ray{{x, -3, z}, {0, 7, 0}}, {.mask = kStopsWalk});
    return hit.touched() ? -3 + 7 * hit.fraction : INFINITY;
}

/// A hole of 1 m through the wall, open for walkers, and the clip beside it as it was, to a millimetre.
void expect_hole(const World& world, double front = -0.25) {
    for (const double x : {4.002, 4.5, 4.998})
        for (const double z : {1.002, 1.5, 1.998}) EXPECT_TRUE(is_open(world, x, z)) << x << ' ' << z;
    for (const double x : {3.999, 5.001}) EXPECT_NEAR(stops_at(world, x, 1.5), front, 0.01) << x;
    for (const double z : {0.999, 2.001}) EXPECT_NEAR(stops_at(world, 4.5, z), front, 0.01) << z;
    EXPECT_FALSE(cast(world, Sphere{{4.5, -3, 1.5}, 0.45}, {0, 7, 0}, {.mask = kStopsWalk}).touched());
}

TEST(ClipsOnWalls, AHoleThroughTheWallOpensASlabOnIt) {
    const World world = brush_world(wall() + slab());
    ASSERT_NEAR(stops_at(world, 4.5, 1.5), -0.25, 0.01);
    // Flush with the wall, 5 cm into the clip, 1 mm short of the other side of it, through all.
    for (const double front : {0.0, -0.05, -0.249, -0.5}) {
        SCOPED_TRACE(front);
        const CarveResult result = cut(world, box_mesh({4, front, 1}, {5, 1.5, 2}).cutter().value());
        EXPECT_EQ(result.report.clips, 1u);
        EXPECT_EQ(result.report.open_trimmed, 1u);
        EXPECT_EQ(result.report.volume, 1);
        expect_hole(result.world);
    }
}

TEST(ClipsOnWalls, NoHoleNoChange) {
    const World world = brush_world(wall() + slab());
    // From the other side, not through; and in the clip alone, short of both its sides.
    const CarveResult behind = cut(world, box_mesh({4, 0.5, 1}, {5, 1.5, 2}).cutter().value());
    EXPECT_EQ(behind.report.clips, 0u);
    EXPECT_EQ(carve(world, box_mesh({4, -0.2, 1}, {5, 0, 2}).cutter().value(), {}).status, CarveStatus::kNothing);
    // A dent in the wall under the clip.
    const CarveResult dent = cut(world, box_mesh({4, 0, 1}, {5, 0.5, 2}).cutter().value());
    EXPECT_EQ(dent.report.clips, 1u);
    EXPECT_NEAR(stops_at(dent.world, 4.5, 1.5), 0.5, 0.01);
    // The rule is off.
    CarveRules rules;
    rules.open_faces = false;
    const CarveResult kept = cut(with_rules(world, rules).value(), box_mesh({4, 0, 1}, {5, 1.5, 2}).cutter().value());
    EXPECT_EQ(kept.report.clips, 0u);
    EXPECT_NEAR(stops_at(kept.world, 4.5, 1.5), -0.25, 0.01);
}

TEST(ClipsOnWalls, ClipsOnBothSides) {
    const World world = brush_world(wall() + slab() + box({2, 1, 0.5}, {8, 1.5, 3.5}, "weapclip") +
                                    box({2, 1.5, 0.5}, {8, 1.75, 3.5}, "stone"));
    const CarveResult result = cut(world, box_mesh({4, 0, 1}, {5, 1, 2}).cutter().value());
    EXPECT_EQ(result.report.clips, 1u) << "the one behind is closed by stone: no side of it stands over the hole";
    const World both = brush_world(wall() + slab() + box({2, 1, 0.5}, {8, 1.5, 3.5}, "clip"));
    const CarveResult through = cut(both, box_mesh({4, 0, 1}, {5, 1, 2}).cutter().value());
    EXPECT_EQ(through.report.clips, 2u);
    expect_hole(through.world);
    for (const double x : {3.999, 5.001}) {
        const Hit back = cast(through.world, Ray{{x, 4, 1.5}, {0, -7, 0}}, {.mask = kStopsWalk});
        ASSERT_TRUE(back.touched());
        EXPECT_NEAR(4 - 7 * back.fraction, 1.5, 0.01);
    }
    EXPECT_FALSE(cast(through.world, Ray{{4.5, 4, 1.5}, {0, -7, 0}}, {.mask = kStopsWalk}).touched());
}

TEST(ClipsOnWalls, AClipPartlyOverTheHoleLosesThatPart) {
    // Ends at x = 4.5, in the middle of the hole: its narrow side there goes as far as it stands over the hole.
    const World world = brush_world(wall() + box({2, -0.25, 0.5}, {4.5, 0, 3.5}, "clip"));
    const CarveResult result = cut(world, box_mesh({4, 0, 1}, {5, 1.5, 2}).cutter().value());
    EXPECT_EQ(result.report.clips, 2u);
    EXPECT_EQ(result.report.open_trimmed, 2u);
    for (const double x : {4.002, 4.499, 4.501, 4.998}) EXPECT_TRUE(is_open(result.world, x, 1.5)) << x;
    EXPECT_NEAR(stops_at(result.world, 3.999, 1.5), -0.25, 0.01);
    EXPECT_NEAR(stops_at(result.world, 5.001, 1.5), 0, 0.01);
    const auto side = [&](double z) {
        return cast(result.world, Ray{{4.8, -0.1, z}, {-0.7, 0, 0}}, {.mask = kStopsWalk}).touched();
    };
    EXPECT_FALSE(side(1.5));
    EXPECT_TRUE(side(0.999));
    EXPECT_TRUE(side(2.001));
    // Within the hole: all of it goes.
    const World small = brush_world(wall() + box({4.25, -0.25, 1.25}, {4.75, 0, 1.75}, "clip"));
    const CarveResult whole = cut(small, box_mesh({4, 0, 1}, {5, 1.5, 2}).cutter().value());
    EXPECT_EQ(whole.report.clips, 5u);
    EXPECT_EQ(whole.report.open_removed, 5u);
    EXPECT_EQ(whole.world.face_count(), whole.world.solid().face_count());
}

TEST(ClipsOnWalls, WhatDoesNotStandOnTheWallStays) {
    const Cutter hole = box_mesh({4, 0, 1}, {5, 1, 2}).cutter().value();
    const auto clips_of = [&](const std::string& more) { return cut(brush_world(wall() + more), hole).report.clips; };
    EXPECT_EQ(clips_of(box({2, -0.5, 0.5}, {8, -0.25, 3.5}, "clip")), 0u) << "floats in front of it";
    EXPECT_EQ(clips_of(box({2, -2, 0}, {8, -1, 4}, "stone") + box({2, -1, 0.5}, {8, -0.5, 3.5}, "clip")), 0u)
        << "stands on a wall across";
    EXPECT_EQ(clips_of(box({5.5, -0.25, 0.5}, {8, 0, 3.5}, "clip")), 0u) << "stands beside the hole";
    EXPECT_EQ(clips_of(box({12, 0, 0}, {20, 1, 4}, "stone") + box({12, -0.25, 0.5}, {20, 0, 3.5}, "clip")), 0u)
        << "stands on another wall in the same plane";
    EXPECT_EQ(clips_of(box({2, -0.25, 0.5}, {8, 0, 3.5}, "*water")), 0u);
    // On a slab that is gone over the hole stands another clip, smaller: it stays.
    const CarveResult stacked =
        cut(brush_world(wall() + slab() + box({4.2, -0.5, 1.2}, {4.8, -0.25, 1.8}, "clip")), hole);
    EXPECT_NEAR(stops_at(stacked.world, 4.5, 1.5), -0.5, 0.01);
    EXPECT_TRUE(is_open(stacked.world, 4.1, 1.5));
    // A zone that may not be carved keeps the faces that reach into it.
    CarveRules rules;
    rules.zones.push_back({.name = "front", .box = {{0, -1, 0}, {10, -0.1, 4}}, .hardness = 1});
    const CarveResult kept = cut(with_rules(brush_world(wall() + slab()), rules).value(), hole);
    EXPECT_EQ(kept.report.clips, 0u);
    EXPECT_NEAR(stops_at(kept.world, 4.5, 1.5), -0.25, 0.01);
}

/// A wedge and a pyramid, one after the other: what stands straight over the hole goes, whatever way its faces lean.
TEST(ClipsOnWalls, AnyConvexClip) {
    using map_text::plane_brush;
    using map_text::PlaneText;
    const double s = std::sqrt(0.5);
    const std::vector<PlaneText> wedge{
        {{-1, 0, 0}, -2}, {{1, 0, 0}, 8}, {{0, 1, 0}, 0}, {{0, 0, 1}, 3.5}, {{0, -s, -s}, -s}};
    const std::vector<PlaneText> pyramid{
        {{0, 1, 0}, 0}, {{s, -s, 0}, 8 * s}, {{-s, -s, 0}, -2 * s}, {{0, -s, s}, 4 * s}, {{0, -s, -s}, 0}};
    for (const auto& planes : {wedge, pyramid}) {
        const Result<BrushLevel> level =
            read_map(map_text::world(wall() + plane_brush(planes, "clip")), "test.map", {.scale = 1});
        ASSERT_TRUE(level.ok()) << level.error().text();
        const World world = make_world(level.value()).value();
        ASSERT_LT(stops_at(world, 4.5, 1.5), -0.3);
        const CarveResult result = cut(world, box_mesh({4, 0, 1}, {5, 1, 2}).cutter().value());
        EXPECT_GT(result.report.clips, 0u);
        for (const double x : {4.002, 4.5, 4.998}) EXPECT_TRUE(is_open(result.world, x, 1.5)) << x;
        for (const double x : {3.998, 5.002})
            EXPECT_NEAR(stops_at(result.world, x, 1.5), stops_at(world, x, 1.5), 1e-4) << x;
        for (const double z : {0.998, 2.002})
            EXPECT_NEAR(stops_at(result.world, 4.5, z), stops_at(world, 4.5, z), 1e-4) << z;
    }
}

/// Many craters, over each other too: a ray along y is stopped by the clip where it is by the wall's plane, and
/// nowhere else.
TEST(ClipsOnWalls, CratersAgreeWithSamples) {
    scenes::Rng rng(7);
    std::size_t in = 0, out = 0, clips = 0;
    for (int round = 0; round < test::sample(6); ++round) {
        World world = brush_world(wall() + slab());
        std::vector<test::PlacedWinding> craters;
        for (int k = 0; k < 8; ++k) {
            const Cutter rock =
                make_crater(k % 2 ? CutterShape::kSpiky : CutterShape::kRocky, std::uint64_t(10 * round + k));
            Pose pose =
                pose_at(rng.uniform(2.5, 7.5), rng.uniform(-0.1, 0.4), rng.uniform(1, 3), rng.uniform(0.2, 0.7));
            pose.rotation = random_turn(std::uint64_t(100 * round + k));
            const CarveResult result = carve(world, rock, pose);
            ASSERT_TRUE(result.done()) << result.error.text();
            clips += result.report.clips;
            EXPECT_EQ(carve(result.world, rock, pose).status, CarveStatus::kNothing);
            world = result.world;
            craters.emplace_back(rock, pose);
        }
        const auto fault = check_world(world);
        ASSERT_FALSE(fault) << fault->what;
        for (int k = 0; k < 100; ++k) {
            const double x = rng.uniform(2.05, 7.95), z = rng.uniform(0.55, 3.45);
            bool hole = false, clear = true, taken = false;
            for (const test::PlacedWinding& crater : craters) {
                for (const double y : {0.0, -0.25}) clear = clear && crater.is_clear({x, y, z}, 1e-3);
                if (!clear) break;
                hole = hole || crater.holds({x, 0, z});
                taken = taken || crater.holds({x, -0.25, z});
            }
            if (!clear) continue;
            (hole || taken ? in : out) += 1;
            const Hit hit = cast(world, Ray{{x, -3, z}, {0, 2.8, 0}}, {.mask = kStopsWalk});
            EXPECT_EQ(hit.touched(), !hole && !taken) << round << ' ' << x << ' ' << z;
        }
    }
    EXPECT_GT(clips, std::size_t(test::sample(6)) * 6);
    EXPECT_GT(in, std::size_t(test::sample(6)) * 10);
    EXPECT_GT(out, std::size_t(test::sample(6)) * 20);
}

/// A slanted wall of 1 m, in any of several directions, and a slab on it.
TEST(ClipsOnWalls, ASlantedWall) {
    using map_text::plane_brush;
    using map_text::PlaneText;
    for (const Vec3& way : {Vec3{3, -4, 0}, Vec3{1, -2, 0.5}, Vec3{-1, -1, -1}}) {
        const Vec3 n = way * (1 / length(way));
        Vec3 u = cross(Vec3{0, 0, 1}, n);
        u = u * (1 / length(u));
        const Vec3 v = cross(n, u);
        const auto slanted = [&](double from, double to, double reach, const std::string& texture) {
            const std::vector<PlaneText> planes{{n, to},         {n * -1, -from}, {u, reach},
                                                {u * -1, reach}, {v, reach},      {v * -1, reach}};
            return plane_brush(planes, texture);
        };
        const Result<BrushLevel> level = read_map(
            map_text::world(slanted(-1, 0, 5, "stone") + slanted(0, 0.5, 3, "clip")), "test.map", {.scale = 1});
        ASSERT_TRUE(level.ok()) << level.error().text();
        const World world = make_world(level.value()).value();
        const auto stops = [&](const World& at, double right, double up) {
            const Hit hit = cast(at, Ray{u * right + v * up + n * 2, n * -4}, {.mask = kStopsWalk});
            return hit.touched() ? 2 - 4 * hit.fraction : -INFINITY;
        };
        ASSERT_NEAR(stops(world, 0.1, 0.1), 0.5, 0.01);
        // A box through the wall, square to it: 1 m wide, from 2 cm in front of the wall.
        test::TriangleMesh mesh = box_mesh({-0.5, -0.5, -1.5}, {0.5, 0.5, 0.02});
        for (Vec3& p : mesh.vertices) p = u * p.x + v * p.y + n * p.z;
        const CarveResult result = cut(world, mesh.cutter().value());
        EXPECT_GE(result.report.clips, 1u) << "some slanted sides are two facets";
        EXPECT_LE(result.report.clips, 2u);
        for (const double at : {-0.49, 0.0, 0.1, 0.49}) {
            EXPECT_EQ(stops(result.world, at, 0.3), -INFINITY) << at;
            EXPECT_EQ(stops(result.world, -0.3, at), -INFINITY) << at;
        }
        for (const double at : {-0.505, 0.505}) {
            EXPECT_NEAR(stops(result.world, at, 0.3), 0.5, 0.01) << at;
            EXPECT_NEAR(stops(result.world, -0.3, at), 0.5, 0.01) << at;
        }
    }
}

/// In a level of polygons the side of a clip that lies on the wall is there, too: it looks into the wall.
TEST(ClipsOnWalls, ALevelOfPolygons) {
    Level level = test::empty_level();
    test::add_box(level, {0, 0, 0}, {10, 1, 4});
    const auto add_clip = [&](const std::vector<Vec3>& corners) {
        test::add_polygon(level, corners);
        level.faces.back().mask = kStopsWalk;
    };
    add_clip({{2, 0, 0.5}, {2, 0, 3.5}, {8, 0, 3.5}, {8, 0, 0.5}});  // looks into the wall
    add_clip({{2, -0.25, 0.5}, {8, -0.25, 0.5}, {8, -0.25, 3.5}, {2, -0.25, 3.5}});
    add_clip({{2, -0.25, 0.5}, {2, -0.25, 3.5}, {2, 0, 3.5}, {2, 0, 0.5}});  // three of its narrow sides: it is open
    add_clip({{8, -0.25, 0.5}, {8, 0, 0.5}, {8, 0, 3.5}, {8, -0.25, 3.5}});
    add_clip({{2, -0.25, 3.5}, {8, -0.25, 3.5}, {8, 0, 3.5}, {2, 0, 3.5}});
    const World world = make_world(level).value();
    ASSERT_EQ(world.face_count() - world.solid().face_count(), 5u);
    const CarveResult result = cut(world, box_mesh({4, 0, 1}, {5, 1, 2}).cutter().value());
    EXPECT_EQ(result.report.clips, 2u);
    expect_hole(result.world);
    EXPECT_FALSE(cast(result.world, Ray{{4.5, 3, 1.5}, {0, -7, 0}}, {.mask = kStopsWalk}).touched());
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// What carvings do to faces that are castable only: sheets are trimmed, panes go whole, clips go with walls, liquids
// and triggers stay; judged by samples, by check_world(), and by files, patches and slices of the same edits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/versions.h"
#include "firma/world_patch.h"
#include "log/hash_rules.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/carve/winding.h"
#include "tests/openarena_maps.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"
#include "tests/world/matter_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

using test::add_box;
using test::add_polygon;
using test::box_mesh;
using test::brush_world;
using test::empty_level;
using test::pose_at;

std::string fault_of(const World& world) {
    const auto fault = check_world(world);
    return fault ? fault->what + " " + std::to_string(fault->face.value) : "";
}

std::size_t open_faces(const World& world) {
    return world.face_count() - world.solid().face_count();
}

/// Square metres of faces that are castable only and stop something.
double open_area(const World& world, std::uint32_t mask = ~0u) {
    double area = 0;
    for (const Face& face : world.faces()) {
        if (face.solid || !(face.mask & mask)) continue;
        Vec3 sum;
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            sum = sum + cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0]);
        area += length(sum) / 2;
    }
    return area;
}

/// What holds of any edit: the world is sound, files, patches and slices give the same.
void expect_edit_sound(const World& before, const Cutter& cutter, const Pose& pose, const CarveResult& result) {
    ASSERT_EQ(result.status, CarveStatus::kDone) << result.error.text();
    EXPECT_EQ(fault_of(result.world), "");
    const std::uint64_t hash = hash_world(result.world);
    EXPECT_NE(hash, hash_world(before));
    EXPECT_EQ(result.world.version(), before.version() + 1);

    CarveJob job(before, cutter, pose);
    while (!job.run(0)) {
    }
    EXPECT_EQ(hash_world(job.result().world), hash);

    const Result<World> again = unpack_world(pack_world(result.world), "it");
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_EQ(hash_world(again.value()), hash);
    const Result<World> patched = apply_patch(before, make_patch(before, result.world), "it");
    ASSERT_TRUE(patched.ok()) << patched.error().text();
    EXPECT_EQ(hash_world(patched.value()), hash);
    EXPECT_EQ(hash_world(rebuild_index(result.world, {})), hash);

    const WorldDiff diff = diff_worlds(before, result.world);
    EXPECT_EQ(diff.removed.size(), result.report.faces_removed);
    EXPECT_EQ(diff.added.size(), result.report.faces_added);
    EXPECT_EQ(before.face_count() - diff.removed.size() + diff.added.size(), result.world.face_count());
    EXPECT_EQ(carve(result.world, cutter, pose).status, CarveStatus::kNothing);
}

/// A room of 10 m with a sheet of 6 m in the air.
Level level_with_sheet() {
    Level level = empty_level();
    add_box(level, {0, 0, 0}, {10, 10, 4}, true);
    add_polygon(level, {{2, 2, 2}, {8, 2, 2}, {8, 8, 2}, {2, 8, 2}});
    level.faces.back().two_sided = true;
    return level;
}

TEST(OpenFaces, ASheetGetsAHole) {
    const World world = make_world(level_with_sheet()).value();
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const Pose pose = pose_at(5, 5, 2, 1);
    const CarveResult result = carve(world, rock, pose);
    expect_edit_sound(world, rock, pose, result);
    EXPECT_EQ(result.report.open_trimmed, 1u);
    EXPECT_EQ(result.report.open_removed, 0u);
    EXPECT_EQ(result.report.faces_castable_only, 0u);
    EXPECT_EQ(result.report.volume, 0);
    EXPECT_TRUE(same_solid(result.world.solid(), world.solid()));
    for (const Face& face : result.world.faces()) {
        if (face.solid) continue;
        EXPECT_EQ(face.source, 6u);
        EXPECT_EQ(face.source_edit, 0u);
        EXPECT_TRUE(face.two_sided);
    }
    scenes::Rng rng(3);
    const test::PlacedWinding crater(rock, pose);
    std::size_t through = 0;
    for (int k = 0; k < 4000; ++k) {
        const Vec3 p{rng.uniform(2.01, 7.99), rng.uniform(2.01, 7.99), 2};
        if (!crater.is_clear(p, 1e-5)) continue;
        const bool in = crater.holds(p);
        through += in;
        EXPECT_EQ(cast(result.world, Ray{{p.x, p.y, 3.5}, {0, 0, -2}}).touched(), !in) << p.x << ' ' << p.y;
    }
    EXPECT_GT(through, 100u);
    // The world before is as it was.
    EXPECT_TRUE(cast(world, Ray{{5, 5, 3.5}, {0, 0, -2}}).touched());
}

TEST(OpenFaces, WhatIsSwallowedGoesAndASheetMayBeCutInTwo) {
    Level level = empty_level();
    add_box(level, {0, 0, 0}, {10, 10, 4}, true);
    add_polygon(level, {{5, 5, 2}, {5.5, 5, 2}, {5, 5.5, 2.25}});
    const World world = make_world(level).value();
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const CarveResult gone = carve(world, rock, pose_at(5, 5, 2, 2));
    ASSERT_TRUE(gone.done());
    EXPECT_EQ(gone.report.open_removed, 1u);
    EXPECT_EQ(gone.report.open_trimmed, 0u);
    EXPECT_EQ(open_faces(gone.world), 0u);
    EXPECT_EQ(fault_of(gone.world), "");
    const CarveResult next = carve(gone.world, rock, pose_at(5, 5, 0, 1));
    ASSERT_TRUE(next.done());
    EXPECT_EQ(fault_of(next.world), "");

    const World sheet = make_world(level_with_sheet()).value();
    const Cutter slot = box_mesh({4, 0.5, 1}, {5, 9.5, 3}).cutter().value();
    const CarveResult two = carve(sheet, slot, {});
    expect_edit_sound(sheet, slot, {}, two);
    EXPECT_EQ(open_faces(two.world), 2u) << "two rectangles, of whole corners";
    EXPECT_DOUBLE_EQ(open_area(two.world), 36 - 6);
}

TEST(OpenFaces, ACraterInAWallTakesADecalAlong) {
    Level level = empty_level();
    add_box(level, {0, 0, 0}, {10, 10, 4});
    add_polygon(level, {{3, 3, 4}, {7, 3, 4}, {7, 7, 4}, {3, 7, 4}});              // lies on the top
    add_polygon(level, {{3, 3, 4.01}, {7, 3, 4.01}, {7, 7, 4.01}, {3, 7, 4.01}});  // floats above it
    const World world = make_world(level).value();
    ASSERT_EQ(open_faces(world), 2u);
    const Cutter rock = make_crater(CutterShape::kRocky, 2);
    const Pose pose = pose_at(5, 5, 4, 1);
    const CarveResult result = carve(world, rock, pose);
    expect_edit_sound(world, rock, pose, result);
    EXPECT_EQ(result.report.open_trimmed, 2u);
    EXPECT_GT(result.report.volume, 0.5);
    EXPECT_TRUE(cast(result.world, Ray{{5, 5, 6}, {0, 0, -4}}).fraction > 0.6);
    // A box that takes the slab under the decal, flush with it: what lies on it goes. One that stands on it: nothing.
    const Cutter slab = box_mesh({4, 4, 3}, {6, 6, 4}).cutter().value();
    const CarveResult under = carve(world, slab, {});
    expect_edit_sound(world, slab, {}, under);
    EXPECT_EQ(under.report.open_trimmed, 1u);
    EXPECT_DOUBLE_EQ(open_area(under.world), 16 + 16 - 4);
    const Cutter above = box_mesh({4, 4, 4}, {6, 6, 4 + 1.0 / 256}).cutter().value();
    EXPECT_EQ(carve(world, above, {}).status, CarveStatus::kNothing);
}

TEST(OpenFaces, WhatTouchesOnlyDividesNothing) {
    const World world = make_world(level_with_sheet()).value();
    // On the sheet with a face, an edge, a corner; beside its rim.
    for (const test::TriangleMesh& mesh :
         {box_mesh({4, 4, 2}, {5, 5, 3}), box_mesh({8, 4, 1}, {9, 5, 3}), box_mesh({1, 1, 1}, {2, 2, 3})}) {
        const CarveResult result = carve(world, mesh.cutter().value(), {});
        EXPECT_EQ(result.status, CarveStatus::kNothing);
        EXPECT_EQ(result.report.open_trimmed, 0u);
    }
    test::TriangleMesh roof;  // a prism that stands on an edge in the sheet
    roof.vertices = {{4, 4, 2}, {6, 4, 2}, {4, 3, 3}, {6, 3, 3}, {4, 5, 3}, {6, 5, 3}};
    roof.triangles = {{0, 1, 3}, {0, 3, 2}, {1, 0, 4}, {1, 4, 5}, {2, 3, 5}, {2, 5, 4}, {0, 2, 4}, {1, 5, 3}};
    const Result<Cutter> cutter = roof.cutter();
    ASSERT_TRUE(cutter.ok()) << cutter.error().text();
    const CarveResult touched = carve(world, cutter.value(), {});
    EXPECT_EQ(touched.status, CarveStatus::kNothing) << touched.error.text();
    // Down through the sheet by half a metre: a rectangle of 2 x 1.
    const CarveResult cut = carve(world, cutter.value(), pose_at(0, 0, -0.5));
    expect_edit_sound(world, cutter.value(), pose_at(0, 0, -0.5), cut);
    EXPECT_DOUBLE_EQ(open_area(cut.world), 36 - 2);
}

/// Whether a point lies within a convex polygon, seen along its normal.
bool in_polygon(const Face& face, const Vec3& p) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const Vec3 &a = face.corners[k], &b = face.corners[k + 1 < face.corners.size() ? k + 1 : 0];
        if (dot(cross(b - a, p - a), face.normal) < 0) return false;
    }
    return true;
}

TEST(OpenFaces, AgreeWithSamplesCutAfterCut) {
    scenes::Rng rng(41);
    std::size_t in = 0, out = 0;
    for (const CutterShape shape : {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill, CutterShape::kWedge})
        for (const double size : {0.2, 1.0, 4.0, 60.0}) {
            Level level = empty_level();
            std::vector<std::array<Vec3, 3>> triangles(std::size_t(test::sample(30)));
            for (std::array<Vec3, 3>& triangle : triangles) {
                Vec3 middle;
                for (int axis = 0; axis < 3; ++axis) middle[axis] = rng.uniform(-1.5, 1.5);
                for (Vec3& corner : triangle) corner = to_metres(snap(middle + rng.direction() * size).value());
                add_polygon(level, {triangle.begin(), triangle.end()});
            }
            World world = make_world(level).value();
            const Cutter cutter = make_crater(shape, 9);
            std::vector<test::PlacedWinding> craters;
            for (int cut = 0; cut < 4; ++cut) {
                Pose pose = pose_at(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.5, 1.2));
                pose.rotation = random_turn(std::uint64_t(cut) + 7);
                const CarveResult result = carve(world, cutter, pose);
                ASSERT_NE(result.status, CarveStatus::kRefused) << result.error.text();
                world = result.world;
                craters.emplace_back(cutter, pose);
            }
            ASSERT_EQ(fault_of(world), "");
            std::vector<std::vector<Face>> pieces(triangles.size());
            for (const Face& face : world.faces()) pieces[face.source].push_back(face);
            for (std::size_t t = 0; t < triangles.size(); ++t)
                for (int k = 0; k < 60; ++k) {
                    double u = rng.uniform(0, 1), v = rng.uniform(0, 1);
                    if (u + v > 1) u = 1 - u, v = 1 - v;
                    const auto& [a, b, c] = triangles[t];
                    const Vec3 p = a + (b - a) * u + (c - a) * v;
                    bool taken = false, clear = true;
                    for (const test::PlacedWinding& crater : craters) {
                        taken |= crater.holds(p);
                        clear &= crater.is_clear(p, 1e-4);
                    }
                    if (!clear) continue;
                    std::size_t covered = 0;
                    for (const Face& face : pieces[t]) covered += in_polygon(face, p);
                    (taken ? in : out) += 1;
                    EXPECT_EQ(covered > 0, !taken) << t << ' ' << int(shape) << ' ' << size;
                }
        }
    EXPECT_GT(in, std::size_t(test::sample(1000)));
    EXPECT_GT(out, std::size_t(test::sample(1000)));
}

/// Slanted, 100 m long, and cut twice: what the first cut leaves has corners off the input grid, and no exact plane.
TEST(OpenFaces, ALongSlantedSheetIsCutAgain) {
    Level level = empty_level();
    const Vec3 a{0, 0, 0}, b{101, 7, 13}, c{47, 89, 3};
    add_polygon(level, {a, b, c});
    World world = make_world(level).value();
    const Cutter rock = make_crater(CutterShape::kRocky, 4);
    const double before = open_area(world);
    double area = before;
    for (const auto& [u, v] : {std::pair{0.3, 0.3}, {0.31, 0.3}, {0.5, 0.2}, {0.35, 0.4}, {0.1, 0.6}}) {
        const Vec3 at = a + (b - a) * u + (c - a) * v;
        const CarveResult result = carve(world, rock, pose_at(at.x, at.y, at.z, 1.5));
        ASSERT_TRUE(result.done()) << result.error.text();
        EXPECT_GT(result.report.open_trimmed, 0u);
        world = result.world;
        EXPECT_EQ(fault_of(world), "");
        const double now = open_area(world);
        EXPECT_LT(now, area - 0.1);
        EXPECT_GT(now, area - 15);
        area = now;
        EXPECT_FALSE(cast(world, Ray{at + Vec3{0, 0, 1}, {0, 0, -2}}).touched());
    }
    EXPECT_LT(open_faces(world), 400u);
}

/// A floor with a pane, a clip, a pool, a trigger and a grating on it.
World furnished(const WorldOptions& options = {}) {
    using map_text::box;
    return brush_world(box({0, 0, -2}, {40, 20, 0}, "stone") + box({5, 5, 0}, {5.25, 9, 3}, "glass") +
                           box({12, 5, 0}, {14, 9, 3}, "clip") + box({20, 5, 0}, {24, 9, 1}, "*water") +
                           box({28, 5, 0}, {30, 9, 3}, "trigger") + box({34, 5, 0}, {34.25, 9, 3}, "{grate"),
                       options);
}

TEST(OpenFaces, APaneGoesWhole) {
    const World world = furnished();
    ASSERT_EQ(fault_of(world), "");
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const Pose corner = pose_at(5, 9, 3, 0.5);
    const CarveResult result = carve(world, rock, corner);
    expect_edit_sound(world, rock, corner, result);
    EXPECT_EQ(result.report.panes, 1u);
    EXPECT_EQ(result.report.open_removed, 5u);
    EXPECT_EQ(result.report.open_trimmed, 0u);
    EXPECT_EQ(result.report.volume, 0);
    EXPECT_EQ(open_faces(result.world), open_faces(world) - 5);
    EXPECT_FALSE(cast(result.world, Ray{{4, 6, 1}, {2, 0, 0}}).touched());

    // A grating is no glass: it gets a hole.
    const Pose grating = pose_at(34.125, 7, 2, 0.5);
    const CarveResult hole = carve(world, rock, grating);
    expect_edit_sound(world, rock, grating, hole);
    EXPECT_EQ(hole.report.panes, 0u);
    EXPECT_EQ(hole.report.open_trimmed, 2u);
    EXPECT_TRUE(cast(hole.world, Ray{{33, 5.5, 0.5}, {3, 0, 0}}).touched());
    EXPECT_FALSE(cast(hole.world, Ray{{33, 7, 2}, {3, 0, 0}}).touched());

    // By the game's table glass may be hard: then it stays.
    WorldOptions options;
    options.matters = default_matters();
    options.matters->matters[*matter_named(*options.matters, "glass")].hardness = 1;
    const CarveResult kept = carve(furnished(options), rock, corner);
    EXPECT_EQ(kept.status, CarveStatus::kNothing);
    EXPECT_GT(kept.report.faces_castable_only, 0u);
}

/// The rule of panes wins over that of zones, once a shot reaches it outside of them.
TEST(OpenFaces, APaneHalfInAZoneGoesWholeOrNotAtAll) {
    WorldOptions options;
    options.rules.zones = {{"vault", {{0, 7, -1}, {40, 20, 9}}, 1}};
    const World world = furnished(options);
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const CarveResult kept = carve(world, rock, pose_at(5, 8.5, 2, 0.5));
    EXPECT_FALSE(kept.done());
    const CarveResult gone = carve(world, rock, pose_at(5, 5.5, 2, 0.5));
    ASSERT_TRUE(gone.done()) << gone.error.text();
    EXPECT_EQ(gone.report.panes, 1u);
    EXPECT_FALSE(cast(gone.world, Ray{{4, 8.5, 1}, {2, 0, 0}}).touched());
    EXPECT_TRUE(cast(world, Ray{{4, 8.5, 1}, {2, 0, 0}}).touched());
}

TEST(OpenFaces, ClipsAreTrimmedAndLiquidsAndTriggersStay) {
    const World world = furnished();
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const Pose clip = pose_at(12, 7, 0, 1);
    const CarveResult result = carve(world, rock, clip);
    expect_edit_sound(world, rock, clip, result);
    EXPECT_EQ(result.report.clips, 2u) << "the side that the crater reaches, and the top, over the hole in the floor";
    EXPECT_EQ(result.report.open_trimmed, 2u);
    EXPECT_GT(result.report.volume, 0.3);
    EXPECT_FALSE(cast(result.world, Ray{{11, 7, 0.25}, {1.5, 0, 0}}, {.mask = kStopsWalk}).touched());
    EXPECT_TRUE(cast(result.world, Ray{{11, 5.5, 2.5}, {1.5, 0, 0}}, {.mask = kStopsWalk}).touched());

    const double water = open_area(world, kStopsLiquid);
    const CarveResult pool = carve(world, rock, pose_at(22, 7, 0.5, 1));
    ASSERT_TRUE(pool.done());
    EXPECT_EQ(pool.report.open_trimmed + pool.report.open_removed, 0u);
    EXPECT_EQ(pool.report.faces_castable_only, 1u);
    EXPECT_EQ(open_area(pool.world, kStopsLiquid), water);
    const CarveResult surface = carve(world, rock, pose_at(22, 7, 1.5, 1));
    EXPECT_EQ(surface.status, CarveStatus::kNothing);
    EXPECT_EQ(surface.report.faces_castable_only, 1u) << "nothing, though something was there that stays";
    const CarveResult trigger = carve(world, rock, pose_at(28, 7, 2, 1));
    EXPECT_EQ(trigger.status, CarveStatus::kNothing);
    EXPECT_EQ(trigger.report.faces_castable_only, 0u);
}

TEST(OpenFaces, RulesKeepThem) {
    const World world = make_world(level_with_sheet()).value();
    CarveRules rules;
    rules.open_faces = false;
    const World kept = with_rules(world, rules).value();
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const CarveResult result = carve(kept, rock, pose_at(5, 5, 2, 1));
    EXPECT_EQ(result.status, CarveStatus::kNothing);
    EXPECT_EQ(result.report.faces_castable_only, 1u);
    EXPECT_EQ(fill(world, rock, pose_at(5, 5, 0, 2)).report.open_trimmed, 0u);
    // Files and logs know.
    const World again = unpack_world(pack_world(kept), "it").value();
    EXPECT_FALSE(again.data().rules->open_faces);
    EXPECT_EQ(carve(again, rock, pose_at(5, 5, 2, 1)).status, CarveStatus::kNothing);
    EXPECT_NE(hash_rules(rules, nullptr), hash_rules({}, nullptr));
    // By material: what may not be carved stays.
    rules = {};
    rules.hardness = {1};
    EXPECT_EQ(carve(with_rules(world, rules).value(), rock, pose_at(5, 5, 2, 0.5)).status, CarveStatus::kNothing);
    // A zone that may not be carved: the sheet in it stays, the rest is trimmed.
    rules = {};
    rules.zones.push_back({.name = "half", .box = {{0, 0, 0}, {5, 10, 4}}, .hardness = 1});
    const CarveResult half = carve(with_rules(world, rules).value(), rock, pose_at(5, 5, 1, 2));
    EXPECT_EQ(half.status, CarveStatus::kDone) << half.error.text();
    EXPECT_TRUE(cast(half.world, Ray{{4.9, 5, 3.5}, {0, 0, -2}}).touched());
    EXPECT_FALSE(cast(half.world, Ray{{5.1, 5, 3.5}, {0, 0, -2}}).touched());
    // Limits refuse, and leave the world as it was.
    rules = {};
    rules.max_new_faces = 4;
    const CarveResult many = carve(with_rules(world, rules).value(), rock, pose_at(5, 5, 2, 1));
    EXPECT_EQ(many.status, CarveStatus::kRefused);
    EXPECT_EQ(many.error.code, ErrorCode::kTooLarge);
    rules = {};
    rules.max_faces = world.face_count();
    EXPECT_EQ(carve(with_rules(world, rules).value(), rock, pose_at(5, 5, 2, 1)).status, CarveStatus::kRefused);
}

TEST(OpenFaces, NumberedEditsGiveIdsOfTheirOwn) {
    const World world = make_world(level_with_sheet()).value();
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const CarveResult first = carve(world, rock, pose_at(4, 4, 2, 0.5), {.material = "", .edit = 3});
    ASSERT_TRUE(first.done());
    EXPECT_EQ(first.world.solid().edits(), 3u);
    const CarveResult second = carve(first.world, rock, pose_at(7, 7, 2, 0.5), {.material = "", .edit = 9});
    ASSERT_TRUE(second.done());
    EXPECT_EQ(fault_of(second.world), "");
    for (const Face& face : second.world.faces()) EXPECT_EQ(face.solid, face.id.value < 1u << 31);
    EXPECT_EQ(carve(second.world, rock, pose_at(7, 3, 2, 0.5), {.material = "", .edit = 9}).status,
              CarveStatus::kRefused);
    WorldEdit edit(world);
    EXPECT_TRUE(edit.carve(rock, pose_at(4, 4, 2, 0.5)).done());
    EXPECT_TRUE(edit.carve(rock, pose_at(5, 5, 0, 0.5)).done());
    EXPECT_EQ(fault_of(edit.finish()), "");
}

/// Blasts at castable-only faces of a map, each world sound, nothing left in a crater.
void blast_open_faces(World world, std::uint64_t seed, std::size_t blasts) {
    ASSERT_EQ(fault_of(world), "");
    scenes::Rng rng(seed);
    std::vector<Vec3> places;
    for (const Face& face : world.faces())
        if (!face.solid && (face.mask & kStopsSolid)) places.push_back(face.corners[0]);
    ASSERT_GT(places.size(), 10u);
    const Cutter rock = make_crater(CutterShape::kRocky, seed);
    std::size_t trimmed = 0, removed = 0;
    for (std::size_t k = 0; k < blasts; ++k) {
        Pose pose = pose_at(0, 0, 0, rng.uniform(0.3, 2));
        pose.position = places[std::size_t(rng.uniform(0, double(places.size())))];
        pose.rotation = random_turn(seed + k);
        const CarveResult result = carve(world, rock, pose);
        ASSERT_NE(result.status, CarveStatus::kRefused) << result.error.text();
        trimmed += result.report.open_trimmed;
        removed += result.report.open_removed;
        world = result.world;
        if (k % 8 == 7 || k + 1 == blasts) {
            ASSERT_EQ(fault_of(world), "") << k;
        }
        const test::PlacedWinding crater(rock, pose);
        for (const Face& face : world.faces()) {
            if (face.solid || !(face.mask & kStopsSolid)) continue;
            Vec3 middle;
            for (const Vec3& corner : face.corners) middle = middle + corner * (1.0 / double(face.corners.size()));
            if (length(middle - pose.position) > 2 * pose.scale) continue;
            EXPECT_FALSE(crater.holds(middle) && crater.is_clear(middle, 1e-4)) << k;
        }
    }
    EXPECT_GT(trimmed, blasts / 2);
    EXPECT_GT(removed, 0u);
}

TEST(OpenFaces, MapsOfOpenArena) {
    std::size_t maps = 0;
    for (const std::filesystem::path& path : openarena_maps()) {
        if (path.stem() != "kaos2" && path.stem() != "oa_dm5") continue;
        ++maps;
        SCOPED_TRACE(path.string());
        blast_open_faces(make_world(read_level(path.string()).value()).value(), 5, std::size_t(test::sample(40)));
        blast_open_faces(make_world(read_brush_level(path.string()).value()).value(), 6, std::size_t(test::sample(40)));
    }
    if (maps == 0) GTEST_SKIP() << kNoOpenArena;
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Craters in levels of several matters: what they leave shows the inside of what they cut, exactly split; what may not
// be carved stays, exactly; softer and harder matters.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "firma/carve.h"
#include "firma/matter.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "scenes/rng.h"
#include "tests/brush/depot_level.h"
#include "tests/carve/cutters.h"
#include "tests/world/matter_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// Points within a facet: weights of its corners.
std::vector<Vec3> points_within(const Face& face, scenes::Rng& rng, int count) {
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) {
        Vec3 sum;
        double weights = 0;
        for (const Vec3& corner : face.corners) {
            const double weight = rng.uniform(0.05, 1);
            sum = sum + corner * weight;
            weights += weight;
        }
        points.push_back(sum * (1 / weights));
    }
    return points;
}

struct Shown {
    std::size_t points = 0, wrong = 0;
    std::map<std::string, double> area;  ///< of new faces, by material
};

double area_of(const Face& face) {
    Vec3 sum;
    for (std::size_t k = 2; k < face.corners.size(); ++k)
        sum = sum + cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0]);
    return 0.5 * length(sum);
}

/// Compares the material of faces that edits made with the matter just behind them, at sample points.
Shown shown_by(const World& world, std::uint64_t seed) {
    scenes::Rng rng(seed);
    Shown shown;
    for (const Face& face : world.faces()) {
        if (face.source_edit == 0) continue;
        shown.area[world.material_name(face.material)] += area_of(face);
        if (area_of(face) < 1e-6) continue;
        for (const Vec3& point : points_within(face, rng, 4)) {
            // Deeper than facets are off, and less deep than anything is thin; not beside where matters meet.
            const Vec3 behind = point - face.normal * 3e-5;
            const std::uint32_t found = matter_at(world, behind);
            bool near_border = false;
            for (int axis = 0; axis < 3; ++axis)
                for (const double step : {-3e-5, 3e-5}) {
                    Vec3 beside = behind;
                    beside[axis] += step;
                    near_border |= matter_at(world, beside) != found;
                }
            if (near_border) continue;
            ++shown.points;
            shown.wrong += matter(world, found).inside != world.material_name(face.material);
        }
    }
    return shown;
}

TEST(CutMatters, FacesShowTheInsideOfWhatWasCut) {
    const World world = test::brush_world(test::three_matters());
    const Cutter rock = make_crater(CutterShape::kRocky, 5);
    const CarveResult one = carve(world, rock, test::pose_at(2, 2, 4));
    ASSERT_TRUE(one.done()) << one.error.text();
    test::expect_sound_world(one.world);
    Shown shown = shown_by(one.world, 1);
    EXPECT_EQ(shown.wrong, 0u);
    EXPECT_EQ(shown.area.size(), 1u);
    EXPECT_GT(shown.area["matter/brick"], 3);
    // Between two: split along x = 4.
    const CarveResult two = carve(world, rock, test::pose_at(4, 2, 4, 1.5));
    ASSERT_TRUE(two.done()) << two.error.text();
    test::expect_sound_world(two.world);
    shown = shown_by(two.world, 2);
    EXPECT_EQ(shown.wrong, 0u);
    EXPECT_GT(shown.points, 200u);
    EXPECT_EQ(shown.area.size(), 2u);
    EXPECT_GT(shown.area["matter/brick"], 2);
    EXPECT_GT(shown.area["matter/wood"], 2);
    for (const Face& face : two.world.faces()) {
        if (face.source_edit == 0) continue;
        double low = 1e9, high = -1e9;
        for (const Vec3& corner : face.corners) {
            low = std::fmin(low, corner.x);
            high = std::fmax(high, corner.x);
        }
        EXPECT_TRUE(low >= 4 || high <= 4) << low << " " << high;
    }
    // Through all three.
    const CarveResult all = carve(world, rock, test::pose_at(6, 2, 2, 5));
    ASSERT_TRUE(all.done()) << all.error.text();
    test::expect_sound_world(all.world);
    EXPECT_EQ(shown_by(all.world, 3).wrong, 0u);
}

TEST(CutMatters, SeamsDoNotCountForTheSolid) {
    const World world = test::brush_world(test::three_matters());
    const Cutter rock = make_crater(CutterShape::kSpiky, 8);
    const CarveResult split = carve(world, rock, test::pose_at(4, 2, 4, 1.2)),
                      whole = carve(world, rock, test::pose_at(4, 2, 4, 1.2), {"rubble"});
    ASSERT_TRUE(split.done() && whole.done());
    EXPECT_EQ(hash_solid(split.world), hash_solid(whole.world));
    EXPECT_TRUE(same_solid(split.world, whole.world));
    EXPECT_EQ(split.report.volume, whole.report.volume);
    EXPECT_NEAR(measure_solid(split.world).volume, measure_solid(whole.world).volume, 1e-12);
    for (const Face& face : whole.world.faces())
        EXPECT_EQ(whole.world.material_name(face.material) == "rubble", face.source_edit != 0);
    // What is kept of the hash is what it is anew.
    SolidData anew = split.world.solid().data();
    hash_points_anew(anew);
    EXPECT_EQ(anew.point_sum, split.world.solid().data().point_sum);
    // The same again takes nothing.
    EXPECT_EQ(carve(split.world, rock, test::pose_at(4, 2, 4, 1.2)).status, CarveStatus::kNothing);
}

/// An overhang of wood on a floor of brick, cut straight down where they meet: the new face is one as to the solid, and
/// divided there, beside the edge of the two that was there.
TEST(CutMatters, ASeamBesideAnEdgeThatIsThere) {
    const std::vector<map_text::PlaneText> overhang{{{-1, 0, 0}, 0}, {{1, 0, 0}, 4},   {{0, -1, 0}, 0},
                                                    {{0, 2, -1}, 0}, {{0, 0, -1}, -4}, {{0, 0, 1}, 8}};
    const World world = test::brush_world(map_text::box({0, 0, 0}, {4, 8, 4}, "old_brick") +
                                          map_text::plane_brush(overhang, "wood_panel"));
    const CarveResult cut = carve(world, test::box_mesh({-1, -1, 3}, {5, 2, 5}).cutter().value(), {});
    ASSERT_TRUE(cut.done()) << cut.error.text();
    test::expect_sound_world(cut.world);
    const Shown shown = shown_by(cut.world, 1);
    EXPECT_EQ(shown.wrong, 0u);
    EXPECT_EQ(shown.area.at("matter/brick"), 4 * 1 + 4 * 2);
    EXPECT_EQ(shown.area.at("matter/wood"), 4 * 1 + 4 * 2);
}

TEST(CutMatters, OverlapsAndSlopesAreSplitExactly) {
    // A tilted brush in a block, overlapped by others: planes meet inside new faces.
    std::string tilted = "{\n";
    const Vec3 a[6][3] = {{{1, 1, 0}, {1, 2, 0.3}, {1.4, 1, 4}},      {{3, 1, 0}, {3.4, 1, 4}, {3, 2, 0.3}},
                          {{1, 1, 0}, {1.4, 1, 4}, {3, 1, 0}},        {{1, 3, 0}, {3, 3, 0}, {1.4, 3, 4}},
                          {{1, 1, 0.25}, {3, 1, 0.25}, {1, 3, 0.25}}, {{1, 1, 3.75}, {1, 3, 3.75}, {3, 1, 3.75}}};
    for (const auto& side : a) {
        for (const Vec3& p : side) tilted += map_text::point(p);
        tilted += "steel 0 0 0 1 1\n";
    }
    tilted += "}\n";
    const std::string level = tilted + map_text::box({0, 0, 0}, {4, 4, 4}, "brick") +
                              map_text::box({2, 2, 2}, {6, 6, 6}, "wood") + map_text::box({3, 3, 0}, {5, 5, 5}, "rock");
    const World world = test::brush_world(level);
    scenes::Rng rng(4);
    std::size_t done = 0, points = 0;
    std::map<std::string, double> area;
    for (int round = 0; round < 3; ++round) {
        World now = world;
        for (int k = 0; k < 25; ++k) {
            Pose pose = test::pose_at(rng.uniform(0, 6), rng.uniform(0, 6), rng.uniform(0, 6), rng.uniform(0.3, 1.5));
            pose.rotation = random_turn(rng.next());
            // Some on the lattice, so that they touch the pieces' planes.
            if (k % 3 == 0) pose = test::pose_at(double(k % 6), double(k % 5), double(k % 4), 1);
            const CutterShape shape = k % 3 == 0 ? CutterShape::kBox : CutterShape(rng.next() % 5);
            const CarveResult cut = carve(now, make_crater(shape, rng.next()), pose);
            ASSERT_NE(cut.status, CarveStatus::kRefused) << cut.error.text();
            if (!cut.done()) continue;
            ++done;
            now = cut.world;
            test::expect_sound_world(now);
            SolidData anew = now.solid().data();
            hash_points_anew(anew);
            EXPECT_EQ(anew.point_sum, now.solid().data().point_sum);
        }
        const Shown shown = shown_by(now, std::uint64_t(round));
        EXPECT_EQ(shown.wrong, 0u) << "of " << shown.points;
        points += shown.points;
        for (const auto& [name, size] : shown.area) area[name] += size;
    }
    EXPECT_GT(done, 40u);
    EXPECT_GT(points, 2000u);
    EXPECT_EQ(area.size(), 4u);
}

TEST(CutMatters, WhatMayNotBeCarvedStaysExactly) {
    // Rock with a block of sky in it.
    const World world =
        test::brush_world(map_text::box({0, 0, 0}, {8, 8, 8}, "rock") + map_text::box({3, 3, 6}, {5, 5, 9}, "skyblue"));
    const World plain = test::brush_world(map_text::box({0, 0, 0}, {8, 8, 8}, "rock"));
    const Solid block =
        make_world(read_map(map_text::world(map_text::box({3, 3, 6}, {5, 5, 9}, "x")), "b", {.scale = 1}).value())
            .value()
            .solid();
    scenes::Rng rng(9);
    std::size_t cut_short = 0;
    for (int k = 0; k < 40; ++k) {
        Pose pose = test::pose_at(rng.uniform(1, 7), rng.uniform(1, 7), rng.uniform(5, 9), rng.uniform(0.5, 2));
        pose.rotation = random_turn(rng.next());
        if (k % 4 == 0) pose = test::pose_at(3, 4, 8 - k % 3, 1);
        const Cutter cutter = make_crater(k % 4 == 0 ? CutterShape::kBox : CutterShape(k % 5), std::uint64_t(k));
        const CarveResult cut = carve(world, cutter, pose);
        // The same by Solids: the cutter without the block, taken from the rock and the block.
        const SolidResult placed = unite(Solid(), cutter, pose);
        ASSERT_TRUE(placed.done());
        const SolidResult trimmed = subtract(placed.solid, cutter_from_solid(block).value(), {});
        ASSERT_NE(trimmed.status, CarveStatus::kRefused);
        if (trimmed.solid.face_count() == 0) {
            EXPECT_EQ(cut.error.text(), "cutter " + cutter.name() + ": material skyblue may not be carved");
            continue;
        }
        const SolidResult by_hand = subtract(world.solid(), cutter_from_solid(trimmed.solid).value(), {});
        if (by_hand.status == CarveStatus::kNothing) {
            EXPECT_EQ(cut.status, trimmed.done() ? CarveStatus::kRefused : CarveStatus::kNothing);
            continue;
        }
        ASSERT_TRUE(by_hand.done());
        ASSERT_TRUE(cut.done()) << cut.error.text();
        EXPECT_TRUE(same_solid(cut.world.solid(), by_hand.solid));
        EXPECT_EQ(hash_solid(cut.world), hash_solid(by_hand.solid));
        EXPECT_NEAR(cut.report.volume, measure_solid(world).volume - measure_solid(cut.world).volume, 1e-9);
        EXPECT_EQ(cut.report.cut_short, trimmed.done() ? 1u : 0u);
        cut_short += cut.report.cut_short;
        // Nothing of the block is gone, and the rest is as if it were not there.
        EXPECT_EQ(carve(cut.world, make_crater(CutterShape::kBox, 0), test::pose_at(4, 4, 7.5, 0.25)).status,
                  CarveStatus::kRefused);
        const CarveResult without = carve(plain, cutter, pose);
        EXPECT_LE(cut.report.volume, (without.done() ? without.report.volume : 0) + 1e-9);
        test::expect_sound_world(cut.world);
        EXPECT_EQ(shown_by(cut.world, std::uint64_t(k)).wrong, 0u);
        for (const Face& face : cut.world.faces()) {
            if (face.source_edit == 0) continue;
            EXPECT_TRUE(face.source < cutter.triangles().size() || face.source == ~0u);
        }
    }
    EXPECT_GT(cut_short, 10u);
}

TEST(CutMatters, AZoneCutsShortToo) {
    CarveRules rules;
    rules.zones.push_back({"vault", {{2, 2, 2}, {9, 9, 9}}, 1});
    WorldOptions options;
    options.rules = rules;
    const World world = test::brush_world(map_text::box({0, 0, 0}, {4, 4, 4}, "rock"), options);
    const Cutter box = make_crater(CutterShape::kBox, 0);
    const CarveResult cut = carve(world, box, test::pose_at(2, 2, 2, 1.5));
    ASSERT_TRUE(cut.done()) << cut.error.text();
    EXPECT_NEAR(cut.report.volume, 27 - 1.5 * 1.5 * 1.5, 1e-12);
    EXPECT_EQ(cut.report.cut_short, 1u);
    test::expect_sound_world(cut.world);
    EXPECT_EQ(carve(world, box, test::pose_at(3.25, 3.25, 3.25, 0.5)).error.text(),
              "cutter box: zone vault may not be carved");
    EXPECT_EQ(fill(world, box, test::pose_at(5, 5, 5, 0.5)).status, CarveStatus::kRefused);
    const CarveResult filled = fill(world, box, test::pose_at(2, 2, 4, 1));
    ASSERT_TRUE(filled.done());
    EXPECT_NEAR(filled.report.volume, -(4 - 1), 1e-12);
}

TEST(CutMatters, TheMatterNearestToTheMiddleSaysHowMuchACutterIsShrunk) {
    MatterTable table = default_matters();
    table.matters[*matter_named(table, "brick")].hardness = 0.5;
    table.matters[*matter_named(table, "wood")].hardness = 0.75;
    WorldOptions options;
    options.matters = table;
    const World world = test::brush_world(test::three_matters(), options);
    const Cutter rock = make_crater(CutterShape::kRocky, 2);
    EXPECT_EQ(carve(world, rock, test::pose_at(2, 2, 4)).report.scale, 0.5);
    EXPECT_EQ(carve(world, rock, test::pose_at(2, 2, 4.5)).report.scale, 0.5);  // in the air
    EXPECT_EQ(carve(world, rock, test::pose_at(6, 2, 4)).report.scale, 0.25);
    EXPECT_EQ(carve(world, rock, test::pose_at(10, 2, 2)).report.scale, 1);
    // It reaches the wood as well, and is shrunk by the brick alone.
    EXPECT_EQ(carve(world, rock, test::pose_at(3.5, 2, 3.8, 2)).report.scale, 0.5);
    const CarveResult shrunk = carve(world, rock, test::pose_at(2, 2, 4, 2)),
                      small = carve(test::brush_world(test::three_matters()), rock, test::pose_at(2, 2, 4, 1));
    EXPECT_EQ(shrunk.report.volume, small.report.volume);
    // One material's hardness counts more than its matter's.
    CarveRules rules;
    rules.hardness.assign(8, 0);
    for (std::uint32_t k = 0; k < 8; ++k)
        if (world.material_name(k) == "old_brick") rules.hardness[k] = 0.25;
    EXPECT_EQ(carve(with_rules(world, rules).value(), rock, test::pose_at(2, 2, 4)).report.scale, 0.75);
}

TEST(CutMatters, AMatterThatMayNotBeCarved) {
    MatterTable table = default_matters();
    table.matters[*matter_named(table, "steel")].hardness = 1;
    WorldOptions options;
    options.matters = table;
    const World world = test::brush_world(test::three_matters(), options);
    const Cutter box = make_crater(CutterShape::kBox, 0);
    EXPECT_EQ(carve(world, box, test::pose_at(10, 2, 3)).error.text(), "cutter box: matter steel may not be carved");
    const CarveResult cut = carve(world, box, test::pose_at(8, 2, 3));
    ASSERT_TRUE(cut.done());
    EXPECT_NEAR(cut.report.volume, 4, 1e-12);
    test::expect_sound_world(cut.world);
    // What lies open of the steel shows its inside.
    Shown shown = shown_by(cut.world, 1);
    EXPECT_EQ(shown.wrong, 0u);
    EXPECT_NEAR(shown.area["matter/steel"], 4, 1e-9);
    EXPECT_EQ(carve(world, box, test::pose_at(30, 2, 3)).status, CarveStatus::kNothing);
}

TEST(CutMatters, SlicesEndInTheSameBits) {
    const World world = test::brush_world(test::three_matters() + map_text::box({3, 4, 0}, {5, 5, 4}, "sky"));
    const Cutter rock = make_crater(CutterShape::kRocky, 4);
    const Pose pose = test::pose_at(4.2, 3.5, 3.5, 1.3);
    CarveJob job(world, rock, pose);
    while (!job.run(0)) {
    }
    const CarveResult once = carve(world, rock, pose);
    ASSERT_TRUE(once.done());
    EXPECT_EQ(once.report.cut_short, 1u);
    EXPECT_EQ(hash_world(job.result().world), hash_world(once.world));
    const Result<World> read = unpack_world(pack_world(world), "m");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(hash_world(carve(read.value(), rock, pose).world), hash_world(once.world));
}

/// Issue 16: today 47 of 200 craters are refused at the sky.
TEST(CutMatters, InTheDepotCratersAreCutShortAtTheSky) {
    const World world = make_world(test::depot_level()).value();
    EXPECT_GT(count_matters(world).protected_pieces, 0u);
    const Box bounds = world.bounds();
    scenes::Rng rng(31);
    World now = world;
    std::size_t done = 0, cut_short = 0, refused = 0;
    const RoomId exterior{std::uint32_t(world.room_count()) - 1};
    for (int k = 0; k < 120; ++k) {
        Vec3 from, way;
        for (Location place; place.where != Where::kAir || place.room == exterior; place = locate(world, from))
            for (int axis = 0; axis < 3; ++axis) from[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        for (int axis = 0; axis < 3; ++axis) way[axis] = rng.uniform(-1, 1);
        const Hit hit = cast(now, {from, 0}, way * 1000);
        const std::uint64_t seed = rng.next();
        if (!hit.touched()) continue;
        Pose pose{hit.point, random_turn(seed), rng.uniform(0.4, 1.2)};
        const CarveResult cut = carve(now, make_crater(CutterShape::kRocky, seed), pose);
        done += cut.done();
        cut_short += cut.done() && cut.report.cut_short > 0;
        if (cut.status == CarveStatus::kRefused) {
            ++refused;
            EXPECT_NE(cut.error.reason.find("may not be carved"), std::string::npos) << cut.error.text();
        }
        now = cut.world;
    }
    test::expect_sound_world(now);
    EXPECT_GT(done, 60u);
    EXPECT_GT(cut_short, 0u);
    const Shown shown = shown_by(now, 6);
    EXPECT_EQ(shown.wrong, 0u) << "of " << shown.points;
    EXPECT_GT(shown.area.size(), 3u);
    SolidData anew = now.solid().data();
    hash_points_anew(anew);
    EXPECT_EQ(anew.point_sum, now.solid().data().point_sum);
    EXPECT_GT(refused, 0u);  // in the middle of the sky
    EXPECT_LT(refused, 30u);
}

}  // namespace
}  // namespace firma

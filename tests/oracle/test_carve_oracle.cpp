// SPDX-License-Identifier: MIT
// The oracle of volumes by hand, and against itself without rounding.
#include "tests/reference/carve_oracle.h"

#include <gtest/gtest.h>

#include "firma/carve.h"
#include "scenes/contact_families.h"
#include "scenes/cut_families.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/world_facets.h"

namespace firma::reference {
namespace {

using scenes::kMetre;
using scenes::Steps;

World box_world(bool room) {
    scenes::Rng rng(1);
    std::vector<scenes::GridPolygon> faces;
    scenes::PanelBox box{{0, 0, 0}, {4 * kMetre, 4 * kMetre, 4 * kMetre}};
    box.room = room;
    scenes::add_panel_box(faces, box, rng);
    return make_world(scenes::level_of(faces)).value();
}

PlacedCutter placed_box(const Vec3& low, const Vec3& high) {
    Pose pose;
    pose.position = (low + high) * 0.5;
    return place_cutter(scenes::box_cutter((high - low) * 0.5), pose).value();
}

TEST(CarveOracle, BoxesByHand) {
    const World block = box_world(false), room = box_world(true);
    const PlacedCutter corner = placed_box({-1, -1, -1}, {1, 2, 3});  // 1 x 2 x 3 in the block, of 2 x 3 x 4
    EXPECT_EQ(volume_of(corner), 24);
    EXPECT_EQ(exact_volume_within(block, corner), 6);
    EXPECT_EQ(exact_volume_within(room, corner), 18);
    EXPECT_EQ(exact_volume_within(block, placed_box({1, 1, 1}, {2, 2, 2})), 1);
    EXPECT_EQ(exact_volume_within(room, placed_box({1, 1, 1}, {2, 2, 2})), 0);
    EXPECT_EQ(exact_volume_within(block, placed_box({1, 1, 5}, {2, 2, 6})), 0);
    EXPECT_EQ(exact_volume_within(block, placed_box({1, 1, -5}, {2, 2, -4})), 0);
    EXPECT_EQ(exact_volume_within(room, placed_box({1, 1, -5}, {2, 2, -4})), 1);
    EXPECT_EQ(exact_volume_within(block, placed_box({-1, -1, -1}, {5, 5, 5})), 64);
    EXPECT_EQ(exact_volume_within(block, placed_box({0, 0, 0}, {4, 4, 2})), 32);  // flush all around
}

TEST(CarveOracle, RoundedSumsAreTheExactOnesToManyDigits) {
    const Level none = scenes::make_cut_case(scenes::cut_families()[3], 1, 0, {}).level;
    for (const char* name : {"pillars", "thin_walls", "flush_boxes", "repeated"})
        for (const scenes::CutFamily& family : scenes::cut_families()) {
            if (family.name != name) continue;
            const scenes::CutCase it = scenes::make_cut_case(family, 4, 2, none);
            World world = make_world(it.level).value();
            int compared = 0;
            for (const scenes::CutOrder& order : it.cuts) {
                const Result<PlacedCutter> placed = place_cutter(order.cutter, order.pose);
                if (placed && placed.value().triangles.size() <= 64 && compared < 2) {
                    const Real rounded = volume_within(world, placed.value());
                    const Fraction exact = exact_volume_within(world, placed.value());
                    const Real error = abs(rounded - Real(numerator(exact)) / Real(denominator(exact)));
                    EXPECT_LT(error, volume_of(placed.value()) * Real("1e-40")) << name;
                    ++compared;
                }
                world = make_cut(world, order).world;
            }
            EXPECT_GT(compared, 0) << name;
        }
}

// Faces in one plane, edges on edges, vertices on faces: of levels that no cut has touched.
TEST(CarveOracle, RoundedSumsAreTheExactOnesInContact) {
    const Level ours = scenes::make_cut_case(scenes::cut_families()[3], 1, 0, {}).level;
    for (const scenes::CutFamily& family : scenes::contact_families()) {
        if (family.name == "contact_our_level" || family.name == "contact_terrain") continue;  // of many faces
        const scenes::CutCase it = scenes::make_cut_case(family, 4, 2, ours);
        const World world = make_world(it.level).value();
        int compared = 0;
        for (const scenes::CutOrder& order : it.cuts) {
            const PlacedCutter placed = place_cutter(order.cutter, order.pose).value();
            if (placed.triangles.size() > 150 || compared == 3) continue;
            const Real rounded = volume_within(world, placed);
            const Fraction exact = exact_volume_within(world, placed);
            const Real error = abs(rounded - Real(numerator(exact)) / Real(denominator(exact)));
            EXPECT_LT(error, volume_of(placed) * Real("1e-40")) << family.name;
            ++compared;
        }
        EXPECT_GT(compared, 0) << family.name;
    }
}

TEST(CarveOracle, SeesWhatIsMissing) {
    const World block = box_world(false);
    Pose pose;
    pose.position = {4.01, 2.02, 2.03};
    const CarveResult result = carve(block, make_crater(CutterShape::kRocky, 3), pose);
    ASSERT_TRUE(result.done());
    ASSERT_EQ(result.report.retries, 0);
    const PlacedCutter placed = place_cutter(make_crater(CutterShape::kRocky, 3), pose).value();
    FacetChange change = compare_facets(block, result.world);
    const Real within = volume_within(block, placed);
    EXPECT_LT(abs(volume_lost(change.gone, change.come, placed) - within), Real("1e-50"));
    // Without all facets of one new face the sum is another one.
    const FaceOwner* owner = change.come.back().block->owner_of(change.come.back().record());
    std::erase_if(change.come, [&](const FacetPlace& place) { return place.block->owner_of(place.record()) == owner; });
    EXPECT_GT(abs(volume_lost(change.gone, change.come, placed) - within), Real("1e-9"));
}

TEST(CarveOracle, SolidsAreTheSameOrNot) {
    const World block = box_world(false);
    Pose here, there;
    here.position = {4, 1, 1};
    there.position = {4, 3, 3};
    here.scale = there.scale = 0.5;
    const Cutter rock = make_crater(CutterShape::kRocky, 3), box = make_crater(CutterShape::kBox, 0);
    const World one = carve(carve(block, rock, here).world, box, there).world;
    const World other = carve(carve(block, box, there).world, rock, here).world;
    EXPECT_TRUE(reference::same_solid(one, other));
    EXPECT_FALSE(reference::same_solid(one, carve(block, rock, here).world));
    EXPECT_FALSE(reference::same_solid(one, block));
}

TEST(CarveOracle, Winding) {
    const World block = box_world(false), room = box_world(true);
    EXPECT_NEAR(winding(all_facets(block), {1, 2, 3}), 1, 1e-12);
    EXPECT_NEAR(winding(all_facets(block), {5, 2, 3}), 0, 1e-12);
    EXPECT_NEAR(winding(all_facets(room), {1, 2, 3}), -1, 1e-12);
    EXPECT_NEAR(winding(placed_box({0, 0, 0}, {1, 1, 1}), {0.5, 0.5, 0.25}), 1, 1e-12);
}

}  // namespace
}  // namespace firma::reference

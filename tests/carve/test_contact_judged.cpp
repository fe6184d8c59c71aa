// SPDX-License-Identifier: MIT
// A sample of cuts in forced contact, each judged by all that must hold after an edit; ./test --full makes thousands.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "carve/check_shells.h"
#include "firma/brush_world.h"
#include "scenes/contact_families.h"
#include "scenes/lattice_solids.h"
#include "scenes/level_cuts.h"
#include "solid/append_faces.h"
#include "tests/brush/unprotected_world.h"
#include "tests/carve/cutters.h"
#include "tests/reference/carve_oracle.h"
#include "tests/reference/cut_history.h"
#include "tests/reference/judge_contact.h"
#include "tests/reference/judge_cube_grid.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/judge_digs.h"
#include "tests/reference/world_facets.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

const Level& level_of_ours() {
    static const Level level = read_level(FIRMA_ROOT "/levels/first.obj").value();
    return level;
}

reference::JudgeOptions contact_sample() {
    reference::JudgeOptions options{8, 6, 4, 0.2, true, 8};
    options.contact = true;
    options.history_points = 12;
    return options;
}

void expect_contact_holds(const reference::CutTally& tally) {
    EXPECT_EQ(tally.failed, 0u);
    for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
    EXPECT_EQ(tally.refused, 0u);
    EXPECT_GE(tally.done, 2u);
    EXPECT_EQ(tally.again, tally.done);
    EXPECT_GE(tally.history_points, 20u);
    EXPECT_EQ(tally.replayed, tally.cuts);
}

class ContactFamilies : public testing::TestWithParam<scenes::CutFamily> {};

TEST_P(ContactFamilies, HoldEveryInvariant) {
    const reference::ContradictionsReported reported;
    expect_contact_holds(reference::judge_case(GetParam(), 1, 0, level_of_ours(), contact_sample()));
}

INSTANTIATE_TEST_SUITE_P(All, ContactFamilies, testing::ValuesIn(scenes::contact_families()),
                         [](const testing::TestParamInfo<scenes::CutFamily>& family) {
                             return std::string(family.param.name);
                         });

/// Of a floor of 16 m, dug row by row, all quarters are alike; the two farther ones meet the nearer ones, and along a
/// part of their seam each other.
TEST(LatticeDigs, SeamsBetweenFacesThatBecomeOneByWayOfOthersGo) {
    Solid solid = make_solid(test::box_level({-8, -8, -8}, {8, 8, 8})).value();
    const reference::ContradictionsReported reported;
    for (int k = 0; k < 64; ++k) {
        const Pose pose = test::pose_at(-7 + 2 * (k % 8), -7 + 2 * (k / 8), 7);
        const SolidResult result = subtract(solid, make_crater(CutterShape::kBox, 0), pose);
        ASSERT_TRUE(result.done()) << k << ": " << result.error.text();
        const auto fault = check_solid(result.solid);
        ASSERT_FALSE(fault) << k << ": " << fault->what;
        solid = result.solid;
    }
    EXPECT_TRUE(same_solid(solid, make_solid(test::box_level({-8, -8, -8}, {8, 8, 6})).value()));
}

void expect_dig_holds(const reference::DigVerdict& verdict, std::uint64_t seed) {
    for (const std::string& failure : verdict.failures) ADD_FAILURE() << "seed " << seed << ": " << failure;
    EXPECT_GT(verdict.done, 5u);
}

TEST(LatticeDigs, AreWhatAListOfCellsSays) {
    const reference::ContradictionsReported reported;
    for (std::uint64_t seed = 0; seed < std::uint64_t(test::sample(40)); ++seed)
        expect_dig_holds(reference::judge_lattice_dig(seed), seed);
}

/// Most of these once ended in a crash, a contradiction or an edge used once; the last one meets slits.
TEST(MixedDigs, HoldWhatMustHoldAfterAnyCut) {
    const reference::ContradictionsReported reported;
    for (const std::uint64_t seed :
         test::sampled(std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 2ull << 32 | 47}))
        expect_dig_holds(reference::judge_mixed_dig(seed), seed);
}

TEST(ContactCuts, InTheDepotHoldEveryInvariant) {
    const reference::ContradictionsReported reported;
    const BrushLevel level = read_brush_level(FIRMA_ROOT "/levels/depot.map").value();
    const World world = test::unprotected_world(level, false), again = test::unprotected_world(level, false);
    const auto cuts = scenes::contact_cuts(scenes::cut_places(world).inside, 1, 0);
    ASSERT_GE(cuts.size(), 8u);
    expect_contact_holds(reference::judge_cuts(world, again, cuts, "depot", 1, contact_sample()));
}

TEST(ContactFamilies, SameSeedsMakeSameCutsAndAllCanBePlaced) {
    for (const scenes::CutFamily& family : scenes::contact_families())
        for (std::uint64_t index = 0; index < 4; ++index) {
            const scenes::CutCase a = scenes::make_cut_case(family, 5, index, level_of_ours());
            const scenes::CutCase b = scenes::make_cut_case(family, 5, index, level_of_ours());
            SCOPED_TRACE(std::string(family.name) + ' ' + std::to_string(index));
            EXPECT_EQ(level_solidity(a.level).solid_faces, a.level.faces.size());
            ASSERT_GE(a.cuts.size(), 12u);
            ASSERT_EQ(a.cuts.size(), b.cuts.size());
            for (std::size_t k = 0; k < a.cuts.size(); ++k) {
                EXPECT_EQ(a.cuts[k].pose.position, b.cuts[k].pose.position);
                const auto p = a.cuts[k].cutter.vertices(), q = b.cuts[k].cutter.vertices();
                EXPECT_TRUE(std::equal(p.begin(), p.end(), q.begin(), q.end()));
                const Result<PlacedCutter> placed = place_cutter(a.cuts[k].cutter, a.cuts[k].pose);
                ASSERT_TRUE(placed) << placed.error().text();
                EXPECT_FALSE(check_cutter(placed.value())) << "cut " << k << ": " << a.cuts[k].cutter.name();
            }
        }
}

TEST(LatticeSolids, HaveTheVolumesThatTheyAreMeantToHave) {
    const auto volume = [](const scenes::LatticeSolid& solid) {
        Pose pose;
        const Cutter cutter = scenes::cutter_of(scenes::scaled(solid, scenes::kMetre), "solid", pose.position);
        const PlacedCutter placed = place_cutter(cutter, pose).value();
        EXPECT_FALSE(check_cutter(placed));
        return static_cast<double>(reference::volume_of(placed));
    };
    EXPECT_EQ(volume(scenes::block_solid({1, 2, 3}, {2, 4, 6})), 6);
    EXPECT_EQ(volume(scenes::sponge_solid(1)), 20);
    EXPECT_EQ(volume(scenes::sponge_solid(2)), 400);
    EXPECT_EQ(volume(scenes::letter_solid('O', 2)), 24);
    EXPECT_NEAR(volume(scenes::tetrahedron({0, 0, 0}, {0, 3, 0}, {3, 0, 0}, {0, 0, 3})), 4.5, 1e-12);
    scenes::Rng rng(1);
    for (std::uint32_t turn = 0; turn < 24; ++turn) {
        EXPECT_EQ(volume(scenes::turned(scenes::letter_solid('L', 1), turn)), 7);
        EXPECT_GT(volume(scenes::turned(scenes::gear_solid(rng, 2), turn)), 72);
    }
    // 24 turns, each another one.
    std::set<std::vector<std::array<std::int64_t, 3>>> seen;
    for (std::uint32_t turn = 0; turn < 24; ++turn) {
        std::vector<std::array<std::int64_t, 3>> vertices;
        for (const scenes::Steps& v : scenes::turned(scenes::letter_solid('F', 1), turn).vertices)
            vertices.push_back({v.x, v.y, v.z});
        seen.insert(vertices);
    }
    EXPECT_EQ(seen.size(), 24u);
}

TEST(CubeGrid, FilledAndCarvedAgainLeavesNothing) {
    const reference::ContradictionsReported reported;
    for (const double edge : {0.25, 1.0, 64.0})
        for (const std::uint64_t order : {0, 1}) {
            const reference::CubeGridVerdict verdict = reference::judge_cube_grid({4, edge, order});
            SCOPED_TRACE("edge " + std::to_string(edge) + " order " + std::to_string(order));
            for (const std::string& failure : verdict.failures) ADD_FAILURE() << failure;
            EXPECT_EQ(verdict.edits, 256u);
            EXPECT_EQ(verdict.refused, 0u);
            // Seams where large faces were divided may stay.
            EXPECT_LE(verdict.faces_full, edge <= 1 ? 6u : 60u);
        }
}

// The judge must be able to find fault.

World two_boxes(double gap) {
    test::TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
    World world = fill(World(), mesh.cutter().value(), Pose{}).world;
    return fill(world, mesh.cutter().value(), test::pose_at(1 + gap, 0, 0)).world;
}

TEST(ContactJudge, FindsFacesThatLieOnEachOther) {
    const World apart = two_boxes(1.0 / 4096);
    EXPECT_EQ(reference::doubled_face(apart, reference::all_facets(apart)), "");
    // The faces of two boxes side by side, as they are: a skin of two faces between. And a box upon itself.
    const Cutter box = test::box_mesh({0, 0, 0}, {1, 1, 1}).cutter().value();
    const World one = fill(World(), box, Pose{}).world;
    for (const double x : {1, 0}) {
        FaceSet set = reference::set_of(one);
        const World other = fill(World(), box, test::pose_at(x, 0, 0)).world;
        for_each_block_of(other.data(),
                          [&](const Block& block) { append_faces(block, set, [](std::uint32_t) { return true; }); });
        const World both = reference::with_faces(one, set);
        EXPECT_NE(reference::doubled_face(both, reference::all_facets(both)), "") << x;
    }
}

TEST(ContactJudge, TellsSolidsOfEqualAreasAndMomentsApart) {
    const World block = two_boxes(4);
    EXPECT_TRUE(reference::same_solid(block, block));
    EXPECT_FALSE(reference::same_solid(block, two_boxes(4 + 1.0 / 4096)));
    EXPECT_FALSE(reference::same_solid(block, two_boxes(3)));
}

TEST(ContactJudge, FindsTheResultOfAnotherCut) {
    const World world = two_boxes(4);
    scenes::CutOrder order{test::box_mesh({0, 0, 0}, {0.5, 0.5, 1}).cutter().value(), {}, CarveKind::kCarve};
    scenes::CutOrder other = order;
    other.pose.position.x = 0.125;
    reference::JudgeOptions options = contact_sample();
    options.back = 1;
    options.history_points = 40;
    const auto holds = [&](const CarveResult& result) {
        scenes::Rng rng(1);
        reference::CutTally tally;
        return reference::ContactJudge(world, options).judge(world, order, result, rng, "here", tally);
    };
    const CarveResult right = reference::make_cut(world, order);
    EXPECT_TRUE(holds(right));
    EXPECT_FALSE(holds(reference::make_cut(world, other)));
    CarveResult none;
    none.status = CarveStatus::kNothing;
    none.world = world;
    EXPECT_FALSE(holds(none));
}

TEST(ContactJudge, KnowsWherePointsLieByLevelAndCutters) {
    const World world = two_boxes(4);  // 0..1 and 5..6
    reference::CutHistory history(world);
    EXPECT_EQ(history.solid_at({0.5, 0.5, 0.5}), true);
    EXPECT_EQ(history.solid_at({2, 0.5, 0.5}), false);
    const Cutter box = test::box_mesh({0, 0, 0}, {1, 1, 1}).cutter().value();
    history.add(place_cutter(box, test::pose_at(1, 0, 0)).value(), CarveKind::kFill);
    history.add(place_cutter(box, test::pose_at(0.25, 0, 0)).value(), CarveKind::kCarve);
    EXPECT_EQ(history.solid_at({0.125, 0.5, 0.5}), true);
    EXPECT_EQ(history.solid_at({0.5, 0.5, 0.5}), false);
    EXPECT_EQ(history.solid_at({1.5, 0.5, 0.5}), true);
    EXPECT_EQ(history.solid_at({1, 0.5, 0.5}), std::nullopt);  // on a plane
}

}  // namespace
}  // namespace firma

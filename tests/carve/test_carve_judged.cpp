// SPDX-License-Identifier: MIT
// A sample of cuts of every family, each judged by all that must hold after an edit; ./test --full makes thousands.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tests/reference/judge_carved_casts.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma {
namespace {

const Level& our_level() {
    static const Level level = read_level(FIRMA_ROOT "/levels/first.obj").value();
    return level;
}

constexpr reference::JudgeOptions kSample{20, 12, 4, 0.2, true, 14};

class CutFamilies : public testing::TestWithParam<scenes::CutFamily> {};

TEST_P(CutFamilies, HoldEveryInvariant) {
    const reference::CutTally tally = reference::judge_case(GetParam(), 1, 0, our_level(), kSample);
    EXPECT_EQ(tally.failed, 0u);
    for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
    EXPECT_GE(tally.done, 5u);
    EXPECT_GE(tally.points, 20u);
    EXPECT_EQ(tally.replayed, tally.cuts);
    EXPECT_EQ(tally.cuts, tally.done + tally.nothing + tally.refused);
    EXPECT_LE(tally.unplaceable + tally.blamed, tally.refused);
}

INSTANTIATE_TEST_SUITE_P(All, CutFamilies, testing::ValuesIn(scenes::cut_families()),
                         [](const testing::TestParamInfo<scenes::CutFamily>& family) {
                             return std::string(family.param.name);
                         });

const scenes::CutFamily& family_of(std::string_view name) {
    for (const scenes::CutFamily& family : scenes::cut_families())
        if (family.name == name) return family;
    return scenes::cut_families()[0];
}

TEST(CutFamilies, SameSeedsMakeSameCuts) {
    for (const scenes::CutFamily& family : scenes::cut_families()) {
        const scenes::CutCase a = scenes::make_cut_case(family, 5, 3, our_level());
        const scenes::CutCase b = scenes::make_cut_case(family, 5, 3, our_level());
        EXPECT_EQ(a.level.vertices, b.level.vertices) << family.name;
        ASSERT_EQ(a.cuts.size(), b.cuts.size());
        ASSERT_FALSE(a.cuts.empty());
        EXPECT_EQ(a.cuts[0].pose.position, b.cuts[0].pose.position);
        EXPECT_TRUE(std::equal(a.cuts[0].cutter.vertices().begin(), a.cuts[0].cutter.vertices().end(),
                               b.cuts[0].cutter.vertices().begin(), b.cuts[0].cutter.vertices().end()));
    }
}

TEST(CutFamilies, LevelsBoundSolids) {
    for (const scenes::CutFamily& family : scenes::cut_families()) {
        if (family.name == "closed_meshes") continue;  // some have an edge of four faces, which no solid has
        const World world = make_world(scenes::make_cut_case(family, 2, 1, our_level()).level).value();
        std::size_t solid = 0;
        for (const FacetPlace& place : reference::all_facets(world)) solid += place.record().solid;
        EXPECT_EQ(solid, world.face_count()) << family.name;
        EXPECT_EQ(reference::open_edge(world), "") << family.name;
    }
}

TEST(CarvedWorlds, CastsAreWhatTheOracleSays) {
    const World world = reference::carved_world(family_of("our_level_corner"), 1, 40, our_level());
    scenes::Rng rng(1);
    reference::Tally tally;
    for (int k = 0; k < 8; ++k) tally.add(reference::judge_casts_at(world, rng, 100, 2));
    EXPECT_EQ(tally.errors(), 0u);
    for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
    EXPECT_GT(tally.touched, 200u);
}

TEST(CarvedWorlds, NoRayEscapes) {
    const World world = reference::carved_world(family_of("our_level_spread"), 1, 40, our_level());
    scenes::Rng rng(2);
    reference::RayTally tally;
    reference::shoot_from_air(world, rng, 20000, tally);
    EXPECT_EQ(tally.lost, 0u) << tally.first_failure;
    EXPECT_EQ(tally.rays, 20000u);
}

// Halving the long thin faces that a drill of 400 m left made pieces with two corners in one place.
TEST(FoundByTheJudge, LargeThinFacesCanBeTiled) {
    const scenes::CutCase it = scenes::make_cut_case(family_of("huge"), 5, 18, our_level());
    World world = make_world(it.level).value();
    for (std::size_t k = 0; k < 7; ++k) world = reference::make_cut(world, it.cuts[k]).world;
    const CarveResult result = reference::make_cut(world, it.cuts[7]);
    EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.text();
}

// The judge must be able to find fault.

World without_face(const World& world, std::size_t which) {
    FaceSet set = reference::set_of(world);
    set.faces.erase(set.faces.begin() + std::ptrdiff_t(which));
    return reference::with_faces(world, set);
}

TEST(Judge, FindsAnOpenEdge) {
    const World world = reference::carved_world(family_of("our_level_spread"), 1, 3, our_level());
    EXPECT_EQ(reference::open_edge(world), "");
    EXPECT_NE(reference::open_edge(without_face(world, 7)), "");
}

/// The surface of a cube around the origin, as text of an .obj; `out` turns it to the outside.
std::string cube(int half, bool out) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;
            for (int corner = 0; corner < 4; ++corner) {
                std::array<int, 3> at;
                at[std::size_t(axis)] = side * half;
                at[std::size_t(a)] = corner == 1 || corner == 2 ? half : -half;
                at[std::size_t(b)] = corner >= 2 ? half : -half;
                text += "v " + std::to_string(at[0]) + ' ' + std::to_string(at[1]) + ' ' + std::to_string(at[2]) + '\n';
            }
            text += (side > 0) == out ? "f -4 -3 -2 -1\n" : "f -1 -2 -3 -4\n";
        }
    }
    return text;
}

TEST(Judge, LosesRaysInAHoleThoughARoomLiesBehindIt) {
    // A cell in a block in a hall in rock. Who gets out of the cell through the block meets the hall's wall from the
    // front; only the block's side, met from behind, tells.
    const World whole = make_world(read_obj(cube(1, false) + cube(2, true) + cube(10, false), "").value()).value();
    ASSERT_EQ(whole.face_count(), 18u);
    reference::RayTally closed;
    scenes::Rng rng(1);
    reference::shoot_from_air(whole, rng, 5000, closed);
    EXPECT_EQ(closed.lost, 0u) << closed.first_failure;
    for (std::size_t face = 0; face < whole.face_count(); ++face) {
        reference::RayTally open;
        reference::shoot_from_air(without_face(whole, face), rng, 20000, open);
        EXPECT_GT(open.lost, 0u) << face;
    }
}

TEST(Judge, FindsAChangedFace) {
    const World world = reference::carved_world(family_of("pillars"), 1, 3, our_level());
    const World other = without_face(world, 3);
    EXPECT_EQ(reference::compare_facets(world, other).gone.size(), 1u);
    EXPECT_TRUE(reference::compare_facets(world, other).untouched_kept);
    EXPECT_NE(reference::hash_of_facets(world), reference::hash_of_facets(other));
    EXPECT_NE(reference::hash_of_surface(world), reference::hash_of_surface(other));
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Cuts in contact that were once wrong, as small as they could be made.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "firma/carve.h"
#include "firma/solid.h"
#include "scenes/lattice_solids.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_cut.h"

namespace firma {
namespace {

using scenes::LatticeSolid;
using scenes::Steps;

class FoundInContact : public testing::Test {
    const reference::ContradictionsReported reported_;
};

/// A solid in whole steps, metres if nothing else is said, as a cutter where it is.
CarveResult cut(const World& world, const LatticeSolid& solid, CarveKind kind, std::int64_t step = scenes::kMetre) {
    Pose pose;
    const Cutter cutter = scenes::cutter_of(scenes::scaled(solid, step), "solid", pose.position);
    return kind == CarveKind::kFill ? fill(world, cutter, pose) : carve(world, cutter, pose);
}

World filled(const World& world, const LatticeSolid& solid) {
    return cut(world, solid, CarveKind::kFill).world;
}

LatticeSolid unit_cube(std::int64_t x, std::int64_t y, std::int64_t z) {
    return scenes::block_solid({x, y, z}, {x + 1, y + 1, z + 1});
}

World rock() {
    return filled(World(), scenes::block_solid({-4, -4, -4}, {4, 4, 4}));
}

LatticeSolid prism(const std::vector<Steps>& corners, const Steps& way) {
    return scenes::moved_polygon(corners, way);
}

void expect_volume(const CarveResult& result, double volume) {
    EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.text();
    test::expect_sound_world(result.world);
    EXPECT_NEAR(measure_solid(result.world).volume, volume, 1e-12);
}

/// Another cavity beside a cube's, touched from the rock.
void expect_second_cavity(const LatticeSolid& second) {
    const World first = cut(rock(), unit_cube(0, 0, 0), CarveKind::kCarve).world;
    expect_volume(cut(first, second, CarveKind::kCarve), 510);
}

TEST_F(FoundInContact, ACavityThatSharesAnEdgeWithAnother) {
    expect_second_cavity(unit_cube(1, 1, 0));
}
TEST_F(FoundInContact, ACavityThatSharesAVertexWithAnother) {
    expect_second_cavity(unit_cube(1, 1, 1));
}
TEST_F(FoundInContact, ACavityThatSharesPartOfAnEdgeWithAnother) {
    const World first = cut(rock(), scenes::block_solid({0, 0, -1}, {1, 1, 2}), CarveKind::kCarve).world;
    expect_volume(cut(first, unit_cube(1, 1, 0), CarveKind::kCarve), 508);
}

void expect_two_solids(const LatticeSolid& one, const LatticeSolid& other, double volume) {
    expect_volume(cut(filled(World(), one), other, CarveKind::kFill), volume);
    expect_volume(cut(filled(World(), other), one, CarveKind::kFill), volume);
}

TEST_F(FoundInContact, CubesThatShareAnEdge) {
    expect_two_solids(unit_cube(0, 0, 0), unit_cube(1, 1, 0), 2);
}
TEST_F(FoundInContact, CubesThatShareAVertex) {
    expect_two_solids(unit_cube(0, 0, 0), unit_cube(1, 1, 1), 2);
}
TEST_F(FoundInContact, BlocksThatSharePartOfAnEdge) {
    expect_two_solids(scenes::block_solid({0, 0, -1}, {1, 1, 2}), unit_cube(1, 1, 0), 4);
}
TEST_F(FoundInContact, BlocksThatSharePartsOfAnEdgeFromItsEnd) {
    expect_two_solids(scenes::block_solid({0, 0, 0}, {1, 1, 2}), unit_cube(1, 1, 0), 3);
}
// Their faces along it lie in one plane on one side.
TEST_F(FoundInContact, WedgesThatShareAnEdge) {
    expect_two_solids(prism({{0, 1, 0}, {2, 1, 0}, {0, 1, 2}}, {0, 1, 0}),
                      prism({{0, 1, 0}, {0, 1, -1}, {2, 1, 0}}, {0, -2, 0}), 2 + 2);
}
TEST_F(FoundInContact, TetrahedraThatSharePartOfAnEdge) {
    expect_two_solids(scenes::tetrahedron({1, -1, 0}, {-1, -2, 0}, {0, -2, 0}, {1, -1, -1}),
                      scenes::tetrahedron({1, -1, -1}, {3, -1, 0}, {1, 1, 1}, {1, -1, 1}), 1.0 / 6 + 4.0 / 3);
}
TEST_F(FoundInContact, APartThatMeetsNothingIsFound) {
    const World first = filled(World(), prism({{0, 0, -1}, {0, 1, -1}, {2, 0, -1}}, {0, 0, -2}));
    expect_volume(cut(first, prism({{1, 1, 1}, {1, 1, -1}, {1, -1, 1}}, {-1, 0, 0}), CarveKind::kFill), 4);
}

// The wall is longer than 8 m once the third is there, and is halved on the way.
TEST_F(FoundInContact, BlocksThatGrowIntoAWallTooLongToStayWhole) {
    World world = filled(World(), scenes::block_solid({4, 0, 0}, {10, 1, 1}));
    world = filled(world, scenes::block_solid({0, 1, 0}, {5, 2, 1}));
    expect_volume(cut(world, unit_cube(5, 1, 0), CarveKind::kFill), 12);
}

// The box's sides are longer than 8 m; one of them lies in the block's plane.
TEST_F(FoundInContact, ALargeBoxFlushWithABlockItHolds) {
    const World block = filled(World(), scenes::block_solid({-7, -6, -1}, {-1, -4, 1}));
    expect_volume(cut(block, scenes::block_solid({-2, -8, -10}, {4, 10, 8}), CarveKind::kFill), 1944 + 24 - 4);
    const World flush = filled(World(), scenes::block_solid({-7, -8, -1}, {-1, -6, 1}));
    expect_volume(cut(flush, scenes::block_solid({-2, -8, -10}, {4, 10, 8}), CarveKind::kFill), 1944 + 24 - 4);
}

TEST_F(FoundInContact, SlopesThatMeetInAVertexAndAnEdge) {
    constexpr std::int64_t kStep = scenes::kMetre / 64;
    const LatticeSolid one = scenes::tetrahedron({112, -240, -80}, {-104, -296, -48}, {107, -86, -16}, {16, -240, -80});
    const LatticeSolid two = scenes::tetrahedron({-8, -208, -48}, {110, -204, 8}, {80, -104, -56}, {-104, -296, -48});
    const LatticeSolid wedge = prism({{16, -112, -90}, {16, -208, -90}, {48, -112, -90}}, {0, 0, 64});
    const World first = cut(World(), one, CarveKind::kFill, kStep).world;
    const CarveResult both = cut(first, two, CarveKind::kFill, kStep);
    ASSERT_TRUE(both.done()) << both.error.text();
    test::expect_sound_world(both.world);
    const CarveResult all = cut(both.world, wedge, CarveKind::kFill, kStep);
    EXPECT_TRUE(all.done()) << all.error.text();
    test::expect_sound_world(all.world);
}

void expect_same_hash_back_and_forth(const World& world, const LatticeSolid& solid, CarveKind kind) {
    const World once = cut(world, solid, kind).world;
    const World back = cut(once, solid, kind == CarveKind::kFill ? CarveKind::kCarve : CarveKind::kFill).world;
    const World forth = cut(back, solid, kind).world;
    EXPECT_EQ(measure_solid(once).volume, measure_solid(forth).volume);
    EXPECT_EQ(hash_solid(once), hash_solid(forth));
    test::expect_sound_world(forth);
}

TEST_F(FoundInContact, BackAndForthGivesTheSameHash) {
    // Three cells upright, and one beside the middle one: an edge of the block lies on one of theirs.
    const World block = filled(World(), scenes::block_solid({0, 0, 1}, {3, 1, 4}));
    expect_same_hash_back_and_forth(block, scenes::cells_solid({{-1, -1, 0}, {-1, -1, 1}, {-1, 0, 0}}),
                                    CarveKind::kFill);
}

}  // namespace
}  // namespace firma

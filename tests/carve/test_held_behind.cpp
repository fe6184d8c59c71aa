// SPDX-License-Identifier: MIT
// The quick proof that a shell is not loose: never of a loose one, and of most faces of what holds.
#include <gtest/gtest.h>

#include "carve/gather.h"
#include "carve/held_behind.h"
#include "firma/carve.h"
#include "firma/chunk.h"
#include "scenes/cut_levels.h"
#include "scenes/grid_polygons.h"
#include "scenes/rng.h"
#include "solid/shells.h"
#include "solid/solid_data.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

using namespace test;

struct HeldCounts {
    std::size_t held = 0, loose = 0, told = 0;  ///< facets; `told` of the held ones
};

GridBox box_in_steps(const Box& metres) {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::int32_t(metres.low[axis] * kSurfaceSteps);
        box.high[axis] = std::int32_t(metres.high[axis] * kSurfaceSteps);
    }
    return box;
}

/// Of all facets, by all shells of the solid. Two shells that touch only in corners are two.
HeldCounts judge_all(const World& world, const Box& cutter = {{8000, 8000, 8000}, {8001, 8001, 8001}}) {
    const Node* root = world.solid().data().faces.root.get();
    const Anchors& anchors = *world.data().anchors;
    const Boundary boundary = take_boundary(root);
    const BoundaryShells shells = find_shells(boundary);
    std::vector<bool> holds(shells.faces.size());
    for (std::size_t shell = 0; shell < holds.size(); ++shell) {
        holds[shell] = !(shells.volumes[shell].high > 0);
        for (const std::uint32_t face : shells.faces[shell])
            if (anchors.holds(boundary.patch.faces[face].facet.record())) holds[shell] = true;
    }
    HeldCounts counts;
    for (std::uint32_t face = 0; face < boundary.patch.faces.size(); ++face) {
        std::vector<FacetPlace> facets;
        gather_face(root, boundary.patch.faces[face].facet, facets);
        for (const FacetPlace& facet : facets) {
            const bool told = is_held_behind(*root, facet, box_in_steps(cutter), anchors);
            const bool held = holds[shells.of_face[face]];
            (held ? counts.held : counts.loose) += 1;
            counts.told += held && told;
            EXPECT_FALSE(told && !held) << "a facet at " << to_metres(facet.block->corner(facet.record(), 0)).x;
        }
    }
    return counts;
}

/// Boulders put onto the floor, and the floor taken from under them without a look for what is loose.
World with_loose_boulders(World world, std::uint64_t seed, const Box& floor, int count) {
    scenes::Rng rng(seed);
    const auto place = [&](double z, double scale) {
        Pose pose = pose_at(rng.uniform(floor.low.x, floor.high.x), rng.uniform(floor.low.y, floor.high.y), z, scale);
        pose.rotation = random_turn(rng.next());
        return pose;
    };
    for (int k = 0; k < count; ++k) {
        const Pose pose = place(0.6, 0.9);
        world = fill(world, make_crater(CutterShape::kRocky, rng.next()), pose).world;
        const Vec3 at = pose.position;
        const Cutter slab = box_mesh(at - Vec3{2, 2, 0.9}, at + Vec3{2, 2, -0.4}).cutter().value();
        const CarveResult cut = carve(world, slab, {});
        EXPECT_TRUE(cut.done());
        world = cut.world;
    }
    return world;
}

World bumpy_level(int panels) {
    scenes::Rng rng(3);
    return make_world(scenes::level_of(scenes::bumpy_rooms(rng, 1, panels, {}).faces)).value();
}

TEST(HeldBehind, NeverOfALooseShell) {
    std::size_t loose = 0;
    for (int seed = 1; seed <= sample(4); ++seed) {
        // The outer side of the hull hangs free, and holds.
        const World world =
            with_loose_boulders(with_anchors(bumpy_level(6)), std::uint64_t(seed), {{2, 2, 0}, {10, 10, 0}}, 8);
        const HeldCounts counts = judge_all(world);
        loose += counts.loose;
        EXPECT_GT(counts.told, counts.held / 2);
    }
    EXPECT_GT(loose, 500u);
}

/// All that the line tells of is on the lattice of the bodies' edges; sides that lie on each other, and touch.
TEST(HeldBehind, OnALattice) {
    scenes::Rng rng(5);
    std::size_t loose = 0, told = 0;
    for (int k = 0; k < sample(100); ++k) {
        World world = with_anchors(make_world(box_level({0, 0, 0}, {6, 6, 6}, true)).value());
        for (int box = 0; box < 14; ++box) {
            Vec3 low, high;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = int(rng.below(5));
                high[axis] = low[axis] + 1 + int(rng.below(2));
            }
            const Cutter cutter = box_mesh(low, high).cutter().value();
            const CarveResult result = box % 3 < 2 ? fill(world, cutter, {}) : carve(world, cutter, {});
            if (result.done()) world = result.world;
        }
        auto anchors = std::make_shared<Anchors>(*world.data().anchors);
        anchors->edits.clear();  // what was put where it touched nothing
        auto data = std::make_shared<WorldData>(world.data());
        data->anchors = anchors;
        const HeldCounts counts = judge_all(World(std::move(data)));
        loose += counts.loose;
        told += counts.told;
    }
    EXPECT_GT(loose, 100u);
    EXPECT_GT(told, 100u);
}

TEST(HeldBehind, NothingHoldsWithoutAnchors) {
    const World world = with_anchors(bumpy_level(4), {.hanging = false});
    const HeldCounts counts = judge_all(world);
    EXPECT_GT(counts.held, 50u) << "the room looks inward";
    EXPECT_GT(counts.loose, 5u) << "the hull";
    EXPECT_EQ(counts.told, 0u) << "every line leaves the hull";
}

/// What lies at the cutter is not what it was.
TEST(HeldBehind, NothingIsToldThroughTheCutter) {
    const World world = with_anchors(make_world(box_level({0, 0, 0}, {6, 6, 6}, true)).value());
    EXPECT_EQ(judge_all(world).told, judge_all(world).held);
    EXPECT_EQ(judge_all(world, {{-9, -9, -9}, {9, 9, 9}}).told, 0u);
    const HeldCounts counts = judge_all(world, {{-9, -9, -9}, {9, 9, -7}});
    EXPECT_GT(counts.told, 0u);
    EXPECT_LT(counts.told, counts.held) << "the floor's";
}

}  // namespace
}  // namespace firma

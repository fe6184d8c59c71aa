// SPDX-License-Identifier: MIT
// What casts look at in a carved world, beside a tree built from scratch over the same facets: counted, not timed.
#include <gtest/gtest.h>

#include "firma/carve.h"
#include "firma/queries.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "tests/sample.h"

namespace firma {
namespace {

double looked_at(const World& world) {
    CastCounts counts;
    for (const scenes::CastRange& range : {scenes::kShortSpheres, scenes::kLongSpheres, scenes::kShortRays})
        for (const scenes::CastQuery& query : scenes::casts_in_rooms(scenes::room_grid_of(6000), range, 500, 3))
            static_cast<void>(cast(world, query.sphere, query.path, {.counts = &counts}));
    return double(counts.nodes + counts.boxes);
}

TEST(CarvedTree, CastsLookAtLittleMoreThanInATreeFromScratch) {
    for (const Split split : {Split::kLongestAxis, Split::kSurfaceArea}) {
        World world = make_world(scenes::room_grid(scenes::room_grid_of(6000)), {.tree = {.split = split}}).value();
        const Box bounds = world.bounds();
        scenes::Rng rng(17);
        int done = 0;
        for (int k = 0; k < 400; ++k) {
            Pose pose{.scale = 1.2};
            for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
            pose.rotation = random_turn(rng.next());
            const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, rng.next()), pose);
            done += cut.done();
            world = cut.world;
        }
        EXPECT_GT(done, 300);
        const double ratio = looked_at(world) / looked_at(rebuild_index(world, {.split = split}));
        RecordProperty(split == Split::kLongestAxis ? "longest_axis" : "surface_area", std::to_string(ratio));
        EXPECT_LT(ratio, 1.2) << done;
        EXPECT_GT(ratio, 0.8);
    }
}

/// A long life: craters, each filled again a while later, over and over in the same rooms. (F7 of 0.1: 1.4 times at
/// 10,000 edits.)
TEST(CarvedTree, ALongLifeOfCutsAndFillsStaysAsGoodAsNew) {
    World world = make_world(scenes::room_grid(scenes::room_grid_of(6000))).value();
    const Box bounds = world.bounds();
    scenes::Rng rng(23);
    std::vector<Pose> open;
    int done = 0;
    for (int k = 0; k < test::sample(3000); ++k) {
        const bool fills = open.size() > 60;
        Pose pose;
        if (fills) {
            pose = open.front();
            open.erase(open.begin());
            pose.scale *= 1.3;
        } else {
            for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
            pose.rotation = random_turn(rng.next());
            pose.scale = rng.uniform(0.3, 0.9);
            open.push_back(pose);
        }
        const Cutter cutter = make_crater(CutterShape::kRocky, fills ? 2 : 1);
        const CarveResult edit = fills ? fill(world, cutter, pose) : carve(world, cutter, pose);
        done += edit.done();
        world = edit.world;
    }
    EXPECT_GT(done, test::sample(1500));
    const double ratio = looked_at(world) / looked_at(rebuild_index(world, {}));
    RecordProperty("after", std::to_string(ratio));
    EXPECT_LT(ratio, 1.15) << done << " edits, " << world.face_count() << " faces";
}

}  // namespace
}  // namespace firma

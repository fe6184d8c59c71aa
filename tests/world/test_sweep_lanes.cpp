// SPDX-License-Identifier: MIT
// Casts eight triangles at a time leave out nothing that is met: every kernel that this processor runs, asked for all up
// to the very time at which a facet is touched, looks at this facet.
#include <gtest/gtest.h>

#include <set>

#include "cast/cast_sphere_polygon.h"
#include "firma/queries.h"
#include "scenes/cast_families.h"
#include "solid/face_shape.h"
#include "tests/sample.h"
#include "world/sweep_lanes.h"
#include "world/world_data.h"

namespace firma {
namespace {

struct Seen {
    std::set<std::pair<const Block*, std::uint32_t>> facets;

    static bool look(LaneQuery& query, const FaceLanes& lanes, std::uint32_t lane) {
        static_cast<Seen*>(query.whose)->facets.emplace(lanes.block, lanes.slot[lane]);
        return false;
    }
};

/// What a kernel looks at that is reached by `latest`.
Seen seen_by(const LaneKernel& kernel, const World& world, const LaneSweep& lanes, bool front_only, double latest) {
    Seen seen;
    for (const Node* root : indices_of(world.data())) {
        if (!root) continue;
        LaneQuery query{lanes, front_only, latest, &seen, Seen::look, {}};
        EXPECT_FALSE(kernel.sweep(*root, query));
    }
    return seen;
}

class SweepLanes : public testing::TestWithParam<std::size_t> {};

TEST_P(SweepLanes, LookAtAllThatIsMet) {
    const scenes::CastFamily& family = scenes::cast_families()[GetParam()];
    std::size_t touched = 0, looked_at = 0, asked = 0;
    for (std::uint64_t index = 0; touched < test::sample(1000) && index < 2000; ++index) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 31, index);
        const World world = make_world(scenes::level_of(scene.polygons, scene.two_sided)).value();
        for (const scenes::CastQuery& query : scene.casts) {
            Sweep sweep;
            if (make_sweep(query.sphere, query.path, sweep) != Status::kHit) continue;
            const LaneSweep lanes(sweep);
            if (!lanes.usable) continue;
            for (const Sides sides : {Sides::kFront, Sides::kBoth}) {
                const bool front_only = sides == Sides::kFront;
                const auto check = [&](const Block& block) {
                    for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) {
                        const FaceShape shape(block, block.faces[slot]);
                        if (!shape.polygon.has_area()) continue;
                        const Sides of_face = block.faces[slot].two_sided ? Sides::kBoth : sides;
                        const Contact contact = cast_sweep_polygon(sweep, shape.polygon, of_face, sweep.end);
                        if (!contact.touched()) continue;
                        ++touched;
                        for (const LaneKernel& kernel : lane_kernels()) {
                            const Seen seen = seen_by(kernel, world, lanes, front_only, contact.t);
                            ASSERT_TRUE(seen.facets.count({&block, slot}))
                                << kernel.name << " " << family.name << " scene " << index << " slot " << slot << " at "
                                << contact.t << " of " << sweep.end << " radius " << sweep.radius;
                        }
                    }
                };
                for (const Node* root : indices_of(world.data()))
                    if (root) for_each_block(*root, check);
                looked_at += seen_by(lane_kernels()[0], world, lanes, front_only, sweep.end).facets.size();
                asked += world.face_count();
            }
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(touched, 0u);
    EXPECT_LT(looked_at, asked) << "nothing is left out";
}

INSTANTIATE_TEST_SUITE_P(Families, SweepLanes, testing::Range(std::size_t(0), scenes::cast_families().size()),
                         [](const auto& of) { return std::string(scenes::cast_families()[of.param].name); });

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Casts eight triangles at a time: every kernel that this processor runs looks at each facet that is met, in one order,
// and the answers are those of casts one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cast/cast_capsule_polygon.h"
#include "cast/cast_hull_polygon.h"
#include "cast/cast_sphere_polygon.h"
#include "firma/brush_world.h"
#include "firma/capsule.h"
#include "firma/carve.h"
#include "firma/hull.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/cast_families.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"
#include "solid/face_shape.h"
#include "tests/every_kernel.h"
#include "tests/sample.h"
#include "tests/world/any_shape.h"
#include "tests/world/hit_bits.h"
#include "world/sweep_lanes.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// What a kernel looks at: how often, and whether it is at one facet.
struct FacetsSeen {
    const Block* block = nullptr;
    std::uint32_t slot = 0;
    std::size_t count = 0;
    bool found = false;

    static bool look(LaneQuery& query, const FaceLanes& lanes, std::uint32_t lane) {
        auto& seen = *static_cast<FacetsSeen*>(query.whose);
        ++seen.count;
        seen.found = seen.found || (lanes.block == seen.block && lanes.slot(lane) == seen.slot);
        return false;
    }
};

/// What is reached by `latest`.
void look_by(const LaneKernel& kernel, const World& world, const LaneSweep& lanes, bool front_only, double latest,
             FacetsSeen& seen) {
    for (const Node* root : indices_of(world.data())) {
        if (!root) continue;
        LaneQuery query(lanes, front_only, latest, &seen, FacetsSeen::look);
        EXPECT_FALSE(kernel.sweep(*root, query));
    }
}

class SweepLanes : public testing::TestWithParam<std::size_t> {};

/// Asked for all up to the very time at which a facet is touched.
TEST_P(SweepLanes, LookAtAllThatIsMet) {
    if (lane_kernels().empty()) GTEST_SKIP() << "compiled without lanes";
    const scenes::CastFamily& family = scenes::cast_families()[GetParam()];
    const std::size_t enough = std::size_t(test::sample(1000));
    std::size_t touched = 0, looked_at = 0, asked = 0;
    for (std::uint64_t index = 0; touched < enough && index < 30; ++index) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 31, index);
        const World world = make_world(scenes::level_of(scene.polygons, scene.two_sided)).value();
        // A few of each scene's casts.
        for (std::size_t k = index % 3; k < scene.casts.size(); k += 3) {
            const scenes::CastQuery& query = scene.casts[k];
            Sweep sweep;
            if (make_sweep(query.sphere, query.path, sweep) != Status::kHit) continue;
            LaneSweep lanes(sweep);
            if (!lanes.usable) continue;
            const Sides sides = k % 2 ? Sides::kFront : Sides::kBoth;
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
                        FacetsSeen seen{&block, slot};
                        look_by(kernel, world, lanes, front_only, contact.t, seen);
                        ASSERT_TRUE(seen.found)
                            << kernel.name << " " << family.name << " scene " << index << " slot " << slot << " at "
                            << contact.t << " of " << sweep.end << " radius " << sweep.radius;
                    }
                }
            };
            for (const Node* root : indices_of(world.data()))
                if (root) for_each_block(*root, check);
            if (HasFatalFailure()) return;
            FacetsSeen all;
            look_by(lane_kernels()[0], world, lanes, front_only, sweep.end, all);
            looked_at += all.count;
            asked += world.face_count();
        }
    }
    EXPECT_GT(touched, 0u);
    EXPECT_LT(looked_at, asked) << "nothing is left out";
}

/// The same of capsules, boxes and hulls, which lanes know by what is around them.
TEST_P(SweepLanes, LookAtAllThatShapesMeet) {
    if (lane_kernels().empty()) GTEST_SKIP() << "compiled without lanes";
    const scenes::CastFamily& family = scenes::cast_families()[GetParam()];
    scenes::Rng rng(GetParam());
    const std::size_t enough = std::size_t(test::sample(500));
    std::size_t touched = 0, looked_at = 0, looked_at_by_ball = 0;
    for (std::uint64_t index = 0; touched < enough && index < 30; ++index) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 37, index);
        const World world = make_world(scenes::level_of(scene.polygons, scene.two_sided)).value();
        for (std::size_t k = index % 3; k < scene.casts.size(); k += 3) {
            const scenes::CastQuery& query = scene.casts[k];
            const double size = query.sphere.radius > 1e-6 && query.sphere.radius < 1e6 ? query.sphere.radius : 0.5;
            const AnyShape shape(rng, query.sphere.centre, size);
            Sweep sweep;
            if (make_sweep(shape.around(query.sphere.centre), query.path, sweep) != Status::kHit) continue;
            LaneSweep lanes(sweep, shape.extent()), ball(sweep);
            if (!lanes.usable) continue;
            const Sides sides = k % 2 ? Sides::kFront : Sides::kBoth;
            const bool front_only = sides == Sides::kFront;
            const auto check = [&](const Block& block) {
                for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) {
                    const FaceShape face(block, block.faces[slot]);
                    if (!face.polygon.has_area()) continue;
                    const Sides of_face = block.faces[slot].two_sided ? Sides::kBoth : sides;
                    const Contact contact = shape.against(sweep, face.polygon, of_face);
                    if (!contact.touched()) continue;
                    ++touched;
                    for (const LaneKernel& kernel : lane_kernels()) {
                        FacetsSeen seen{&block, slot};
                        look_by(kernel, world, lanes, front_only, contact.t, seen);
                        ASSERT_TRUE(seen.found)
                            << kernel.name << " " << family.name << " scene " << index << " slot " << slot << " at "
                            << contact.t << " of " << sweep.end << " axes " << lanes.axes << " radius " << lanes.radius;
                    }
                }
            };
            for (const Node* root : indices_of(world.data()))
                if (root) for_each_block(*root, check);
            if (HasFatalFailure()) return;
            FacetsSeen all, by_ball;
            look_by(lane_kernels()[0], world, lanes, front_only, sweep.end, all);
            look_by(lane_kernels()[0], world, ball, front_only, sweep.end, by_ball);
            looked_at += all.count;
            looked_at_by_ball += by_ball.count;
        }
    }
    EXPECT_GT(touched, 0u);
    EXPECT_LE(looked_at, looked_at_by_ball + looked_at_by_ball / 50);  // of slivers rounding leaves as many
}

INSTANTIATE_TEST_SUITE_P(Families, SweepLanes, testing::Range(std::size_t(0), scenes::cast_families().size()),
                         [](const auto& of) { return std::string(scenes::cast_families()[of.param].name); });

struct AnyCast {
    Sphere sphere;
    Vec3 path;
    CastOptions options;
};

std::vector<AnyCast> casts_in(const World& world, int count, std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Box bounds = world.bounds();
    std::vector<AnyCast> casts;
    for (int k = 0; k < count; ++k) {
        AnyCast it;
        for (int axis = 0; axis < 3; ++axis)
            it.sphere.centre[axis] = rng.uniform(bounds.low[axis] - 1, bounds.high[axis] + 1);
        it.sphere.radius = rng.chance(0.4) ? 0 : rng.uniform(0.001, 0.8);
        const Vec3 direction = rng.direction();
        it.path = direction * (rng.chance(0.5) ? rng.uniform(0.01, 1) : rng.uniform(1, 60));
        if (rng.chance(0.2)) it.path[int(rng.below(3))] = 0;
        it.options.sides = rng.chance(0.5) ? Sides::kFront : Sides::kBoth;
        it.options.room = world.room_count() > 1 && rng.chance(0.6) ? kLocateRoom : kAnyRoom;
        casts.push_back(it);
    }
    return casts;
}

/// Two kinds of answers: what every way of casting gives alike, and what only the lanes do, as it follows from the
/// order in which they look.
struct KernelAnswers {
    std::vector<std::uint64_t> hits, of_order;
    CastCounts counts;
};

KernelAnswers answers_of(const World& world, const std::vector<AnyCast>& casts) {
    KernelAnswers answers;
    std::vector<Hit> all;
    for (const AnyCast& it : casts) {
        RoomId rooms[8];
        RoomTrail trail{.rooms = rooms};
        CastOptions options = it.options;
        options.counts = &answers.counts;
        options.trail = &trail;
        add_bits(answers.hits, cast(world, it.sphere, it.path, options));
        answers.hits.push_back(trail.count);
        cast_all(world, it.sphere, it.path, all, options);
        answers.hits.push_back(all.size());
        for (const Hit& hit : all) add_bits(answers.hits, hit);
        const Status any = cast_any(world, it.sphere, it.path, options);
        answers.hits.push_back(any == Status::kMiss);
        answers.of_order.push_back(std::uint64_t(any));
        const auto visit = [&](const Hit& hit) {
            add_bits(answers.of_order, hit);
            return hit.fraction;
        };
        cast_each(world, it.sphere, it.path, visit, options);
    }
    return answers;
}

void expect_one_answer(const World& world, const std::string& name, int count) {
    const std::vector<AnyCast> casts = casts_in(world, count, 5);
    std::vector<std::pair<std::string, KernelAnswers>> all;
    test::with_every_kernel([&](const char* kernel) { all.emplace_back(kernel, answers_of(world, casts)); });
    const KernelAnswers& first = all[0].second;
    for (const auto& [kernel, answers] : all) {
        EXPECT_EQ(answers.hits, first.hits) << name << ": " << kernel << " and " << all[0].first;
        if (&answers == &all.back().second) continue;  // one by one
        EXPECT_EQ(answers.of_order, first.of_order) << name << ": " << kernel << " and " << all[0].first;
        EXPECT_EQ(answers.counts.nodes, first.counts.nodes) << name << ": " << kernel;
        EXPECT_EQ(answers.counts.boxes, first.counts.boxes) << name << ": " << kernel;
        EXPECT_EQ(answers.counts.faces, first.counts.faces) << name << ": " << kernel;
        EXPECT_EQ(answers.counts.precise, first.counts.precise) << name << ": " << kernel;
    }
    if (all.size() > 1) {
        EXPECT_LT(first.counts.faces, all.back().second.counts.faces) << name << ": no lanes were in use";
    }
}

TEST(LaneKernels, GiveTheAnswersOfCastsOneByOne) {
    const World hall = make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
    expect_one_answer(hall, "first.obj", test::sample(3000));
    expect_one_answer(make_world(scenes::room_grid({4, 3, 2})).value(), "rooms", test::sample(2000));
    World carved = hall;
    scenes::Rng rng(3);
    const Box bounds = hall.bounds();
    for (int k = 0; k < 12; ++k) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        const Cutter crater = make_crater(CutterShape::kRocky, std::uint64_t(k));
        carved = carve(carved, crater, {.position = at, .scale = rng.uniform(0.5, 2)}).world;
    }
    EXPECT_GT(carved.face_count(), hall.face_count());
    expect_one_answer(carved, "first.obj, carved", test::sample(3000));
}

/// Rays exactly through corners, where several faces are met at one time: lanes leave out all but one of a group.
TEST(LaneKernels, GiveTheLowestIdOfFacesMetAtOneTime) {
    const Level level = read_level(FIRMA_ROOT "/levels/first.obj").value();
    const World hall = make_world(level).value();
    const Cutter crater = make_crater(CutterShape::kRocky, 1);
    const World carved = carve(hall, crater, {.position = to_metres(level.vertices[0]), .scale = 1}).world;
    for (const World& world : {hall, carved})
        test::with_every_kernel([&](const char* kernel) {
            scenes::Rng rng(11);
            std::vector<Hit> all;
            int ties = 0;
            for (int k = 0; k < test::sample(2000); ++k) {
                const Vec3 corner = to_metres(level.vertices[rng.below(std::uint32_t(level.vertices.size()))]);
                Vec3 away;
                for (int axis = 0; axis < 3; ++axis) away[axis] = std::round(rng.uniform(-4, 4) * 64) / 64;
                const CastOptions options{.sides = k % 2 ? Sides::kFront : Sides::kBoth};
                const Hit first = cast(world, {corner + away, 0}, away * -2, options);
                cast_all(world, {corner + away, 0}, away * -2, all, options);
                ASSERT_EQ(first.touched(), !all.empty()) << kernel;
                if (all.empty()) continue;
                ASSERT_EQ(first.fraction, all[0].fraction) << kernel;
                ASSERT_EQ(first.face.id, all[0].face.id) << kernel;  // sorted by fraction and id
                ties += all.size() > 1 && all[1].fraction == first.fraction;
            }
            EXPECT_GT(ties, test::sample(2000) / 8) << kernel;
        });
}

TEST(LaneKernels, GiveTheAnswersOfShapesOneByOneInEveryFamily) {
    std::size_t touched = 0;
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 33, 1);
        const World world = make_world(scenes::level_of(scene.polygons, scene.two_sided)).value();
        std::vector<std::vector<std::uint64_t>> all;
        test::with_every_kernel([&](const char*) {
            std::vector<std::uint64_t>& bits = all.emplace_back();
            scenes::Rng rng(7);
            for (const scenes::CastQuery& query : scene.casts) {
                const Vec3& at = query.sphere.centre;
                const double size = query.sphere.radius > 1e-6 && query.sphere.radius < 1e6 ? query.sphere.radius : 0.5;
                const AnyShape shape(rng, at, size);
                for (const Sides sides : {Sides::kFront, Sides::kBoth}) {
                    const Hit hit = shape.cast_through(world, at, query.path, sides);
                    add_bits(bits, hit);
                    touched += bool(hit);
                }
            }
        });
        for (const auto& bits : all) EXPECT_EQ(bits, all[0]) << family.name;
    }
    EXPECT_GT(touched, 1000u);
}

TEST(LaneKernels, GiveTheAnswersOfCastsOneByOneInEveryFamily) {
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 32, 1);
        const World world = make_world(scenes::level_of(scene.polygons, scene.two_sided)).value();
        std::vector<std::vector<std::uint64_t>> all;
        test::with_every_kernel([&](const char*) {
            std::vector<std::uint64_t>& bits = all.emplace_back();
            for (const scenes::CastQuery& query : scene.casts)
                for (const Sides sides : {Sides::kFront, Sides::kBoth})
                    add_bits(bits, cast(world, query.sphere, query.path, {.sides = sides}));
        });
        for (const auto& bits : all) EXPECT_EQ(bits, all[0]) << family.name;
    }
}

/// Far from what it shares its lanes with, floats hold the corners of a triangle of micrometres as one.
TEST(LaneKernels, MeetTrianglesThatAreOnePointInFloat) {
    constexpr std::int32_t kStepsAMetre = std::int32_t(kSurfaceSteps);
    for (const std::int32_t metres : {100, 500, 2000, 5000}) {
        const std::int32_t far = metres * kStepsAMetre;
        std::vector<scenes::GridPolygon> polygons{{{far, far, 0}, {far + 1, far, 0}, {far, far + 1, 0}}};
        for (std::int32_t k = 0; k < 5; ++k)
            polygons.push_back({{-far, -far, -kStepsAMetre * (k + 2)},
                                {far + 8 * kStepsAMetre, -far, 3 * kStepsAMetre},
                                {far + 4 * kStepsAMetre, far + (8 + k) * kStepsAMetre, -3 * kStepsAMetre}});
        const World world = make_world(scenes::level_of(polygons, std::vector<bool>(polygons.size(), true))).value();
        const Sphere sphere{to_metres(GridPoint{far, far, 3 * kStepsAMetre}), 0.5};
        std::vector<std::vector<std::uint64_t>> all;
        test::with_every_kernel([&](const char*) {
            const Hit hit = cast(world, sphere, {0, 0, -4});
            EXPECT_EQ(hit.face.id.value, 0u) << metres;
            add_bits(all.emplace_back(), hit);
        });
        for (const auto& bits : all) EXPECT_EQ(bits, all[0]);
    }
}

/// Of the hundreds of triangles that are in reach of a large sphere where it comes down, few are asked for.
TEST(LaneKernels, LeaveFewFacesToLargeSpheres) {
    const World terrain = make_world(scenes::terrain({.squares = 64})).value();
    const Box bounds = terrain.bounds();
    scenes::Rng rng(23);
    std::vector<AnyCast> casts;
    for (int k = 0; k < 500; ++k) {
        AnyCast it;
        it.sphere.radius = 6;
        it.sphere.centre = {rng.uniform(bounds.low.x, bounds.high.x), 0, 0};
        it.sphere.centre.y = rng.uniform(bounds.low.y, bounds.high.y);
        it.sphere.centre.z = bounds.high.z + 7;
        it.path = rng.direction() * 4;
        it.path.z = bounds.low.z - bounds.high.z - 8;
        casts.push_back(it);
    }
    std::vector<std::vector<std::uint64_t>> all;
    std::vector<std::size_t> asked;
    test::with_every_kernel([&](const char*) {
        CastCounts counts;
        std::vector<std::uint64_t>& bits = all.emplace_back();
        for (const AnyCast& it : casts) add_bits(bits, cast(terrain, it.sphere, it.path, {.counts = &counts}));
        asked.push_back(counts.faces);
    });
    for (const auto& bits : all) EXPECT_EQ(bits, all[0]);
    for (std::size_t k = 0; k + 1 < asked.size(); ++k) EXPECT_LT(asked[k], 15 * casts.size()) << "of kernel " << k;
    EXPECT_GT(asked.back(), 100 * casts.size()) << "one by one";
}

/// The path runs within a triangle's plane, which is decided apart, and through another before.
TEST(LaneKernels, TellNothingAfterTheLast) {
    const auto point = [](int x, int y, int z) {
        return GridPoint{x * int(kSurfaceSteps), y * int(kSurfaceSteps), z * int(kSurfaceSteps)};
    };
    const scenes::GridPolygon across{point(3, 0, -5), point(3, 10, -5), point(3, 5, 5)},
        along{point(0, 0, 0), point(20, 0, 0), point(20, 20, 0)};
    for (const bool along_first : {false, true}) {
        const std::vector<scenes::GridPolygon> faces{along_first ? along : across, along_first ? across : along};
        const World world = make_world(scenes::level_of(faces, {true, true})).value();
        test::with_every_kernel([&](const char* kernel) {
            std::vector<double> told;
            const auto visit = [&](const Hit& hit) {
                told.push_back(hit.fraction);
                return hit.fraction;
            };
            cast_each(world, {{-1, 5, 0}, 0}, {50, 0, 0}, visit, {.sides = Sides::kBoth});
            ASSERT_FALSE(told.empty()) << kernel;
            EXPECT_EQ(told.back(), 0.08) << kernel;
            EXPECT_TRUE(std::is_sorted(told.rbegin(), told.rend())) << kernel;
        });
    }
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// What capsules and hulls overlap in a world: the faces that the pair functions say, and how to get out of each.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "firma/capsule.h"
#include "firma/hull.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/cast_families.h"
#include "scenes/divided_building.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::Rng;

Hull hull_of_size(Rng& rng, double size) {
    if (rng.chance(0.5)) {
        const Vec3 x = rng.direction(), aside = cross(x, rng.direction()), y = aside * (1 / length(aside));
        return make_box(Vec3{1, rng.uniform(0.3, 1), rng.uniform(0.3, 1)} * (0.57 * size), {x, y, cross(x, y)}).value();
    }
    std::vector<Vec3> points{{0, 0, 0}};
    for (int k = 6 + int(rng.below(8)); k > 0; --k) points.push_back(rng.direction() * size);
    return make_hull(points).value();
}

/// Ids of the faces of which `meets` says so, in order.
template <class Meets>
std::vector<FaceId> met_of_all(const World& world, const Meets& meets) {
    std::vector<FaceId> met;
    each_face(world, [&](const FaceView& face) {
        if (meets(face.corners)) met.push_back(face.ref().id);
        return true;
    });
    std::sort(met.begin(), met.end());
    return met;
}

std::vector<FaceId> faces_of(const std::vector<Overlap>& found) {
    std::vector<FaceId> faces;
    for (const Overlap& one : found) faces.push_back(one.face.id);
    return faces;
}

TEST(OverlapShapes, FindTheFacesThatThePairFunctionsSay) {
    Rng rng(4);
    std::size_t met = 0, out_of_solid = 0;
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 13, 0);
        const World world = make_world(scenes::level_of(scene.polygons, scene.two_sided)).value();
        for (std::size_t k = 0; k < scene.casts.size(); k += 2) {
            const Vec3& at = scene.casts[k].sphere.centre;
            if (!(max_abs(at) < 1e5)) continue;
            const double size = std::clamp(scene.casts[k].sphere.radius, 0.01, 10.0);
            const Hull hull = hull_of_size(rng, size);
            const double half = rng.uniform(0, 0.8) * size;
            const Capsule capsule = make_capsule(at, rng.direction(), half, size - half);
            std::vector<Overlap> found;
            const Status status = overlap(world, hull, at, found);
            EXPECT_EQ(status, found.empty() ? Status::kMiss : Status::kInitialOverlap);
            EXPECT_EQ(faces_of(found), met_of_all(world, [&](const auto& face) { return overlap(hull, at, face); }))
                << family.name;
            for (const Overlap& one : found) {
                ++met;
                const auto face = world.face(one.face).value();
                const bool behind = one.direction == face.normal && !face.two_sided;
                out_of_solid += behind;
                const double more = 1e-9 * (1 + size) + 1e-12 * max_abs(at);
                EXPECT_FALSE(overlap(hull, at + one.direction * (one.depth + more), face.corners)) << family.name;
                EXPECT_LE(closest_point(one.point, face.corners).distance, more);
            }
            const Status of_capsule = overlap(world, capsule, found);
            EXPECT_EQ(of_capsule, found.empty() ? Status::kMiss : Status::kInitialOverlap);
            EXPECT_EQ(faces_of(found), met_of_all(world, [&](const auto& face) { return overlap(capsule, face); }))
                << family.name;
            for (const Overlap& one : found) {
                ++met;
                const auto face = world.face(one.face).value();
                const double more = 1e-9 * (1 + size) + 1e-12 * max_abs(at);
                const Vec3 moved = one.direction * (one.depth + more);
                EXPECT_FALSE(overlap(Capsule(capsule.from + moved, capsule.to + moved, capsule.radius), face.corners))
                    << family.name;
                EXPECT_LE(closest_point(one.point, face.corners).distance, more);
            }
        }
    }
    EXPECT_GT(met, 1000u);
    EXPECT_GT(out_of_solid, 50u);
}

TEST(OverlapShapes, CapsulesWithoutLengthAnswerAsSpheres) {
    const scenes::DividedBuilding building({.jitter = 0.2, .closed = 0.5, .seed = 4});
    const World world = assemble_world(building.parts()).value();
    Rng rng(9);
    std::size_t faces = 0, portals = 0;
    for (int k = 0; k < 500; ++k) {
        const double size = rng.uniform(0.1, 2);
        const Vec3 at = building.point_in_air(0.05, rng);
        const NearOptions options{.room = rng.chance(0.5) ? locate(world, at).room : kAnyRoom};
        std::vector<Overlap> found, expected;
        const Status status = overlap(world, Capsule(at, at, size), found, options);
        EXPECT_EQ(status, overlap(world, Sphere{at, size}, expected, options));
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].face, expected[i].face);
            EXPECT_EQ(found[i].portal, expected[i].portal);
            EXPECT_EQ(found[i].direction, expected[i].direction);
            EXPECT_EQ(found[i].depth, expected[i].depth);
            faces += found[i].face.valid();
            portals += found[i].portal.valid();
        }
    }
    EXPECT_GT(faces, 100u);
    EXPECT_GT(portals, 10u);
}

TEST(OverlapShapes, FindClosedPortals) {
    const scenes::DividedBuilding building({.jitter = 0.2, .closed = 0.6, .seed = 5});
    const World world = assemble_world(building.parts()).value();
    Rng rng(10);
    std::size_t portals = 0;
    for (int k = 0; k < 500; ++k) {
        const Vec3 at = building.point_in_air(0.05, rng);
        const double size = rng.uniform(0.3, 2);
        const Hull hull = hull_of_size(rng, size);
        const Capsule capsule = make_capsule(at, rng.direction(), size / 2, size / 2);
        std::vector<Overlap> of_hull, of_capsule;
        overlap(world, hull, at, of_hull);
        overlap(world, capsule, of_capsule);
        for (std::uint32_t number = 0; number < portal_count(world); ++number) {
            const PortalId portal{number};
            const bool closed = !portal_info(world, portal)->open;
            const auto has = [&](const std::vector<Overlap>& found) {
                return std::any_of(found.begin(), found.end(),
                                   [&](const Overlap& one) { return one.portal == portal; });
            };
            bool hull_meets = false, capsule_meets = false;
            for (const std::vector<Vec3>& polygon : portal_polygons(world, portal)) {
                hull_meets = hull_meets || overlap(hull, at, polygon);
                capsule_meets = capsule_meets || overlap(capsule, polygon);
            }
            EXPECT_EQ(has(of_hull), closed && hull_meets);
            EXPECT_EQ(has(of_capsule), closed && capsule_meets);
            portals += has(of_hull) + has(of_capsule);
        }
    }
    EXPECT_GT(portals, 50u);
}

TEST(OverlapShapes, LeadOutOfTheSolidFromBehind) {
    const World world =
        make_world(scenes::level_of(std::vector<scenes::GridPolygon>{{{0, 0, 0}, {262144, 0, 0}, {0, 262144, 0}}}))
            .value();
    std::vector<Overlap> found;
    ASSERT_EQ(overlap(world, make_box({0.5, 0.5, 0.5}).value(), {0.1, 0.1, -0.25}, found), Status::kInitialOverlap);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].direction, (Vec3{0, 0, 1}));
    EXPECT_EQ(found[0].depth, 0.75);
    ASSERT_EQ(overlap(world, Capsule({0.1, 0.1, -2}, {0.1, 0.1, 0.5}, 0.25), found), Status::kInitialOverlap);
    EXPECT_EQ(found[0].direction, (Vec3{0, 0, 1}));
    EXPECT_EQ(found[0].depth, 2.25);
    EXPECT_EQ(found[0].distance, 0);
    // From the front the shorter way: across the rim.
    ASSERT_EQ(overlap(world, Capsule({0.1, 0.2, -1}, {0.1, 0.2, 2}, 0.25), found), Status::kInitialOverlap);
    EXPECT_EQ(found[0].direction, (Vec3{-1, 0, 0}));
    EXPECT_NEAR(found[0].depth, 0.35, 1e-15);
    EXPECT_EQ(overlap(world, Hull(), {0, 0, 0}, found), Status::kInvalid);
    EXPECT_TRUE(found.empty());
    EXPECT_EQ(overlap(world, make_box({1, 1, 1}).value(), {0, 0, NAN}, found), Status::kInvalid);
    EXPECT_EQ(overlap(world, make_box({1, 1, 1}).value(), {0, 0, 0}, found, {.room = {9}}), Status::kInvalid);
    EXPECT_EQ(overlap(world, Capsule({0, 0, 0}, {0, 0, 1}, -1), found), Status::kInvalid);
    EXPECT_EQ(overlap(world, Capsule({0, 0, 0}, {0, 0, 1}, 1), found, {.mask = 0}), Status::kMiss);
}

}  // namespace
}  // namespace firma

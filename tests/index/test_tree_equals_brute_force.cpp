// SPDX-License-Identifier: MIT
// Through any tree the answer is the one of all faces in turn, to the bit: trees only leave out, and so do lanes, on
// every kind of processor.
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "firma/level.h"
#include "firma/polygon.h"
#include "firma/queries.h"
#include "firma/world.h"
#include "scenes/cast_families.h"
#include "scenes/closed_meshes.h"
#include "tests/every_kernel.h"
#include "tests/source_of.h"

namespace {

using namespace firma;

/// Smallest fraction, then lowest face.
PolygonHit brute_force(const std::vector<std::vector<Vec3>>& polygons, const std::vector<bool>& two_sided,
                       const scenes::CastQuery& query, Sides sides, std::uint32_t& face) {
    PolygonHit best;
    best.centre = query.sphere.centre + query.path;
    for (std::uint32_t f = 0; f < polygons.size(); ++f) {
        const bool both = f < two_sided.size() && two_sided[f];
        const PolygonHit hit = cast_polygon(query.sphere, query.path, polygons[f], both ? Sides::kBoth : sides);
        if (hit.status == Status::kInvalid) return hit;
        if (!hit.touched() || (best.touched() && best.fraction <= hit.fraction)) continue;
        best = hit;
        face = f;
    }
    return best;
}

bool same(const PolygonHit& a, const PolygonHit& b) {
    return a.status == b.status && a.feature == b.feature && a.feature_index == b.feature_index &&
           std::bit_cast<std::uint64_t>(a.fraction) == std::bit_cast<std::uint64_t>(b.fraction) &&
           a.centre == b.centre && a.point == b.point && a.normal == b.normal && a.face_normal == b.face_normal;
}

std::vector<WorldOptions> all_options() {
    std::vector<WorldOptions> all;
    for (const Split split : {Split::kLongestAxis, Split::kSurfaceArea}) {
        all.push_back({{split, 48, 4, 0}, {}});
        all.push_back({{split, 64, 1, 0}, {}});
        all.push_back({{split, 0, 4, 0}, {}});
        all.push_back({{split, 2, 1, 0}, {}});
        all.push_back({{split, -5, 0, -1}, {}});
        all.push_back({{split, 1000, 1000000, 0}, {}});
        all.push_back({{split, 48, 1, 1e9}, {}});
        all.push_back({{split, 48, 1, 0.5}, {}});
    }
    return all;
}

void compare(const scenes::CastScene& scene, const std::string& name) {
    std::vector<std::vector<Vec3>> polygons;
    for (const scenes::GridPolygon& polygon : scene.polygons) polygons.push_back(scenes::to_metres(polygon));
    const Level level = scenes::level_of(scene.polygons, scene.two_sided);
    std::vector<World> worlds;
    for (const WorldOptions& options : all_options()) {
        Result<World> world = make_world(level, options);
        ASSERT_TRUE(world.ok()) << name << ": " << world.error().text();
        EXPECT_FALSE(check_world(world.value()).has_value()) << name;
        worlds.push_back(world.value());
    }
    for (std::size_t k = 0; k < scene.casts.size(); ++k) {
        const Sides sides = k % 2 ? Sides::kBoth : Sides::kFront;
        std::uint32_t face = 0;
        const PolygonHit expected = brute_force(polygons, scene.two_sided, scene.casts[k], sides, face);
        for (std::size_t w = 0; w < worlds.size(); ++w) {
            CastOptions options;
            options.sides = sides;
            test::with_every_kernel([&](const char* kernel) {
                const Hit hit = cast(worlds[w], scene.casts[k].sphere, scene.casts[k].path, options);
                ASSERT_TRUE(same(hit, expected))
                    << name << ", cast " << k << ", options " << w << ", " << kernel << ": fraction " << hit.fraction
                    << ", all faces " << expected.fraction;
                if (hit.touched()) {
                    ASSERT_EQ(source_of(worlds[w], hit), face) << name << ", cast " << k << ", options " << w;
                }
            });
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

TEST(TreeEqualsBruteForce, OnEveryFamily) {
    for (const scenes::CastFamily& family : scenes::cast_families())
        for (std::uint64_t index = 0; index < 3; ++index)
            compare(scenes::make_cast_scene(family, 31, index), std::string(family.name) + " " + std::to_string(index));
}

TEST(TreeEqualsBruteForce, OnClosedMeshes) {
    scenes::Rng rng(5);
    for (int kind = 0; kind < scenes::kMeshKinds; ++kind) {
        const scenes::ClosedMesh mesh = scenes::make_closed_mesh(scenes::MeshKind(kind), rng);
        scenes::CastScene scene;
        scene.polygons = mesh.faces;
        for (int k = 0; k < 60; ++k) scene.casts.push_back(scenes::escaping_cast(mesh, k % 2 == 0, rng));
        compare(scene, scenes::name_of(mesh.kind));
    }
}

// Enough faces for blocks of blocks.
TEST(TreeEqualsBruteForce, OnManyFaces) {
    scenes::Rng rng(17);
    scenes::CastScene scene;
    for (int k = 0; k < 9000; ++k) {
        const scenes::Steps centre = scenes::random_steps(rng, 40 * scenes::kMetre);
        scene.polygons.push_back(
            scenes::random_triangle(rng, centre, scenes::kMetre * (k % 100 ? 1 : 30), scenes::kInput));
    }
    for (int k = 0; k < 150; ++k) {
        const Vec3 start{rng.uniform(-60, 60), rng.uniform(-60, 60), rng.uniform(-60, 60)};
        scene.casts.push_back({{start, k % 3 ? rng.uniform(0, 2) : 0}, rng.direction() * rng.uniform(0, 120)});
    }
    compare(scene, "many faces");
}

}  // namespace

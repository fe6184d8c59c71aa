// SPDX-License-Identifier: MIT
// What write_glb() wrote, read again.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "cli/write_glb.h"
#include "firma/carve.h"
#include "firma/mesh.h"
#include "firma/save.h"
#include "firma/solid.h"
#include "tests/gltf/read_text.h"

namespace firma::gltf {
namespace {

std::string glb_of(const World& world, int up = 2) {
    std::string bytes;
    cli::write_glb(world, cli::GlbParts(world), up, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

std::string obj_of(const World& world) {
    std::string text;
    EXPECT_TRUE(write_obj(world, [&](std::string_view piece) {
        text += piece;
        return true;
    }));
    return text;
}

World first_level() {
    return make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
}

/// Craters along the floor of our level.
World carved_level(std::uint32_t craters) {
    World world = first_level();
    for (std::uint32_t k = 0; k < craters; ++k) {
        const Pose pose{.position = {12.0 + 2.3 * k, 29, 0.2}, .scale = 0.7 + 0.1 * k};
        const CarveResult result = carve(world, make_crater(CutterShape::kRocky, k + 1), pose, {"fresh"});
        EXPECT_EQ(result.status, CarveStatus::kDone);
        world = result.world;
    }
    return world;
}

using Corners = std::vector<GridPoint>;
using FaceKey = std::tuple<Corners, std::string, bool>;

/// Faces whatever their order and first corner.
std::vector<FaceKey> faces_of(const Level& level) {
    std::vector<FaceKey> faces;
    for (const LevelFace& face : level.faces) {
        Corners corners;
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            corners.push_back(level.vertices[level.corners[face.first_corner + k]]);
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        faces.emplace_back(std::move(corners), level.materials[face.material], face.two_sided);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

TEST(GltfRoundTrip, OurLevelComesBackFaceByFace) {
    const Level level = read_level(FIRMA_ROOT "/levels/first.obj").value();
    const World world = make_world(level).value();
    for (const int up : {0, 1, 2}) {
        const GltfLevel gltf = read_good(glb_of(world, up), {.up = up});
        EXPECT_EQ(faces_of(gltf.level), faces_of(level));
        EXPECT_TRUE(gltf.notes.empty());
        EXPECT_TRUE(gltf.level.notes.empty());
        EXPECT_TRUE(check_gltf(gltf).value().closed());
        const World again = make_world(gltf.level).value();
        EXPECT_EQ(hash_solid(again), hash_solid(world));
        EXPECT_EQ(measure_solid(again).volume, measure_solid(world).volume);
    }
}

TEST(GltfRoundTrip, ACarvedLevelIsThatOfItsObj) {
    const World world = carved_level(10);
    const GltfLevel gltf = read_good(glb_of(world));
    const Level obj = read_obj(obj_of(world), "a.obj").value();
    EXPECT_EQ(faces_of(gltf.level), faces_of(obj));
    EXPECT_TRUE(check_gltf(gltf).value().closed());
    const World again = make_world(gltf.level).value();
    EXPECT_EQ(hash_solid(again), hash_solid(make_world(obj).value()));
    EXPECT_FALSE(check_world(again));
}

TEST(GltfRoundTrip, WhatIsReadCanBeCarvedAgain) {
    const World world = carved_level(1);
    const World again = make_world(read_good(glb_of(world)).level).value();
    EXPECT_NEAR(measure_solid(again).volume, measure_solid(world).volume, 0.01);
    const CarveResult more = carve(again, make_crater(CutterShape::kDrill, 5), {.position = {20, 29, 0.2}}, {"fresh"});
    EXPECT_EQ(more.status, CarveStatus::kDone);
    EXPECT_TRUE(check_gltf(read_good(glb_of(more.world))).value().closed());
}

TEST(GltfRoundTrip, NamesAndSides) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
    const std::vector<std::uint32_t> corners{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}, materials{0, 1, 0, 2};
    const std::vector<std::string> names{"a", "", "gr\xC3\xBC\xC3\x9F"};
    const std::vector<std::uint8_t> two_sided{0, 1, 1, 0};
    Mesh mesh;
    mesh.vertices = vertices;
    mesh.corners = corners;
    mesh.materials = materials;
    mesh.material_names = names;
    mesh.two_sided = two_sided;
    const Level level = level_from_mesh(mesh, "a.glb").value();
    EXPECT_EQ(faces_of(read_good(glb_of(make_world(level).value())).level), faces_of(level));
}

TEST(GltfRoundTrip, AnEmptyWorldIsNoLevel) {
    EXPECT_EQ(error_of(glb_of(World())), "a.glb: has no triangle in its scene");
}

}  // namespace
}  // namespace firma::gltf

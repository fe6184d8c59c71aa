// SPDX-License-Identifier: MIT
// Nodes that are parts which move: a level each, in a frame of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/read_gltf.h"
#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

/// A box as mesh 0, from (0, -3, 0) to (2, 0, 1) in the level, and nodes.
GltfLevel boxes(const std::string& nodes, const std::string& roots, const GltfOptions& options = {}) {
    SmallGltf file = box_file();
    file.nodes = nodes;
    file.scenes = R"({"nodes":[)" + roots + "]}";
    return read_good(file.text(), options);
}

Box bounds_of_part(const GltfPart& part) {
    Box box;
    for (const GridPoint& vertex : part.level.vertices) box.add(to_metres(vertex));
    return box;
}

TEST(GltfParts, ANodeOfItsOwnFrame) {
    const GltfLevel gltf =
        boxes(R"({"mesh":0},{"mesh":0,"name":"lift","translation":[8,3,0],"extras":{"part":true}})", "0,1");
    EXPECT_EQ(gltf.level.source_faces, 12u);
    EXPECT_EQ(gltf.nodes.size(), 2u);
    ASSERT_EQ(gltf.parts.size(), 1u);
    const GltfPart& lift = gltf.parts[0];
    EXPECT_EQ(lift.name, "lift");
    EXPECT_EQ(lift.node, 1u);
    EXPECT_EQ(lift.position, (Vec3{8, 0, 3}));
    EXPECT_EQ(lift.rotation, (Quaternion{0, 0, 0, 1}));
    EXPECT_EQ(lift.level.source_faces, 12u);
    EXPECT_EQ(bounds_of_part(lift), (Box{{0, -3, 0}, {2, 0, 1}}));
    const World world = make_world(lift.level).value();
    EXPECT_EQ(world.bounds().high, (Vec3{2, 0, 1}));
}

TEST(GltfParts, WhoIsOne) {
    const auto parts = [](const std::string& node, const GltfOptions& options = {}) {
        return boxes(R"({"mesh":0},)" + node, "0,1", options).parts.size();
    };
    EXPECT_EQ(parts(R"({"mesh":0,"name":"part"})"), 0u);
    EXPECT_EQ(parts(R"({"mesh":0,"extras":{"firma_part":1}})"), 1u);
    EXPECT_EQ(parts(R"({"mesh":0,"name":"gate"})", {.parts = {"gate"}}), 1u);
    EXPECT_EQ(parts(R"({"mesh":0,"name":"gate","extras":{"part":false}})", {.parts = {"gate"}}), 0u);
    EXPECT_EQ(parts(R"({"mesh":0,"extras":{"part":"maybe"}})"), 0u);
    EXPECT_EQ(parts(R"({"name":"empty","extras":{"part":true}})"), 0u);
}

TEST(GltfParts, OneWithoutANameHasThatAboveItOrNone) {
    const GltfLevel alone = boxes(R"({"mesh":0,"name":"room"},{"mesh":0,"extras":{"part":true}})", "0,1");
    ASSERT_EQ(alone.parts.size(), 1u);
    EXPECT_EQ(alone.parts[0].name, "");
    const GltfLevel below =
        boxes(R"({"mesh":0,"name":"room"},{"name":"gate","children":[2]},{"mesh":0,"extras":{"part":true}})", "0,1");
    ASSERT_EQ(below.parts.size(), 1u);
    EXPECT_EQ(below.parts[0].name, "gate");
}

TEST(GltfParts, WhatIsBelowComesAlongButForPartsThere) {
    const GltfLevel gltf = boxes(
        R"({"mesh":0},{"name":"train","translation":[10,0,0],"extras":{"part":true},"children":[2,3]},)"
        R"({"mesh":0,"translation":[0,5,0]},{"mesh":0,"name":"door","translation":[0,0,4],"extras":{"part":true}})",
        "0,1");
    EXPECT_EQ(gltf.level.source_faces, 12u);
    ASSERT_EQ(gltf.parts.size(), 2u);
    EXPECT_EQ(gltf.parts[0].name, "train");
    EXPECT_EQ(bounds_of_part(gltf.parts[0]), (Box{{0, -3, 5}, {2, 0, 6}}));
    EXPECT_EQ(gltf.parts[1].name, "door");
    EXPECT_EQ(gltf.parts[1].position, (Vec3{10, -4, 0}));
    EXPECT_EQ(bounds_of_part(gltf.parts[1]), (Box{{0, -3, 0}, {2, 0, 1}}));
}

TEST(GltfParts, TurnsAreTheFramesAndScalesTheLevels) {
    // A quarter turn about glTF's y, which is up: z of the level.
    const GltfLevel gltf =
        boxes(R"({"mesh":0},{"mesh":0,"name":"wing","rotation":[0,0.70710678118654752,0,0.70710678118654752],)"
              R"("scale":[3,1,-2],"extras":{"part":true}})",
              "0,1");
    ASSERT_EQ(gltf.parts.size(), 1u);
    const GltfPart& wing = gltf.parts[0];
    EXPECT_NEAR(std::fabs(wing.rotation[2]), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(std::fabs(wing.rotation[3]), std::sqrt(0.5), 1e-12);
    EXPECT_EQ(bounds_of_part(wing), (Box{{0, 0, 0}, {6, 6, 1}}));
    const World world = make_world(wing.level).value();  // wound outward, mirror or not
    EXPECT_EQ(locate(world, {3, 3, 0.5}).where, Where::kSolid);
    // A corner of the file, by node and by frame.
    const TurnMatrix turn = matrix_of(wing.rotation);
    const Vec3 corner = turn * Vec3{6, 5, 1};
    EXPECT_NEAR(std::fabs(corner.x), 5, 1e-12);
    EXPECT_NEAR(std::fabs(corner.y), 6, 1e-12);
}

TEST(GltfParts, TrianglesOfAllCountAgainstTheLimit) {
    SmallGltf file = box_file();
    file.nodes = R"({"mesh":0},{"mesh":0,"extras":{"part":true}})";
    file.scenes = R"({"nodes":[0,1]})";
    GltfOptions options;
    options.max_triangles = 23;
    EXPECT_EQ(read(file.text(), options).error().code, ErrorCode::kTooLarge);
    options.max_triangles = 24;
    EXPECT_TRUE(read(file.text(), options).ok());
}

}  // namespace
}  // namespace firma::gltf

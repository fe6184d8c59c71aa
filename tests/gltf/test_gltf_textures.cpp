// SPDX-License-Identifier: MIT
// TEXCOORD_0: what each triangle's corners say, of single triangles and of fans, wherever a node places them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "firma/carve.h"
#include "firma/read_gltf.h"
#include "firma/triangles.h"
#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

/// A quad in the file's axes, as two triangles that are a fan with one normal.
const std::vector<float> kQuad{0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0};
const std::vector<float> kNormals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
const std::vector<std::uint16_t> kFan{0, 1, 2, 0, 2, 3};

std::string textured(int position, int normal, int uv, int indices) {
    return R"({"attributes":{"POSITION":)" + std::to_string(position) +
           (normal < 0 ? "" : R"(,"NORMAL":)" + std::to_string(normal)) + R"(,"TEXCOORD_0":)" + std::to_string(uv) +
           R"(},"indices":)" + std::to_string(indices) + "}";
}

template <class T>
SmallGltf quad_file(const std::vector<T>& uvs, bool normals, const std::string& extra = "") {
    SmallGltf file;
    const int position = file.vectors(kQuad), normal = normals ? file.vectors(kNormals) : -1;
    const int uv = file.pairs(uvs, extra), indices = file.indices(kFan);
    file.meshes = R"({"primitives":[)" + textured(position, normal, uv, indices) + "]}";
    return file;
}

/// At each corner of each face, the coordinates that the level gives; in the file's order of positions.
void expect_uvs(const GltfLevel& gltf, const std::vector<Vec3>& places, const std::vector<TexturePoint>& uvs) {
    std::size_t met = 0;
    for (const LevelFace& face : gltf.level.faces) {
        ASSERT_NE(face.texture, kNoTexture);
        const TextureProjection& lies = gltf.level.textures.at(face.texture);
        EXPECT_EQ(lies.unit, TextureUnit::kRepeats);
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            const Vec3 corner = to_metres(gltf.level.vertices[gltf.level.corners[face.first_corner + c]]);
            for (std::size_t k = 0; k < places.size(); ++k) {
                if (!(places[k] == corner)) continue;
                ++met;
                EXPECT_NEAR(lies.at(corner)[0], uvs[k][0], 1e-9);
                EXPECT_NEAR(lies.at(corner)[1], uvs[k][1], 1e-9);
            }
        }
    }
    EXPECT_EQ(met, gltf.level.corners.size());
}

const std::vector<Vec3> kPlaces{{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {0, 0, 1}};  // y up became z up

TEST(GltfTextures, EachTriangleHasItsOwnAndAFanOneWhereTheyAgree) {
    const std::vector<float> straight{0, 1, 0.5f, 1, 0.5f, 0, 0, 0}, bent{0, 1, 0.5f, 1, 0.75f, 0, 0, 0};
    for (const bool normals : {false, true}) {
        const GltfLevel flat = read_good(quad_file(straight, normals).text());
        EXPECT_EQ(flat.level.faces.size(), normals ? 1u : 2u);
        expect_uvs(flat, kPlaces, {{0, 1}, {0.5, 1}, {0.5, 0}, {0, 0}});
        const GltfLevel warped = read_good(quad_file(bent, normals).text());
        ASSERT_EQ(warped.level.faces.size(), 2u);
        EXPECT_EQ(warped.level.faces[0].source, 0u);
        EXPECT_EQ(warped.level.faces[1].source, 1u);
        EXPECT_TRUE(warped.level.notes.empty());
        expect_uvs(warped, kPlaces, {{0, 1}, {0.5, 1}, {0.75, 0}, {0, 0}});
    }
}

TEST(GltfTextures, NumbersOfEveryKind) {
    const GltfLevel bytes = read_good(
        quad_file(std::vector<std::uint8_t>{0, 255, 51, 255, 51, 0, 0, 0}, true, R"(,"normalized":true)").text());
    expect_uvs(bytes, kPlaces, {{0, 1}, {0.2, 1}, {0.2, 0}, {0, 0}});
    const GltfLevel shorts = read_good(quad_file(std::vector<std::int16_t>{0, -3, 5, -3, 5, 0, 0, 0}, true).text());
    expect_uvs(shorts, kPlaces, {{0, -3}, {5, -3}, {5, 0}, {0, 0}});
}

TEST(GltfTextures, MirroredPlacesKeepThem) {
    SmallGltf file = quad_file(std::vector<float>{0, 1, 0.5f, 1, 0.5f, 0, 0, 0}, true);
    file.nodes = R"({"mesh":0,"scale":[-1,1,1],"translation":[4,0,0]})";
    expect_uvs(read_good(file.text()), {{4, 0, 0}, {2, 0, 0}, {2, 0, 1}, {4, 0, 1}},
               {{0, 1}, {0.5, 1}, {0.5, 0}, {0, 0}});
}

TEST(GltfTextures, WhatCannotBeReadIsNotThere) {
    const auto expect_none = [](const SmallGltf& file, bool noted) {
        const GltfLevel gltf = read_good(file.text());
        for (const LevelFace& face : gltf.level.faces) EXPECT_EQ(face.texture, kNoTexture);
        EXPECT_EQ(gltf.notes.size(), noted ? 1u : 0u);
        for (const std::string& note : gltf.notes)
            EXPECT_EQ(note, "texture coordinates that cannot be read are left out");
    };
    expect_none(quad_file(std::vector<float>{0, 1, 0.5f, 1, 0.5f, 0}, true), true);  // three for four
    expect_none(quad_file(std::vector<float>{0, NAN, 0.5f, 1, 0.5f, 0, 0, 0}, true), false);
    SmallGltf file;
    const int position = file.vectors(kQuad), indices = file.indices(kFan);
    file.meshes = R"({"primitives":[)" + textured(position, -1, position, indices) + "]}";  // vectors of three
    expect_none(file, true);
    file.meshes = R"({"primitives":[)" + textured(position, -1, 77, indices) + "]}";
    expect_none(file, true);
}

/// A closed box whose sides have the file's x and z as their coordinates, cut.
TEST(GltfTextures, StayThroughCuts) {
    SmallGltf file;
    const std::vector<float> corners = box_corners(8, 8, 8);
    std::vector<float> uvs;
    for (std::size_t k = 0; k < corners.size(); k += 3) uvs.insert(uvs.end(), {corners[k] / 8, corners[k + 2] / 4});
    const int positions = file.vectors(corners), uv = file.pairs(uvs), indices = file.indices(box_triangles());
    file.meshes = R"({"primitives":[)" + textured(positions, -1, uv, indices) + "]}";
    const World box = make_world(read_good(file.text(), {.up = 1})).value();
    const World cut = carve(box, make_crater(CutterShape::kRocky, 2), {.position = {4, 8, 4}, .scale = 2}).world;
    ASSERT_EQ(cut.solid().edits(), 1u);
    const TriangleMesh made = triangles_of(cut, {.uvs = true});
    std::size_t of_file = 0;
    for (const TriangleMesh::Source& source : made.sources) {
        if (source.source_edit != 0) continue;
        ++of_file;
        EXPECT_EQ(source.uv_unit, TextureUnit::kRepeats);
        for (std::uint32_t v = source.first_vertex; v < source.first_vertex + source.vertex_count; ++v) {
            EXPECT_NEAR(made.uvs[v][0], made.positions[v][0] / 8, 1e-5);
            EXPECT_NEAR(made.uvs[v][1], made.positions[v][2] / 4, 1e-5);
        }
    }
    EXPECT_GT(of_file, 15u);
}

}  // namespace
}  // namespace firma::gltf

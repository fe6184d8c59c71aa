// SPDX-License-Identifier: MIT
// Small files by hand, one for each thing that glTF can say.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "firma/level.h"
#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

Box box(const Vec3& low, const Vec3& high) {
    Box made;
    made.add(low);
    made.add(high);
    return made;
}

TEST(ReadGltf, ABoxInBothForms) {
    for (const std::string& file : {box_file().text(), box_file().glb()}) {
        const GltfLevel gltf = read_good(file);
        EXPECT_EQ(gltf.level.faces.size(), 12u);
        EXPECT_EQ(gltf.level.vertices.size(), 8u);
        EXPECT_EQ(gltf.level.source_faces, 12u);
        EXPECT_EQ(volume_of(gltf), 6);
        EXPECT_EQ(bounds_of(gltf), box({0, -3, 0}, {2, 0, 1}));  // y up became z up
        EXPECT_TRUE(gltf.notes.empty());
        EXPECT_TRUE(gltf.portals.empty());
        EXPECT_TRUE(check_gltf(gltf).value().closed());
    }
}

TEST(ReadGltf, AxesAndScale) {
    const std::string file = box_file().text();
    EXPECT_EQ(bounds_of(read_good(file, {.up = 1})), box({0, 0, 0}, {2, 1, 3}));
    EXPECT_EQ(bounds_of(read_good(file, {.up = 0})), box({0, -2, 0}, {1, 0, 3}));
    const GltfLevel half = read_good(file, {.scale = 0.5});
    EXPECT_EQ(bounds_of(half), box({0, -1.5, 0}, {1, 0, 0.5}));
    EXPECT_EQ(volume_of(half), 0.75);
    for (const double scale : {0.0, -1.0, double(NAN), double(INFINITY)})
        EXPECT_NE(error_of(file, {.scale = scale}).find("scale"), std::string::npos);
    EXPECT_NE(error_of(file, {.up = 3}).find("up"), std::string::npos);
}

template <class Index, class Number>
void expect_box(const std::vector<Number>& corners, const std::string& more, double edge) {
    SmallGltf file;
    const int positions = file.vectors(corners, more), indices = file.indices(box_triangles<Index>());
    file.meshes = R"({"primitives":[)" + primitive(positions, indices) + "]}";
    const GltfLevel gltf = read_good(file.glb());
    EXPECT_NEAR(volume_of(gltf), edge * edge * edge, 1e-3);
    EXPECT_EQ(gltf.level.vertices.size(), 8u);
}

template <class T>
std::vector<T> cube(T edge) {
    std::vector<T> corners;
    for (const float x : box_corners(1, 1, 1)) corners.push_back(x > 0 ? edge : T(0));
    return corners;
}

TEST(ReadGltf, EveryComponentType) {
    expect_box<std::uint8_t>(cube<float>(2.5f), "", 2.5);
    expect_box<std::uint16_t>(cube<std::int8_t>(-3), "", -3);  // mirrored by its own numbers: fronts are inside
    expect_box<std::uint32_t>(cube<std::uint8_t>(200), "", 200);
    expect_box<std::uint16_t>(cube<std::int16_t>(1000), "", 1000);
    expect_box<std::uint16_t>(cube<std::uint16_t>(5000), "", 5000);
    expect_box<std::uint16_t>(cube<std::uint32_t>(7), "", 7);
    const std::string normalized = R"(,"normalized":true)";
    expect_box<std::uint16_t>(cube<std::int8_t>(127), normalized, 1);
    expect_box<std::uint16_t>(cube<std::int8_t>(-128), normalized, -1);
    expect_box<std::uint16_t>(cube<std::uint8_t>(51), normalized, 0.2);
    expect_box<std::uint16_t>(cube<std::int16_t>(-32767), normalized, -1);
    expect_box<std::uint16_t>(cube<std::uint16_t>(65535), normalized, 1);
}

TEST(ReadGltf, StripsFansAndNoIndices) {
    SmallGltf file;
    // A pyramid: a fan about the top, a strip below; a triangle without indices left out of the side by its mode.
    const int corners = file.vectors<float>({0, 0, 0, 2, 0, 0, 2, 0, 2, 0, 0, 2, 1, 3, 1});
    const int fan = file.indices<std::uint8_t>({4, 0, 3, 2, 1, 0}), strip = file.indices<std::uint8_t>({0, 1, 3, 2});
    file.meshes = R"({"primitives":[)" + primitive(corners, fan, R"(,"mode":6)") + "," +
                  primitive(corners, strip, R"(,"mode":5)") + "]}";
    const GltfLevel gltf = read_good(file.text());
    EXPECT_EQ(gltf.level.source_faces, 6u);
    EXPECT_EQ(volume_of(gltf), 4);

    SmallGltf plain;
    std::vector<float> positions;
    const std::vector<float> eight = box_corners(1, 1, 1);
    for (const std::uint16_t k : box_triangles())
        for (std::size_t axis = 0; axis < 3; ++axis) positions.push_back(eight[std::size_t(3 * k) + axis]);
    plain.meshes = R"({"primitives":[)" + primitive(plain.vectors(positions), -1) + "]}";
    EXPECT_EQ(volume_of(read_good(plain.text())), 1);
}

TEST(ReadGltf, PointsAndLinesAreCounted) {
    SmallGltf file = box_file();
    std::string primitives;
    for (const int mode : {0, 1, 2, 3}) primitives += "," + primitive(0, 1, R"(,"mode":)" + std::to_string(mode));
    file.meshes = replaced(file.meshes, "]}", primitives + R"(,{"attributes":{}}]})");
    const GltfLevel gltf = read_good(file.text());
    EXPECT_EQ(gltf.level.ignored_entries, 5u);
    EXPECT_EQ(gltf.level.source_faces, 12u);
    ASSERT_EQ(gltf.notes.size(), 1u);
    EXPECT_EQ(gltf.notes[0], "5 primitives of points, lines or nothing are left out");
    ASSERT_EQ(gltf.level.omissions.size(), 1u);
    EXPECT_EQ(gltf.level.omissions[0].what, "primitives of points, lines or nothing");
    EXPECT_EQ(gltf.level.omissions[0].count, 5u);
}

TEST(ReadGltf, StridesAndOffsets) {
    SmallGltf file;
    std::vector<float> mixed{99, 99};  // two floats before, five to a vertex: the position in the middle
    const std::vector<float> eight = box_corners(2, 2, 2);
    for (std::size_t k = 0; k < 8; ++k)
        for (const float x : {eight[3 * k], eight[3 * k + 1], eight[3 * k + 2], -1.0f, -2.0f}) mixed.push_back(x);
    const int view = file.view(bytes_of(mixed), R"(,"byteStride":20)");
    const int positions = file.accessor(R"({"bufferView":)" + std::to_string(view) +
                                        R"(,"byteOffset":8,"componentType":5126,"count":8,"type":"VEC3"})");
    const int indices = file.indices(box_triangles());
    file.meshes = R"({"primitives":[)" + primitive(positions, indices) + "]}";
    EXPECT_EQ(volume_of(read_good(file.glb())), 8);
}

TEST(ReadGltf, SparseAccessors) {
    SmallGltf file;
    const int base = file.view(bytes_of(box_corners(2, 2, 2)));
    const int which = file.view(bytes_of<std::uint8_t>({4, 5, 6, 7}));
    const int values = file.view(bytes_of<float>({0, 0, 5, 2, 0, 5, 0, 2, 5, 2, 2, 5}));
    const std::string sparse = R"("componentType":5126,"count":8,"type":"VEC3","sparse":{"count":4,"indices":{)"
                               R"("bufferView":)" +
                               std::to_string(which) +
                               R"(,"componentType":5121},"values":{)"
                               R"("bufferView":)" +
                               std::to_string(values) + "}}}";
    const int longer = file.accessor(R"({"bufferView":)" + std::to_string(base) + "," + sparse);
    const int indices = file.indices(box_triangles());
    file.meshes = R"({"primitives":[)" + primitive(longer, indices) + "]}";
    EXPECT_EQ(volume_of(read_good(file.text())), 20);

    // Without a base the others are zero: a flat fan of what is left.
    SmallGltf zeros = file;
    const int spread = zeros.accessor("{" + sparse);
    zeros.meshes = R"({"primitives":[)" + primitive(spread, indices) + "]}";
    const GltfLevel gltf = read_good(zeros.text());
    EXPECT_EQ(bounds_of(gltf), box({0, -5, 0}, {2, 0, 2}));
    EXPECT_GT(gltf.level.count(FaceNote::kNoArea), 0u);
    EXPECT_EQ(gltf.note_places.size(), gltf.level.notes.size());
}

TEST(ReadGltf, NodesPlaceMeshes) {
    const auto placed = [](const std::string& nodes) {
        SmallGltf file = box_file();
        file.nodes = nodes;
        return read_good(file.text(), {.up = 1});
    };
    GltfLevel gltf = placed(R"({"mesh":0,"translation":[10,20,30],"scale":[2,3,4]})");
    EXPECT_EQ(bounds_of(gltf), box({10, 20, 30}, {14, 23, 42}));
    EXPECT_EQ(volume_of(gltf), 144);
    EXPECT_EQ(gltf.nodes[0].origin, (Vec3{10, 20, 30}));
    // A quarter turn about y, x to -z; a length of the quaternion other than one changes nothing.
    gltf = placed(R"({"mesh":0,"rotation":[0,3,0,3]})");
    EXPECT_EQ(bounds_of(gltf), box({0, 0, -2}, {3, 1, 0}));
    // Scale, then turn, then shift; parents after children.
    gltf = placed(R"({"children":[1],"translation":[100,0,0]},{"mesh":0,"scale":[1,1,2],"rotation":[0,1,0,1],)"
                  R"("translation":[0,0,50]})");
    EXPECT_EQ(bounds_of(gltf), box({100, 0, 48}, {106, 1, 50}));
    gltf = placed(R"({"children":[1],"rotation":[0,1,0,1]},{"mesh":0,"translation":[5,0,0]})");
    EXPECT_EQ(bounds_of(gltf), box({0, 0, -7}, {3, 1, -5}));
    // A matrix with shear, column by column.
    gltf = placed(R"({"mesh":0,"matrix":[1,0,0,0, 2,1,0,0, 0,0,1,0, 7,8,9,1]})");
    EXPECT_EQ(bounds_of(gltf), box({7, 8, 9}, {11, 9, 12}));
    EXPECT_EQ(volume_of(gltf), 6);
}

TEST(ReadGltf, MirrorsKeepFrontsOutside) {
    const auto volume = [](const std::string& node) {
        SmallGltf file = box_file();
        file.nodes = node;
        return volume_of(read_good(file.text()));
    };
    EXPECT_EQ(volume(R"({"mesh":0,"scale":[-1,1,1]})"), 6);
    EXPECT_EQ(volume(R"({"mesh":0,"scale":[-1,-1,1]})"), 6);
    EXPECT_EQ(volume(R"({"mesh":0,"scale":[-1,-1,-1]})"), 6);
    EXPECT_EQ(volume(R"({"mesh":0,"matrix":[0,1,0,0, 1,0,0,0, 0,0,1,0, 0,0,0,1]})"), 6);
    EXPECT_EQ(volume(R"({"children":[1],"scale":[1,-1,1]},{"mesh":0,"scale":[-1,1,1]})"), 6);
}

TEST(ReadGltf, InstancesAndScenes) {
    SmallGltf file = box_file();
    file.nodes = R"({"mesh":0,"name":"first"},{"mesh":0,"translation":[10,0,0]},{"mesh":0,"translation":[20,0,0]})";
    file.scenes = R"({"nodes":[0,1]},{"nodes":[2]})";
    GltfLevel gltf = read_good(file.text());
    EXPECT_EQ(gltf.level.faces.size(), 24u);                                       // no scene named: the first
    EXPECT_EQ(gltf.level.groups, (std::vector<std::string>{"", "first", "box"}));  // a node without a name: its mesh's
    EXPECT_EQ(gltf.level.groups[gltf.level.faces[0].group], "first");
    file.more = R"(,"scene":1)";
    gltf = read_good(file.text());
    EXPECT_EQ(bounds_of(gltf), box({20, -3, 0}, {22, 0, 1}));
    EXPECT_EQ(gltf.nodes.size(), 1u);
    file.more = "";
    file.scenes = "";
    EXPECT_EQ(read_good(file.text()).level.faces.size(), 36u);  // none at all: every root
    EXPECT_NE(error_of(file.text(), {.max_triangles = 35}).find("more than 35 triangles"), std::string::npos);
    EXPECT_EQ(error_of(file.text(), {.max_triangles = 36}), "none");
}

TEST(ReadGltf, Materials) {
    SmallGltf file = box_file();
    file.materials = R"x({"name":"rock"},{"name":"leaf","doubleSided":true},{},)x"
                     R"x({"name":"x (cut)","extras":{"cut":true}},{"name":"(cut)","extras":{"cut":true}},)x"
                     R"x({"name":"x (cut)"})x";
    std::string primitives;
    for (const int material : {0, 1, 2, 3, 4, 5})
        primitives += "," + primitive(0, 1, R"(,"material":)" + std::to_string(material));
    file.meshes = replaced(file.meshes, "]}", primitives + "]}");
    const GltfLevel gltf = read_good(file.text());
    EXPECT_EQ(gltf.level.materials, (std::vector<std::string>{"", "rock", "leaf", "x", "x (cut)"}));
    const std::vector<std::uint32_t> expected{0, 1, 2, 0, 3, 0, 4};
    for (std::size_t k = 0; k < gltf.level.faces.size(); ++k) {
        EXPECT_EQ(gltf.level.faces[k].material, expected[k / 12]);
        EXPECT_EQ(gltf.level.faces[k].two_sided, k / 12 == 2);
        EXPECT_EQ(gltf.level.faces[k].mask, ~0u);
    }
}

TEST(ReadGltf, ExtrasAndMasks) {
    SmallGltf file = box_file();
    file.nodes = R"({"mesh":0,"children":[1,2,3,4],"extras":{"mask":"walk, SHOOT","health":7,"tags":["a","b"]}},)"
                 R"({"mesh":0},{"mesh":0,"extras":{"firma_mask":["liquid"],"mask":"see"}},)"
                 R"({"mesh":0,"extras":{"mask":"none"}},{"mesh":0,"extras":{"mask":"wlk"}})";
    const GltfLevel gltf = read_good(file.text());
    const std::uint32_t walls = kStopsWalk | kStopsShots;
    const std::vector<std::uint32_t> expected{walls, walls, kStopsLiquid, 0, walls};
    ASSERT_EQ(gltf.level.faces.size(), 60u);
    for (std::size_t k = 0; k < 60; ++k) {
        EXPECT_EQ(gltf.level.faces[k].mask, expected[k / 12]);
        EXPECT_TRUE(gltf.level.faces[k].two_sided);  // no rock
    }
    EXPECT_EQ(gltf.nodes[0].value("health"), "7");
    EXPECT_EQ(gltf.nodes[0].value("tags"), R"(["a","b"])");
    EXPECT_EQ(gltf.nodes[0].value("mask"), "walk, SHOOT");
    EXPECT_EQ(gltf.nodes[0].value("none"), "");
    ASSERT_EQ(gltf.notes.size(), 1u);
    EXPECT_EQ(gltf.notes[0].rfind("extras.mask of 'wlk' is not understood", 0), 0u) << gltf.notes[0];
    file.nodes = R"({"mesh":0,"extras":{"mask":"walk shoot see sky"}})";
    const GltfLevel sky = read_good(file.text());
    EXPECT_EQ(sky.level.faces[0].mask, kStopsSolid | kIsSky);
    EXPECT_FALSE(sky.level.faces[0].two_sided);
}

TEST(ReadGltf, WhatMovesIsNoted) {
    SmallGltf file = box_file();
    file.meshes = replaced(file.meshes, R"("indices")", R"("targets":[{"POSITION":0}],"indices")");
    file.more =
        R"(,"skins":[{"joints":[0]}],"animations":[{},{}],"cameras":[{}],"images":[{"uri":"/etc/passwd"}],)"
        R"("textures":[7],"extensionsUsed":["EXT_mesh_gpu_instancing"],"extensionsRequired":["KHR_materials_unlit"])";
    const GltfLevel gltf = read_good(file.text());
    EXPECT_EQ(gltf.notes.size(), 4u);
    EXPECT_EQ(gltf.level.ignored_entries, 3u);
    std::vector<std::string> left_out;
    for (const Omission& omission : gltf.level.omissions)
        left_out.push_back(omission.what + ": " + std::to_string(omission.count));
    EXPECT_EQ(left_out, (std::vector<std::string>{"skins: 1", "primitives' morph targets: 1", "animations: 2",
                                                  "uses of EXT_mesh_gpu_instancing: 1"}));
}

/// A square of the x-z plane, its normal up, as two triangles with normals of their own.
SmallGltf square(float lift, float last_normal) {
    SmallGltf file;
    const int positions = file.vectors<float>({0, 0, 0, 0, 0, 4, 4, lift, 4, 4, 0, 0});
    const int normals = file.vectors<float>({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, last_normal, 0});
    const int indices = file.indices<std::uint8_t>({0, 1, 2, 0, 2, 3});
    file.meshes = R"({"primitives":[{"attributes":{"POSITION":)" + std::to_string(positions) + R"(,"NORMAL":)" +
                  std::to_string(normals) + R"(},"indices":)" + std::to_string(indices) + "}]}";
    return file;
}

TEST(ReadGltf, FansOfOneNormalAreFaces) {
    const GltfLevel whole = read_good(square(0, 1).text());
    ASSERT_EQ(whole.level.faces.size(), 1u);
    EXPECT_EQ(whole.level.faces[0].corner_count, 4u);
    EXPECT_EQ(whole.level.source_faces, 2u);
    EXPECT_EQ(read_good(square(0, 0.5f).text()).level.faces.size(), 2u);  // another normal: another face
    // Not flat, whatever the normals say: its own triangles. Off by half a step: flat, though not on the grid.
    const GltfLevel bent = read_good(square(1, 1).text());
    EXPECT_EQ(bent.level.faces.size(), 2u);
    EXPECT_TRUE(bent.level.notes.empty());
    const GltfLevel nearly = read_good(square(0.0002f, 1).text());
    EXPECT_EQ(nearly.level.faces.size(), 2u);
    EXPECT_EQ(nearly.level.count(FaceNote::kSplit), 1u);
    EXPECT_EQ(nearly.note_places, (std::vector<Vec3>{{0, 0, 0}}));
}

TEST(ReadGltf, CheckTellsOfOpenEdges) {
    SmallGltf file;
    std::vector<std::uint16_t> eleven = box_triangles();
    eleven.resize(33);
    const int positions = file.vectors(box_corners(1, 1, 1)), indices = file.indices(eleven);
    file.meshes = R"({"primitives":[)" + primitive(positions, indices) + "]}";
    const GltfLevel gltf = read_good(file.text());
    const MeshCheck check = check_gltf(gltf).value();
    EXPECT_EQ(check.faults.size(), 3u);
    EXPECT_EQ(check.faces, 11u);
    EXPECT_EQ(check.vertices, 8u);
}

}  // namespace
}  // namespace firma::gltf

// SPDX-License-Identifier: MIT
// What read_gltf() refuses, each with its place.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

struct Change {
    std::string from, to, error;  ///< the error from its beginning
};

void expect_errors(const std::string& good, const std::vector<Change>& changes) {
    ASSERT_EQ(error_of(good), "none");
    for (const Change& change : changes) {
        const std::string error = error_of(replaced(good, change.from, change.to));
        EXPECT_EQ(error.rfind(change.error, 0), 0u) << change.to << "\n  " << error << "\n  " << change.error;
    }
}

TEST(GltfErrors, Json) {
    const std::string good = box_file().text();
    expect_errors(good, {
                            {R"({"asset")", "{\n {asset", "a.glb:2: its JSON breaks off at column 2"},
                            {R"("2.0")", R"("1.0")", "a.glb: is of version '\"1.0\"'; 2.0 is read"},
                            {R"("2.0")", R"("2.0","minVersion":"2.1")", "a.glb: is of minVersion"},
                            {R"("asset")", R"("assets")", "a.glb: has no asset.version"},
                            {R"("asset":{"version":"2.0"})", R"("asset":[])", "a.glb: has no asset.version"},
                            {"8", "1e999", "a.glb: its JSON has a number that is too large"},
                            {R"("name":"box")", "\"name\":\"\xff\"", "a.glb:1: its JSON breaks off at column"},
                            {R"("name":"box")", R"("name":7)", "a.glb: mesh 0: name is not a text"},
                        });
    EXPECT_EQ(error_of(""), "a.glb:1: its JSON breaks off at column 1");
    EXPECT_EQ(error_of("[]"), "a.glb: its JSON is not an object");
    EXPECT_EQ(error_of(std::string(100000, '[')), "a.glb: its JSON is nested too deeply");
    EXPECT_EQ(error_of(R"({"asset":{"version":"2.0"}})"), "a.glb: has no triangle in its scene");
    const std::string deep =
        replaced(good, R"({"asset")", R"({"extras":)" + std::string(63, '[') + std::string(63, ']') + R"(,"asset")");
    EXPECT_EQ(error_of(deep), "none");
    EXPECT_EQ(error_of(replaced(deep, "[", "[[")), "a.glb: its JSON is nested too deeply");
}

TEST(GltfErrors, Extensions) {
    SmallGltf file = box_file();
    file.more = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])";
    EXPECT_EQ(error_of(file.text()), "a.glb: needs the extension 'KHR_draco_mesh_compression', which is not read");
    file.more = R"(,"extensionsRequired":[7])";
    EXPECT_EQ(error_of(file.text()), "a.glb: needs the extension '7', which is not read");
    file.more = R"(,"extensionsRequired":["KHR_mesh_quantization","KHR_materials_unlit"])";
    EXPECT_EQ(error_of(file.text()), "none");
}

TEST(GltfErrors, MembersOfOtherTypes) {
    SmallGltf file = box_file();
    file.nodes = R"({"mesh":0,"translation":[1,2,3]})";
    file.materials = R"({"doubleSided":true})";
    file.more = R"(,"scene":0)";
    expect_errors(
        file.text(),
        {
            {R"("mesh":0)", R"("mesh":-1)", "a.glb: node 0: mesh is not a whole number from 0 to 2^31 - 1"},
            {R"("mesh":0)", R"("mesh":4294967296)", "a.glb: node 0: mesh is not a whole number"},
            {R"("mesh":0)", R"("mesh":0.5)", "a.glb: node 0: mesh is not a whole number"},
            {R"("mesh":0)", R"("mesh":"0")", "a.glb: node 0: mesh is not a whole number"},
            {R"("mesh":0)", R"("mesh":0.0)", "none"},
            {R"("mesh":0)", R"("children":[true])", "a.glb: node 0: children is not a list of whole numbers"},
            {R"([1,2,3])", R"([1,2])", "a.glb: node 0: translation is not a list of 3 numbers"},
            {R"([1,2,3])", R"([1,2,"3"])", "a.glb: node 0: translation is not a list of 3 numbers"},
            {R"("translation":[1,2,3])", R"("rotation":[0,0,1])", "a.glb: node 0: rotation is not a list of 4"},
            {R"("translation":[1,2,3])", R"("matrix":[0,0,1])", "a.glb: node 0: matrix is not a list of 16"},
            {R"({"mesh":0,"translation":[1,2,3]})", "3", "a.glb: node 0: is not an object"},
            {R"("doubleSided":true)", R"("doubleSided":1)", "a.glb: material 0: doubleSided is not true or false"},
            {R"("scene":0)", R"("scene":"x")", "a.glb: scene: is not a whole number"},
            {R"("scenes":[{"nodes":[0]}])", R"("scenes":{})", "a.glb: scenes: is not a list"},
            {R"("primitives":[)", R"("x":[)", "a.glb: mesh 0: has no list of primitives"},
            {R"("attributes":{"POSITION":0})", R"("mode":4)", "a.glb: mesh 0, primitive 0: has no attributes"},
            {R"("attributes":{"POSITION":0})", R"("attributes":3)", "a.glb: mesh 0, primitive 0: is not an object"},
            {R"("POSITION":0)", R"("POSITION":"a")", "a.glb: mesh 0, primitive 0: POSITION is not a whole number"},
            {R"("count":8)", R"("count":-8)", "a.glb: accessor 0: count is not a whole number from 0 to 2^53"},
            {R"("count":8)", R"("count":1e300)", "a.glb: accessor 0: count is not a whole number from 0 to 2^53"},
            {R"("count":8,)", "", "a.glb: accessor 0: has no count"},
            {R"("byteLength":96})", R"("byteLength":null})", "a.glb: buffer view 0: byteLength is not a whole"},
        });
}

TEST(GltfErrors, WhatIsNotThere) {
    SmallGltf file = box_file();
    file.more = R"(,"scene":0)";
    expect_errors(
        file.text(),
        {
            {R"("scene":0)", R"("scene":1)", "a.glb: scene 1: is not there; there are 1"},
            {R"({"nodes":[0]})", R"({"nodes":[3]})", "a.glb: node 3: is not there; there are 1"},
            {R"({"nodes":[0]})", R"({"nodes":[0,0]})", "a.glb: node 0: is in the scene twice; nodes must make trees"},
            {R"({"mesh":0})", R"({"children":[0]})", "a.glb: node 0: is in the scene twice"},
            {R"({"mesh":0})", R"({"children":[1]},{"children":[0]})", "a.glb: node 0: is in the scene twice"},
            {R"({"mesh":0})", R"({"mesh":1})", "a.glb: node 0: names mesh 1 of 1"},
            {R"("indices":1)", R"("indices":1,"material":2)", "a.glb: mesh 0, primitive 0: names material 2 of 0"},
            {R"("POSITION":0)", R"("POSITION":9)", "a.glb: mesh 0, primitive 0, accessor 9: is not there; there are 2"},
            {R"("POSITION":0)", R"("POSITION":1)", "a.glb: mesh 0, primitive 0, accessor 1: is not of type VEC3"},
            {R"("indices":1)", R"("indices":0)", "a.glb: mesh 0, primitive 0, accessor 0: is not of type SCALAR"},
            {R"("bufferView":0)", R"("bufferView":7)",
             "a.glb: mesh 0, primitive 0, accessor 0, buffer view 7: is not there; there are 2"},
            {R"("bufferViews":[{"buffer":0)", R"("bufferViews":[{"buffer":1)",
             "a.glb: mesh 0, primitive 0, accessor 0, buffer view 0: names buffer 1 of 1"},
            {R"("indices":1)", R"("indices":1,"mode":7)", "a.glb: mesh 0, primitive 0: is drawn in mode 7"},
        });
}

TEST(GltfErrors, Sizes) {
    const std::string at = "a.glb: mesh 0, primitive 0, accessor 0";
    expect_errors(
        box_file().text(),
        {
            {R"("count":8)", R"("count":9)", at + ", buffer view 0: has 96 bytes, and 108 would be needed"},
            {R"("count":8)", R"("count":9007199254740992)", at + ": has 9007199254740992 elements"},
            {R"("count":8)", R"("count":7)", "a.glb: mesh 0, primitive 0, index 8: names vertex 7 of 7"},
            {R"("count":36)", R"("count":35)", "a.glb: mesh 0, primitive 0: has 35 corners, no multiple of three"},
            {R"("byteLength":96})", R"("byteLength":95})", at + ", buffer view 0: has 95 bytes, and 96"},
            {R"("byteLength":96})", R"("byteLength":9007199254740992})",
             at + ", buffer view 0: ends at byte 9007199254740992 of a buffer of 168"},
            {R"("byteLength":168)", R"("byteLength":169)", "a.glb: buffer 0: has 168 of its 169 bytes"},
            {R"("byteLength":168)", R"("byteLength":167)",
             "a.glb: mesh 0, primitive 0, accessor 1, buffer view 1: ends at byte 168 of a buffer of 167"},
            {R"("byteLength":96})", R"("byteLength":96,"byteStride":8})",
             at + ", buffer view 0: has a stride of 8 bytes for elements of 12"},
            {R"("byteLength":96})", R"("byteLength":96,"byteStride":16})",
             at + ", buffer view 0: has 96 bytes, and 124 would be needed"},
            {R"("byteLength":96})", R"("byteLength":96,"byteStride":256})", "a.glb: Invalid `byteStride' value"},
            {R"("componentType":5126)", R"("componentType":5130)", at + ": is of component type 5130"},
            {R"("componentType":5123)", R"("componentType":5126)",
             "a.glb: mesh 0, primitive 0, accessor 1: is of component type 5126, which indices cannot have"},
            {R"("type":"VEC3")", R"("type":"VEC9")", "a.glb: Unsupported `type`"},
        });
}

TEST(GltfErrors, Sparse) {
    SmallGltf file = box_file();
    const int which = file.view(bytes_of<std::uint8_t>({2, 4, 4, 8}));
    const int values = file.view(bytes_of<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}));
    const auto with = [&](const std::string& sparse) {
        return replaced(file.text(), R"("type":"VEC3")", R"("type":"VEC3","sparse":)" + sparse);
    };
    const auto sparse = [&](int count, int offset, int component) {
        return with(R"({"count":)" + std::to_string(count) + R"(,"indices":{"bufferView":)" + std::to_string(which) +
                    R"(,"byteOffset":)" + std::to_string(offset) + R"(,"componentType":)" + std::to_string(component) +
                    R"(},"values":{"bufferView":)" + std::to_string(values) + "}}");
    };
    const std::string at = "a.glb: mesh 0, primitive 0, accessor 0";
    EXPECT_EQ(error_of(sparse(2, 0, 5121)), "none");
    EXPECT_EQ(error_of(sparse(2, 1, 5121)), at + ": has sparse indices that do not increase");
    EXPECT_EQ(error_of(sparse(2, 2, 5121)), at + ": replaces element 8 of 8");
    EXPECT_EQ(error_of(sparse(2, 0, 5126)), at + ": has sparse indices of component type 5126");
    EXPECT_EQ(error_of(sparse(2, 3, 5121)),
              at + " sparse indices, buffer view " + std::to_string(which) + ": has 4 bytes, and 5 would be needed");
    EXPECT_EQ(error_of(sparse(4, 0, 5121)),
              at + " sparse values, buffer view " + std::to_string(values) + ": has 36 bytes, and 48 would be needed");
    EXPECT_EQ(error_of(with("{}")), "a.glb: accessor 0 sparse: has no count");
    EXPECT_EQ(error_of(with(R"({"count":1})")), "a.glb: accessor 0 sparse: has no indices");
    EXPECT_EQ(error_of(with(R"({"count":1,"indices":7})")), "a.glb: accessor 0 sparse indices: is not an object");
}

TEST(GltfErrors, NormalsThatDoNotFit) {
    SmallGltf file = box_file();
    const int normals = file.vectors<float>({0, 1, 0});
    file.meshes = replaced(file.meshes, R"("POSITION":0)", R"("POSITION":0,"NORMAL":)" + std::to_string(normals));
    EXPECT_EQ(error_of(file.text()), "a.glb: mesh 0, primitive 0: has 8 positions and 1 normals");
}

TEST(GltfErrors, Positions) {
    const auto with = [](float number, const std::string& node) {
        SmallGltf file;
        std::vector<float> corners = box_corners(1, 1, 1);
        corners[4] = number;
        const int positions = file.vectors(corners), indices = file.indices(box_triangles());
        file.meshes = R"({"primitives":[)" + primitive(positions, indices) + "]}";
        file.nodes = node;
        return error_of(file.glb());
    };
    const std::string at = "a.glb: mesh 0, primitive 0, vertex ";
    EXPECT_EQ(with(NAN, R"({"mesh":0})"), at + "1: is not finite at node 0");
    EXPECT_EQ(with(INFINITY, R"({"mesh":0})"), at + "1: is not finite at node 0");
    EXPECT_EQ(with(9000, R"({"mesh":0})"),
              at + "1: lies outside the world, which spans 8192 m to each side, at node 0");
    EXPECT_EQ(with(1, R"({"children":[1],"scale":[1e308,1,1]},{"mesh":0,"scale":[1e308,1,1]})"),
              at + "0: is not finite at node 1");
    EXPECT_EQ(with(1, R"({"mesh":0,"scale":[1e5,1,1]})"),
              at + "3: lies outside the world, which spans 8192 m to each side, at node 0");
    EXPECT_EQ(with(1, R"({"mesh":0,"rotation":[0,0,0,0]})"), "a.glb: node 0: has a rotation that is none");
    EXPECT_EQ(with(1, R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0.5,0,0,0,1]})"),
              "a.glb: node 0: has a matrix that is not affine");
    EXPECT_EQ(with(1, R"({"mesh":0,"scale":[1,1,1],"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})"),
              "a.glb: node 0: has a matrix and its parts");
}

TEST(GltfErrors, ManyInstancesOfLittle) {
    // A count without bytes, placed over and over: refused before anything is made of it.
    SmallGltf file;
    const int zeros = file.accessor(R"({"componentType":5126,"count":3000000000,"type":"VEC3"})");
    file.meshes = R"({"primitives":[)" + primitive(zeros, -1) + "]}";
    const std::string buffers = R"("buffers":[{"byteLength":0,"uri":"data:;base64,"}])";
    const std::string text = file.json(R"(,"uri":"data:;base64,")");
    EXPECT_NE(text.find(buffers), text.npos);
    EXPECT_EQ(error_of(text), "a.glb: mesh 0, primitive 0: makes more than 67108864 triangles of all nodes");
}

TEST(GltfErrors, Containers) {
    const std::string good = box_file().glb();
    const std::size_t json_size = box_file().json("").size();
    const std::size_t bin = 20 + (json_size + 3) / 4 * 4;
    const auto with = [&](std::size_t at, const std::string& bytes) {
        std::string file = good;
        file.replace(at, bytes.size(), bytes);
        return error_of(file);
    };
    EXPECT_EQ(error_of(good), "none");
    EXPECT_EQ(with(4, u32_bytes(1)), "a.glb: is a .glb of version 1; 2 is read");
    EXPECT_EQ(with(8, u32_bytes(99)), "a.glb: says that it has 99 bytes, and has " + std::to_string(good.size()));
    EXPECT_EQ(with(12, u32_bytes(~0u)), "a.glb: chunk 0 reaches beyond the file");
    EXPECT_EQ(with(16, "BIN"), "a.glb: its first chunk is not JSON");
    EXPECT_EQ(with(bin, u32_bytes(169)), "a.glb: chunk 1 reaches beyond the file");
    EXPECT_EQ(with(bin, u32_bytes(164)), "a.glb: chunk 2 ends within its head");
    EXPECT_EQ(with(bin + 4, "ABCD"), "a.glb: buffer 0: says nowhere where its bytes are");
    for (std::size_t size = 0; size < good.size(); size += size < 40 ? 1 : 37)
        EXPECT_NE(error_of(good.substr(0, size)), "none") << size;
    EXPECT_EQ(error_of(good.substr(0, 12)), "a.glb: ends within its head");
    // A chunk of another type behind is passed over.
    std::string more = good + u32_bytes(4) + "ABCDwxyz";
    more.replace(8, 4, u32_bytes(std::uint32_t(more.size())));
    EXPECT_EQ(error_of(more), "none");
}

}  // namespace
}  // namespace firma::gltf

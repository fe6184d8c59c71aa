// SPDX-License-Identifier: MIT
// What is written as .glb is what tinygltf reads, and is the world; what a .glb cannot hold is refused. The file as the
// command line writes it is judged byte by byte in test_glb.py.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "cli/failure.h"
#include "cli/write_glb.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/mesh.h"

namespace firma::cli {
namespace {

World first_level() {
    return make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
}

/// A tetrahedron's mesh, a material and a flag for each face.
World tetrahedron(const std::vector<std::string>& names, const std::vector<std::uint8_t>& two_sided) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
    const std::vector<std::uint32_t> corners{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}, materials{0, 1, 2, 3};
    Mesh mesh;
    mesh.vertices = vertices;
    mesh.corners = corners;
    mesh.materials = materials;
    mesh.material_names = names;
    mesh.two_sided = two_sided;
    return make_world(level_from_mesh(mesh, "tetrahedron").value()).value();
}

World carved(const World& world, const Vec3& place, double radius, const std::string& material) {
    const Pose pose{.position = place, .scale = radius};
    const CarveResult result = carve(world, make_crater(CutterShape::kRocky, 1), pose, {material});
    EXPECT_EQ(result.status, CarveStatus::kDone);
    return result.world;
}

std::string glb_of(const World& world, int up = 2) {
    const GlbParts parts(world);
    std::string bytes;
    write_glb(world, parts, up, [&](std::string_view piece) { bytes += piece; });
    EXPECT_LE(bytes.size(), parts.file_bytes());
    EXPECT_GT(bytes.size(), parts.buffer_bytes());
    return bytes;
}

tinygltf::Model read_back(const std::string& bytes) {
    tinygltf::Model model;
    std::string error, warning;
    const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
    EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromMemory(&model, &error, &warning, from, unsigned(bytes.size())));
    EXPECT_EQ(error + warning, "");
    return model;
}

template <class T>
std::vector<T> values_of(const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor& what = model.accessors.at(std::size_t(accessor));
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(what.bufferView));
    std::vector<T> values(view.byteLength / sizeof(T));
    EXPECT_LE(view.byteOffset + view.byteLength, model.buffers.at(0).data.size());
    EXPECT_EQ(values.size(), what.count * (what.type == TINYGLTF_TYPE_VEC3 ? 3 : 1));
    std::memcpy(values.data(), model.buffers.at(0).data.data() + view.byteOffset, view.byteLength);
    return values;
}

struct Expected {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
};

/// What stands in a part, by World::faces().
Expected expected_of(const World& world, const GlbPart& part) {
    Expected expected;
    for (const Face& face : world.faces()) {
        std::string name = world.material_name(face.material);
        if (face.source_edit != 0) name += name.empty() ? "(cut)" : " (cut)";
        if (name != part.name || face.two_sided != part.two_sided) continue;
        const std::uint32_t first = std::uint32_t(expected.positions.size() / 3);
        for (const Vec3& corner : face.corners) {
            for (int axis = 0; axis < 3; ++axis) expected.positions.push_back(float(corner[axis]));
            for (int axis = 0; axis < 3; ++axis) expected.normals.push_back(float(face.normal[axis]));
        }
        for (std::uint32_t k = 1; k + 1 < face.corners.size(); ++k)
            expected.indices.insert(expected.indices.end(), {first, first + k, first + k + 1});
    }
    return expected;
}

void expect_the_world(const World& world) {
    const tinygltf::Model model = read_back(glb_of(world));
    const GlbParts parts(world);
    ASSERT_EQ(model.meshes.size(), 1u);
    const std::vector<tinygltf::Primitive>& primitives = model.meshes[0].primitives;
    ASSERT_EQ(primitives.size(), parts.list().size());
    std::uint64_t faces = 0;
    for (std::size_t k = 0; k < primitives.size(); ++k) {
        const GlbPart& part = parts.list()[k];
        const Expected expected = expected_of(world, part);
        const tinygltf::Material& material = model.materials.at(std::size_t(primitives[k].material));
        EXPECT_EQ(material.name, part.name);
        EXPECT_EQ(material.doubleSided, part.two_sided);
        EXPECT_EQ(material.extras.Get("cut").Get<bool>(), part.cut);
        EXPECT_EQ(values_of<float>(model, primitives[k].attributes.at("POSITION")), expected.positions);
        EXPECT_EQ(values_of<float>(model, primitives[k].attributes.at("NORMAL")), expected.normals);
        EXPECT_EQ(values_of<std::uint32_t>(model, primitives[k].indices), expected.indices);
        EXPECT_EQ(part.triangles() * 3, expected.indices.size());
        faces += part.faces;
    }
    EXPECT_EQ(faces, world.face_count());
}

TEST(WriteGlb, IsTheWorldToTinygltf) {
    const World before = first_level();
    expect_the_world(before);
    const World named = carved(before, {35, 29, 0.2}, 1.6, "fresh");
    const World unnamed = carved(named, {36, 29, 0.2}, 1.2, "");
    expect_the_world(unnamed);
    std::set<std::string> names;
    const GlbParts parts(unnamed);
    for (const GlbPart& part : parts.list()) names.insert(part.name);
    EXPECT_EQ(
        names.count("fresh (cut)") + names.count("matter/rock (cut)") + names.count("floor") + names.count("fresh"),
        3u);
}

TEST(WriteGlb, TellsWhatTheWorldIs) {
    const World world = carved(first_level(), {35, 29, 0.2}, 1.6, "");
    const tinygltf::Value extras = read_back(glb_of(world)).asset.extras;
    EXPECT_EQ(extras.Get("version").Get<int>(), 1);
    EXPECT_EQ(extras.Get("edits").Get<int>(), 1);
    EXPECT_EQ(extras.Get("hash").Get<std::string>(), fmt::format("{:016x}", hash_world(world)));
}

TEST(WriteGlb, TwoSidedFacesHaveMaterialsOfTheirOwn) {
    const World world = tetrahedron({"a", "b", "a", "c"}, {0, 1, 1, 0});
    expect_the_world(world);
    std::size_t two_sided = 0;
    const GlbParts parts(world);
    for (const GlbPart& part : parts.list()) two_sided += part.two_sided;
    EXPECT_EQ(two_sided, 2u);
}

TEST(WriteGlb, NamesAreWholeUtf8) {
    EXPECT_EQ(glb_name("gr\xC3\xBC\xC3\x9F"), "gr\xC3\xBC\xC3\x9F");
    EXPECT_EQ(glb_name("a\xFF\xC3z"), "a\xEF\xBF\xBD\xEF\xBF\xBDz");
    EXPECT_EQ(glb_name(std::string_view("a\0b", 3)),
              "a\xEF\xBF\xBD"
              "b");
    // A control character, a quote; half a character, one written too long, half a surrogate pair, beyond Unicode.
    const std::vector<std::string> names{"tab\t\"quote\"\\", "\xE2\x82", "\xC0\x80\xED\xA0\x80",
                                         "\xF4\x90\x80\x80" + std::string(5000, '\x1f')};
    const World world = tetrahedron(names, {0, 0, 0, 0});
    const tinygltf::Model model = read_back(glb_of(world));
    std::set<std::string> expected, got;
    for (const std::string& name : names) expected.insert(glb_name(name));
    for (const tinygltf::Material& material : model.materials) got.insert(material.name);
    EXPECT_EQ(got, expected);
}

TEST(WriteGlb, AnEmptyWorldIsAnEmptyScene) {
    const tinygltf::Model model = read_back(glb_of(World()));
    ASSERT_EQ(model.scenes.size(), 1u);
    EXPECT_EQ(model.scenes[0].nodes.size() + model.nodes.size() + model.meshes.size() + model.buffers.size(), 0u);
}

TEST(WriteGlb, TurnsTheAxisThatPointsUpToY) {
    const World world = tetrahedron({"a", "b", "c", "d"}, {0, 0, 0, 0});
    for (const int up : {0, 1, 2}) {
        const tinygltf::Node node = read_back(glb_of(world, up)).nodes.at(0);
        if (up == 1) {
            EXPECT_TRUE(node.rotation.empty());
            continue;
        }
        ASSERT_EQ(node.rotation.size(), 4u);
        const Vec3 q{node.rotation[0], node.rotation[1], node.rotation[2]};
        Vec3 axis{0, 0, 0};
        axis[up] = 1;
        // v + 2 w (q x v) + 2 q x (q x v)
        const Vec3 once = cross(q, axis), turned = axis + 2 * node.rotation[3] * once + 2 * cross(q, once);
        EXPECT_NEAR(turned.x, 0, 1e-15);
        EXPECT_NEAR(turned.y, 1, 1e-15);
        EXPECT_NEAR(turned.z, 0, 1e-15);
    }
}

TEST(WriteGlb, WhatEndsTheWritingComesThrough) {
    const World world = first_level();
    const GlbParts parts(world);
    std::size_t pieces = 0;
    const auto full_disk = [&](std::string_view) {
        if (++pieces == 3) throw Failure("a.glb", "no room");
    };
    EXPECT_THROW(write_glb(world, parts, 2, full_disk), Failure);
    EXPECT_EQ(pieces, 3u);
}

TEST(WriteGlb, WhatDoesNotFitIsRefused) {
    EXPECT_NO_THROW(judge_glb_size(kLargestGlb, "a.glb"));
    try {
        judge_glb_size(kLargestGlb + 1, "a.glb");
        FAIL() << "a size that 32 bits cannot hold passed";
    } catch (const Failure& failure) {
        EXPECT_EQ(std::string(failure.what()).rfind("a.glb: would take 4295.0 MB", 0), 0u) << failure.what();
    }
    // Of 64-bit numbers: 200 million triangles, 16.8 GB.
    const GlbPart part{"rock", false, false, 200'000'000, 600'000'000};
    EXPECT_EQ(part.triangles(), 200'000'000u);
    EXPECT_EQ(2 * part.vertex_bytes() + part.index_bytes(), 16'800'000'000u);
}

TEST(WriteGlb, ColoursAreColoursAndDiffer) {
    std::set<std::array<double, 3>> colours;
    for (int k = 0; k < 100; ++k) {
        const std::array<double, 3> colour = colour_of("material " + std::to_string(k));
        for (const double part : colour) {
            EXPECT_GE(part, 0);
            EXPECT_LE(part, 1);
        }
        colours.insert(colour);
    }
    EXPECT_GT(colours.size(), 90u);
    EXPECT_EQ(colour_of("rock"), colour_of(std::string("ro") + "ck"));
}

}  // namespace
}  // namespace firma::cli

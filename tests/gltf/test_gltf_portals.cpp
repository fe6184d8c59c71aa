// SPDX-License-Identifier: MIT
// Portals: which nodes are some, and what becomes of their triangles.
#include <gtest/gtest.h>

#include <string>

#include "firma/polygon.h"
#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

/// The box as mesh 0, and as mesh 1 a square of 2 m in the x-y plane, front toward +z, in four triangles about its
/// middle.
SmallGltf with_square(const std::string& nodes) {
    SmallGltf file = box_file();
    const int positions = file.vectors<float>({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 0});
    const int indices = file.indices<std::uint8_t>({0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4});
    file.meshes += R"(,{"name":"door","primitives":[)" + primitive(positions, indices) + "]}";
    file.nodes = R"({"mesh":0},)" + nodes;
    file.scenes = R"({"nodes":[0,1]})";
    return file;
}

std::size_t portals_of(const std::string& nodes) {
    const GltfLevel gltf = read_good(with_square(nodes).text());
    EXPECT_EQ(gltf.level.source_faces, gltf.portals.empty() ? 16u : 12u);
    return gltf.portals.size();
}

TEST(GltfPortals, TrianglesBecomeTheirOutline) {
    const GltfLevel gltf = read_good(with_square(R"({"mesh":1,"name":"Portal.door"})").text(), {.up = 1});
    EXPECT_EQ(gltf.level.faces.size(), 12u);
    ASSERT_EQ(gltf.portals.size(), 1u);
    EXPECT_EQ(gltf.portals[0].name, "Portal.door");
    EXPECT_EQ(gltf.portals[0].node, 1u);
    ASSERT_EQ(gltf.portals[0].polygons.size(), 1u);
    std::vector<Vec3> corners;
    for (const GridPoint& point : gltf.portals[0].polygons[0]) corners.push_back(to_metres(point));
    ASSERT_EQ(corners.size(), 4u);
    EXPECT_EQ(check_polygon(corners), PolygonFault::kNone);
    EXPECT_EQ(cross(corners[1] - corners[0], corners[2] - corners[0]), (Vec3{0, 0, 4}));
}

TEST(GltfPortals, WhoIsOne) {
    EXPECT_EQ(portals_of(R"({"mesh":1})"), 0u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"name":"PORTAL7"})"), 1u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"name":"a portal"})"), 0u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"extras":{"portal":true}})"), 1u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"extras":{"firma_portal":1}})"), 1u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"extras":{"firma_portal":"True"}})"), 1u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"name":"portal","extras":{"portal":false}})"), 0u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"extras":{"portal":true,"firma_portal":0}})"), 0u);
    EXPECT_EQ(portals_of(R"({"mesh":1,"extras":{"portal":"perhaps"}})"), 0u);
    EXPECT_EQ(portals_of(R"({"name":"Portals","children":[2]},{"mesh":1})"), 1u);
    EXPECT_EQ(portals_of(R"({"name":"Portals","children":[2]},{"mesh":1,"extras":{"portal":false}})"), 0u);
}

TEST(GltfPortals, NamesComeFromAbove) {
    const auto name = [](const std::string& nodes) {
        const GltfLevel gltf = read_good(with_square(nodes).text());
        return gltf.portals.size() == 1 ? gltf.portals[0].name : "not one";
    };
    EXPECT_EQ(name(R"({"name":"Portals","children":[2]},{"mesh":1})"), "Portals");
    EXPECT_EQ(name(R"({"name":"Portals","children":[2]},{"mesh":1,"name":"hatch"})"), "hatch");
    EXPECT_EQ(name(R"({"mesh":1,"extras":{"portal":true}})"), "");
}

TEST(GltfPortals, MirrorsKeepTheFront) {
    const GltfLevel gltf = read_good(with_square(R"({"mesh":1,"name":"portal","scale":[-1,1,1]})").text(), {.up = 1});
    ASSERT_EQ(gltf.portals.size(), 1u);
    const std::vector<GridPoint>& outline = gltf.portals[0].polygons.at(0);
    const Vec3 a = to_metres(outline[0]), b = to_metres(outline[1]), c = to_metres(outline[2]);
    EXPECT_EQ(cross(b - a, c - a), (Vec3{0, 0, 4}));
}

TEST(GltfPortals, WhatIsNotConvexOrFlatComesInParts) {
    SmallGltf file = with_square(R"({"mesh":2,"name":"portal"})");
    // An L of three squares, and a square that stands on its end.
    const int positions = file.vectors<float>({0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0, 2, 0, 1, 2, 1, 1});
    const int indices = file.indices<std::uint8_t>({0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 1, 6, 7, 1, 7, 2});
    file.meshes += R"(,{"primitives":[)" + primitive(positions, indices) + "]}";
    const GltfLevel gltf = read_good(file.text());
    ASSERT_EQ(gltf.portals.size(), 1u);
    double area = 0;
    std::size_t squares = 0;
    for (const std::vector<GridPoint>& polygon : gltf.portals[0].polygons) {
        std::vector<Vec3> corners;
        for (const GridPoint& point : polygon) corners.push_back(to_metres(point));
        EXPECT_EQ(check_polygon(corners), PolygonFault::kNone);
        for (std::size_t k = 1; k + 1 < corners.size(); ++k)
            area += length(cross(corners[k] - corners[0], corners[k + 1] - corners[0])) / 2;
        squares += corners.size() == 4;
    }
    EXPECT_NEAR(area, 4, 1e-12);
    EXPECT_GE(squares, 1u);
}

TEST(GltfPortals, WithoutAreaThereIsNone) {
    const GltfLevel gltf = read_good(with_square(R"({"mesh":1,"name":"portal","scale":[1,0,1]})").text());
    EXPECT_TRUE(gltf.portals.empty());
    EXPECT_EQ(gltf.notes, (std::vector<std::string>{"a portal without area is left out"}));
}

TEST(GltfPortals, AFileOfPortalsAloneHasNoLevel) {
    SmallGltf file = box_file();
    file.nodes = R"({"mesh":0,"name":"portal"})";
    EXPECT_EQ(error_of(file.text()), "a.glb: has no triangle in its scene");
}

}  // namespace
}  // namespace firma::gltf

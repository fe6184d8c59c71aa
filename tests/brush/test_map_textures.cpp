// SPDX-License-Identifier: MIT
// How textures lie on brushes of a .map: coordinates worked out by hand, in each form; and what that does to joining.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/save.h"
#include "firma/triangles.h"
#include "tests/brush/map_text.h"

namespace firma::map_texture_tests {
namespace {

using map_text::box_points;
using map_text::point;
using map_text::world;

constexpr Vec3 kLow{0, 0, 0}, kHigh{64, 32, 96};  // units of 1/32 m

World world_of(const std::string& map) {
    const Result<BrushLevel> level = read_map(map, "a.map");
    EXPECT_TRUE(level.ok()) << level.error().text();
    return make_world(level.value()).value();
}

/// Of a box of 64 x 32 x 96 units, the projection of its side that looks along an axis.
TextureProjection of_side(const World& box, int axis, double sign) {
    for (const Face& face : box.faces()) {
        if (face.normal[axis] != sign) continue;
        const std::optional<TextureProjection> found = texture_of(box, face.ref());
        EXPECT_TRUE(found);
        return found.value_or(TextureProjection{});
    }
    ADD_FAILURE() << "no such side";
    return {};
}

/// The coordinates of a point given in units.
TexturePoint at(const TextureProjection& lies, double x, double y, double z) {
    return lies.at(Vec3{x, y, z} * (1.0 / 32));
}

void expect_near(const TexturePoint& made, double u, double v) {
    EXPECT_NEAR(made[0], u, 1e-9);
    EXPECT_NEAR(made[1], v, 1e-9);
}

TEST(MapTextures, StandardLiesAlongTheNearestAxis) {
    const World box = world_of(world(map_text::box(kLow, kHigh, "wall", "16 8 0 2 0.5")));
    for (const double sign : {-1.0, 1.0}) {
        const TextureProjection x = of_side(box, 0, sign), y = of_side(box, 1, sign), z = of_side(box, 2, sign);
        EXPECT_EQ(x.unit, TextureUnit::kTexels);
        // East and west: u along y, v down z. South and north: u along x, v down z. Floor and ceiling: x, and -y.
        expect_near(at(x, 64, 32, 96), 32 / 2.0 + 16, -96 / 0.5 + 8);
        expect_near(at(y, 64, 32, 96), 64 / 2.0 + 16, -96 / 0.5 + 8);
        expect_near(at(z, 64, 32, 96), 64 / 2.0 + 16, -32 / 0.5 + 8);
        expect_near(at(z, 0, 0, 0), 16, 8);
    }
}

TEST(MapTextures, StandardTurns) {
    const auto top = [](const std::string& alignment) {
        return of_side(world_of(world(map_text::box(kLow, kHigh, "wall", alignment))), 2, 1);
    };
    // By 90 degrees u goes where y does, and v where x does; exactly.
    EXPECT_EQ(at(top("3 5 90 2 4"), 64, 32, 96), (TexturePoint{32 / 2.0 + 3, 64 / 4.0 + 5}));
    EXPECT_EQ(at(top("3 5 -270 2 4"), 64, 32, 96), (TexturePoint{32 / 2.0 + 3, 64 / 4.0 + 5}));
    EXPECT_EQ(at(top("3 5 180 2 4"), 64, 32, 96), (TexturePoint{-64 / 2.0 + 3, 32 / 4.0 + 5}));
    const double c = std::sqrt(3.0) / 2, s = 0.5;
    expect_near(at(top("3 5 30 2 4"), 64, 32, 96), (c * 64 + s * 32) / 2 + 3, (s * 64 - c * 32) / 4 + 5);
    expect_near(at(top("0 0 750 0 0"), 64, 32, 96), c * 64 + s * 32, s * 64 - c * 32);  // a scale of 0 is 1
    // An east wall turned by 30: y and z take the places of x and y.
    const TextureProjection wall = of_side(world_of(world(map_text::box(kLow, kHigh, "wall", "0 0 30 1 1"))), 0, 1);
    expect_near(at(wall, 64, 32, 96), c * 32 + s * 96, s * 32 - c * 96);
}

/// A wedge whose slope looks along (1, 0, 1).
std::string wedge(const std::string& alignment) {
    std::string text = "{\n";
    const auto side = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        text += point(a) + point(b) + point(c) + "wall " + alignment + "\n";
    };
    const auto sides = box_points({0, 0, 0}, {64, 64, 64});
    for (const int k : {0, 2, 3, 4}) side(sides[std::size_t(k)][0], sides[std::size_t(k)][1], sides[std::size_t(k)][2]);
    side({0, 0, 64}, {0, 64, 64}, {64, 64, 0});
    return text + "}\n";
}

TEST(MapTextures, OfTwoAxesAsNearTheUprightOneCounts) {
    const World world_with_slope = world_of(world(wedge("0 0 0 1 1")));
    for (const Face& face : world_with_slope.faces()) {
        if (!(face.normal.x > 0 && face.normal.z > 0)) continue;
        const TextureProjection lies = texture_of(world_with_slope, face.ref()).value();
        expect_near(at(lies, 64, 64, 0), 64, -64);
        expect_near(at(lies, 0, 0, 64), 0, 0);
        return;
    }
    FAIL() << "no slope";
}

TEST(MapTextures, Valve220HasAxesOfItsOwn) {
    const World box = world_of(world(map_text::box(kLow, kHigh, "wall", "[ 0.6 0.8 0 5 ] [ 0 0 -1 7 ] 45 2 4")));
    const TextureProjection lies = of_side(box, 1, -1);
    EXPECT_EQ(lies.unit, TextureUnit::kTexels);
    expect_near(at(lies, 64, 32, 96), (0.6 * 64 + 0.8 * 32) / 2 + 5, -96 / 4.0 + 7);
}

std::string primitive(const std::string& matrix) {
    std::string text = "{\nbrushDef\n{\n";
    for (const auto& [a, b, c] : box_points(kLow, kHigh))
        text += point(a) + point(b) + point(c) + matrix + " a/wall 0 0 0\n";
    return text + "}\n}\n";
}

TEST(MapTextures, PrimitivesHaveAMatrixInTheirPlane) {
    const World box = world_of(world(primitive("( ( 0.5 0.25 3 ) ( 0.125 2 7 ) )")));
    // Along the plane: level, as the normal turned left; and down the slope. Of a floor and a ceiling y, and x or -x.
    const auto expect_at = [&](int axis, double sign, double x, double y) {
        const TextureProjection lies = of_side(box, axis, sign);
        EXPECT_EQ(lies.unit, TextureUnit::kRepeats);
        expect_near(at(lies, 64, 32, 96), 0.5 * x + 0.25 * y + 3, 0.125 * x + 2 * y + 7);
    };
    expect_at(0, 1, 32, -96);
    expect_at(0, -1, -32, -96);
    expect_at(1, 1, -64, -96);
    expect_at(1, -1, 64, -96);
    expect_at(2, 1, 32, 64);
    expect_at(2, -1, 32, -64);
}

TEST(MapTextures, PrimitivesOnASlopeGoDownIt) {
    const double h = std::sqrt(0.5);
    const std::string brush = map_text::plane_brush(
        {{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 1, 0}, 64}, {{0, 0, -1}, 0}, {{h, 0, h}, 64 * h}});
    const World box = world_of("Version 2\n" + world(brush));
    for (const Face& face : box.faces()) {
        if (!(face.normal.x > 0 && face.normal.z > 0)) continue;
        const TextureProjection lies = texture_of(box, face.ref()).value();
        // The matrix is 1/32 of a repeat a unit: u is y, v the way down, (1, 0, -1) / sqrt(2).
        const TexturePoint low = at(lies, 64, 64, 0), high = at(lies, 0, 0, 64);
        EXPECT_NEAR(low[0] - high[0], 64 / 32.0, 1e-6);
        EXPECT_NEAR(low[1] - high[1], 64 * std::sqrt(2.0) / 32, 1e-6);
        return;
    }
    FAIL() << "no slope";
}

/// In Doom 3 a brush moves by its entity's origin, and its picture stays where it is in the world.
TEST(MapTextures, PicturesStayWhereAnOriginMovesABrush) {
    const std::string brush = map_text::plane_brush(map_text::box_planes(kLow, kHigh));
    const World box = world_of("Version 2\n" + world("") +
                               "{\n\"classname\" \"func_static\"\n\"origin\" \"8 16 32\"\n" + brush + "}\n");
    const TextureProjection top = of_side(box, 2, 1);
    expect_near(at(top, 8, 16, 96 + 32), 16 / 32.0, 8 / 32.0);
}

std::string patch_text(double bend) {
    std::string text = "{\npatchDef2\n{\na/curve\n( 3 3 0 0 0 )\n(\n";
    for (int x = 0; x < 3; ++x) {
        text += "( ";
        for (int y = 0; y < 3; ++y)
            text += "( " + std::to_string(32 * x) + " " + std::to_string(32 * y) + " " +
                    std::to_string(x == 1 ? bend : 0.0) + " " + std::to_string(0.5 * x) + " " +
                    std::to_string(0.25 * y + 1) + " ) ";
        text += ")\n";
    }
    return text + ")\n}\n}\n";
}

/// Corners of all faces of a material, with their coordinates.
std::map<std::tuple<double, double, double>, TexturePoint> coordinates(const World& made, const std::string& material) {
    std::map<std::tuple<double, double, double>, TexturePoint> found;
    for (const Face& face : made.faces()) {
        if (made.material_name(face.material) != material) continue;
        const std::optional<TextureProjection> lies = texture_of(made, face.ref());
        EXPECT_TRUE(lies);
        if (!lies) continue;
        for (const Vec3& corner : face.corners) {
            const auto [known, is_new] = found.try_emplace({corner.x, corner.y, corner.z}, lies->at(corner));
            EXPECT_NEAR(known->second[0], lies->at(corner)[0], 2e-3) << "faces of a curve agree where they meet";
            EXPECT_NEAR(known->second[1], lies->at(corner)[1], 2e-3);
        }
    }
    return found;
}

TEST(MapTextures, CurvesHaveTheirControlPoints) {
    const std::string box = map_text::box({-64, -64, -128}, {-32, -32, -96});
    for (const double bend : {0.0, 40.0}) {
        const auto found = coordinates(world_of(world(box + patch_text(bend))), "a/curve");
        ASSERT_GE(found.size(), 4u);
        EXPECT_GE(found.size(), bend == 0 ? 4u : 10u);
        for (const auto& [place, uv] : found) {
            const auto& [x, y, z] = place;
            // Along the curve x goes evenly from 0 to 2 m, and u from 0 to 1.
            EXPECT_NEAR(uv[0], x / 2, 2e-3);
            EXPECT_NEAR(uv[1], y / 4 + 1, 2e-3);
        }
    }
}

/// Two boxes side by side, each with an alignment: how many faces their tops make.
std::size_t tops(const std::string& left, const std::string& right, const std::string& texture = "wall") {
    const World made = world_of(world(map_text::box({0, 0, 0}, {64, 64, 64}, texture, left) +
                                      map_text::box({64, 0, 0}, {128, 64, 64}, texture, right)));
    std::size_t count = 0;
    for (const Face& face : made.faces()) count += face.normal.z == 1;
    return count;
}

TEST(MapTextures, NeighboursMergeWhereTheirPicturesGoOn) {
    EXPECT_EQ(tops("0 0 0 1 1", "0 0 0 1 1"), 1u);
    EXPECT_EQ(tops("0 0 0 1 1", "32 0 0 1 1"), 2u);
    EXPECT_EQ(tops("0 0 0 1 1", "0 0 0 1 2"), 2u);
    EXPECT_EQ(tops("0 0 0 1 1", "[ 1 0 0 0 ] [ 0 -1 0 0 ] 7 1 1"), 1u) << "the same, said in another way";
    EXPECT_EQ(tops("0 0 0 1 1", "[ 1.00000001 0 0 0 ] [ 0 -1 0 0 ] 7 1 1"), 1u) << "to within a float";
    EXPECT_EQ(tops("0 0 0 1 1", "32 0 0 1 1", "common/caulk"), 1u) << "tools' textures are not seen";
    EXPECT_EQ(tops("0 0 0 1 1", "32 0 0 1 1", "skies/blue"), 1u);
}

TEST(MapTextures, NumbersThatAreTooLargeSayNothing) {
    const World box = world_of(world(map_text::box(kLow, kHigh, "wall", "1e300 0 0 1 1")));
    EXPECT_FALSE(texture_of(box, box.faces()[0].ref()));
    const World turned = world_of(world(map_text::box(kLow, kHigh, "wall", "0 0 1e300 1 1")));
    EXPECT_FALSE(texture_of(turned, turned.faces()[0].ref()));
    const World thin = world_of(world(map_text::box(kLow, kHigh, "wall", "0 0 0 1e-300 1")));
    EXPECT_FALSE(texture_of(thin, thin.faces()[0].ref()));
}

/// What is left of a face of the file lies as it did, through cuts and a file; what a cutter made has no projection.
TEST(MapTextures, StayThroughCutsAndFiles) {
    const World before = world_of(world(map_text::box({-256, -256, -256}, {256, 256, 256}, "wall", "16 8 30 2 0.5")));
    const TextureProjection top = of_side(before, 2, 1);
    World after = before;
    for (int k = 0; k < 3; ++k)
        after =
            carve(after, make_crater(CutterShape::kRocky, std::uint64_t(k)), {.position = {k - 1.0, 0.5 * k, 8}}).world;
    ASSERT_EQ(after.solid().edits(), 3u);
    const World loaded = unpack_world(pack_world(after), "a.firma").value();
    const World lighter = unpack_world(pack_world(after, {.exact = false, .index = false}), "a.firma").value();
    for (const World& one : {after, loaded, lighter}) {
        std::size_t pieces = 0, made = 0;
        for (const Face& face : one.faces()) {
            const std::optional<TextureProjection> lies = texture_of(one, face.ref());
            EXPECT_EQ(lies.has_value(), face.source_edit == 0);
            made += face.source_edit != 0;
            if (face.source_edit != 0 || !(face.normal.z > 0.9)) continue;
            ++pieces;
            EXPECT_TRUE(*lies == top);
        }
        EXPECT_GT(pieces, 5u);
        EXPECT_GT(made, 100u);
    }
    EXPECT_EQ(hash_world(loaded), hash_world(after));
}

TEST(MapTextures, ComeOutAsCoordinatesOfTriangles) {
    const World box = world_of(world(map_text::box({-256, -256, -256}, {256, 256, 256}, "wall", "16 8 0 2 0.5")));
    const World cut = carve(box, make_crater(CutterShape::kRocky, 1), {.position = {0, 0, 8}}).world;
    EXPECT_TRUE(triangles_of(cut).uvs.empty()) << "nobody asked";

    std::vector<std::array<double, 2>> sizes(2, {0, 0});
    const TriangleMesh texels = triangles_of(cut, {.uvs = true, .texture_sizes = sizes});
    for (std::uint32_t k = 0; k < 2; ++k)
        if (cut.material_name(k) == "wall") sizes[k] = {64, 128};
    const TriangleMesh repeats = triangles_of(cut, {.uvs = true, .texture_sizes = sizes});
    ASSERT_EQ(texels.uvs.size(), texels.positions.size());
    ASSERT_EQ(repeats.uvs.size(), texels.uvs.size());
    std::size_t of_file = 0, of_cutter = 0;
    for (std::size_t k = 0; k < texels.sources.size(); ++k) {
        const TriangleMesh::Source& source = texels.sources[k];
        const bool made = source.source_edit != 0;
        (made ? of_cutter : of_file) += 1;
        EXPECT_EQ(source.uv_unit, made ? TextureUnit::kMetres : TextureUnit::kTexels);
        EXPECT_EQ(repeats.sources[k].uv_unit, made ? TextureUnit::kMetres : TextureUnit::kRepeats);
        for (std::uint32_t v = source.first_vertex; v < source.first_vertex + source.vertex_count; ++v) {
            const auto& [x, y, z] = texels.positions[v];
            const auto& normal = texels.normals[v];
            if (made) {
                EXPECT_EQ(repeats.uvs[v], texels.uvs[v]);
                if (std::fabs(normal[2]) > 0.8f) {
                    EXPECT_FLOAT_EQ(texels.uvs[v][0], normal[2] < 0 ? -x : x);
                    EXPECT_FLOAT_EQ(texels.uvs[v][1], -y);
                }
                continue;
            }
            if (normal[2] > 0.9f) {
                EXPECT_NEAR(texels.uvs[v][0], x * 32 / 2 + 16, 1e-3);
                EXPECT_NEAR(texels.uvs[v][1], -y * 32 / 0.5 + 8, 1e-3);
            }
            EXPECT_FLOAT_EQ(repeats.uvs[v][0], texels.uvs[v][0] / 64);
            EXPECT_FLOAT_EQ(repeats.uvs[v][1], texels.uvs[v][1] / 128);
        }
    }
    EXPECT_GT(of_file, 5u);
    EXPECT_GT(of_cutter, 50u);
}

TEST(MapTextures, ALevelFilledByHandIsJudged) {
    BrushLevel level = read_map(world(map_text::box(kLow, kHigh)), "a.map").value();
    ASSERT_EQ(level.textures.size(), 3u) << "a projection for each axis";
    level.sides[4].texture = 3;
    EXPECT_EQ(make_world(level).error().text(),
              "a.map: brush 0 (line 3), side 4: its texture 3 is not there: there are 3");
    level.sides[4].texture = kNoTexture;
    EXPECT_TRUE(make_world(level).ok());
    level.textures[1].u_offset = NAN;
    EXPECT_EQ(make_world(level).error().text(), "a.map: texture 1: its numbers are not finite, or too large");
}

}  // namespace
}  // namespace firma::map_texture_tests

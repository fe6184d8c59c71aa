// SPDX-License-Identifier: MIT
// Brushes and patches in the forms of Quake 3's and Doom 3's editors: brushDef, brushDef3, patchDef3.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "firma/brush_world.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "tests/brush/map_text.h"

namespace firma {
namespace {

using namespace map_text;

Result<BrushLevel> read(const std::string& text) {
    return read_map(text, "a.map");
}

std::string error_of(const std::string& text) {
    const auto level = read(text);
    return level ? "" : level.error().text();
}

void expect_same_sides(const BrushLevel& a, const BrushLevel& b) {
    ASSERT_EQ(a.sides.size(), b.sides.size());
    for (std::size_t k = 0; k < a.sides.size(); ++k)
        for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(a.sides[k].points[corner], b.sides[k].points[corner]) << k;
}

double volume_of(const BrushLevel& level) {
    const Result<World> world = make_world(level);
    EXPECT_TRUE(world.ok());
    if (!world.ok()) return NAN;
    EXPECT_FALSE(check_world(world.value()));
    EXPECT_FALSE(check_solid(world.value()));
    return measure_solid(world.value()).volume;
}

// Finding 24: these brushes were dropped.
TEST(ReadPrimitives, BrushDefIsThePlanesOfItsPoints) {
    const Vec3 low{0, -32, 16}, high{64, 32, 96};
    const BrushLevel level = read(world(primitive_box(low, high))).value();
    ASSERT_EQ(level.brushes.size(), 1u);
    EXPECT_EQ(level.brushes[0].kind, BrushKind::kSolid);
    EXPECT_EQ(level.brushes[0].line, 3u);
    EXPECT_EQ(level.materials[1], "a/wall");
    EXPECT_TRUE(level.notes.empty());
    EXPECT_TRUE(level.omissions.empty());
    expect_same_sides(level, read(world(box(low, high))).value());
    EXPECT_EQ(volume_of(level), 2 * 2 * 2.5);
}

TEST(ReadPrimitives, BrushDef3IsThePlanesThemselves) {
    const Vec3 low{-8, -32, 16}, high{64, 32, 96.5};
    const BrushLevel level = read("Version 2\n" + world(plane_brush(box_planes(low, high)))).value();
    ASSERT_EQ(level.brushes.size(), 1u);
    EXPECT_EQ(level.materials[1], "textures/a/wall");
    EXPECT_TRUE(level.notes.empty());
    EXPECT_EQ(level.max_shift, 0);
    EXPECT_EQ(volume_of(level), 72 * 64 * 80.5 / 32768);
    const Vec3 middle = (low + high) * (0.5 / 32);
    for (const BrushSide& side : level.sides) {
        const Vec3 a = to_metres(side.points[0]);
        EXPECT_LT(dot(cross(to_metres(side.points[1]) - a, to_metres(side.points[2]) - a), middle - a), 0);
    }
    // A normal of any length, and keys of a brush, as editors write them.
    std::string scaled = plane_brush({{{-3, 0, 0}, 24},
                                      {{0.3, 0, 0}, 64 * 0.3},
                                      {{0, -1e-3, 0}, 32e-3},
                                      {{0, 7, 0}, 224},
                                      {{0, 0, -1}, -16},
                                      {{0, 0, 2}, 193}});
    scaled.insert(scaled.find("{\n(") + 2, "\"editor_key\" \"a value\"\n");
    EXPECT_EQ(volume_of(read(world(scaled)).value()), 72 * 64 * 80.5 / 32768);
}

TEST(ReadPrimitives, AxialPlanesAreSnappedAndSaidSo) {
    const BrushLevel level = read(world(plane_brush(box_planes({0, 0, 0}, {64, 32, 96.003})))).value();
    EXPECT_NEAR(level.max_shift, 0.003 / 32, 1e-9);
    EXPECT_EQ(volume_of(level), 6);
}

// An octahedron with its corners at whole units, its planes in ten digits and in six: the planes through the corners
// come back to the bit.
TEST(ReadPrimitives, FloatsOfSlantedPlanesComeBackExactly) {
    const Vec3 middle{1000, -517, 33};
    for (const char* digits : {"%.10g", "%.8f"}) {
        std::vector<PlaneText> planes;
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0}) {
                    const Vec3 normal = Vec3{x, 2 * y, 4 * z} * (1 / std::sqrt(21.0));
                    planes.push_back({normal, dot(normal, middle + Vec3{128 * x, 0, 0})});
                }
        const BrushLevel level = read(world(plane_brush(planes, "textures/a", digits))).value();
        EXPECT_LT(level.max_shift, 1e-4);
        EXPECT_EQ(volume_of(level), 4.0 / 3 * 4 * 2 * 1) << digits;
    }
}

// Two turned boxes that share a plane, each with its own side of it: nothing is between them.
TEST(ReadPrimitives, NeighboursShareTheirPlane) {
    const Vec3 u{0.8, 0.6, 0}, v{-0.6, 0.8, 0}, w{0, 0, 1};
    const Vec3 origin{100.1, -37.7, 5.3};
    const auto turned = [&](double from, double to) {
        std::vector<PlaneText> planes;
        const auto add = [&](const Vec3& axis, double low, double high) {
            planes.push_back({-axis, -(low + dot(axis, origin))});
            planes.push_back({axis, high + dot(axis, origin)});
        };
        add(u, from, to);
        add(v, 0, 64);
        add(w, 0, 96);
        return plane_brush(planes, "textures/a", "%.9g");
    };
    const BrushLevel level = read(world(turned(0, 32) + turned(32, 64))).value();
    ASSERT_EQ(level.sides.size(), 12u);
    EXPECT_EQ(level.sides[1].points[0], level.sides[6].points[0]);
    EXPECT_EQ(level.sides[1].points[1], level.sides[6].points[2]);
    EXPECT_LT(level.max_shift, 0.0003);
    EXPECT_NEAR(volume_of(level), 64 * 64 * 96 / 32768.0, 0.002);
    EXPECT_EQ(make_world(level).value().face_count(), 6u);
}

// A side of a box in points, and the same plane in numbers: the one on the grid wins.
TEST(ReadPrimitives, AllFormsInOneFile) {
    const std::string text = world(box({0, 0, 0}, {64, 32, 96}) + primitive_box({64, 0, 0}, {128, 32, 96}) +
                                   plane_brush(box_planes({128, 0, 0}, {192, 32, 96})));
    EXPECT_EQ(volume_of(read(text).value()), 18);
}

// Planes that only touch, or lie beyond, and a brush whose planes leave nothing.
TEST(ReadPrimitives, PlanesWithoutAFace) {
    std::vector<PlaneText> planes = box_planes({0, 0, 0}, {64, 32, 96});
    const double half = std::sqrt(0.5);
    planes.push_back({{half, half, 0}, half * 1000});
    planes.push_back({{-half, 0, -half}, 0});
    EXPECT_NEAR(volume_of(read(world(plane_brush(planes))).value()), 6, 1e-3);
    planes = box_planes({0, 0, 0}, {64, 32, 96});
    planes.push_back({{half, half, 0}, -50});
    planes.push_back({{-half, -half, 0}, -50});
    BrushWorldReport report;
    const Result<World> empty = make_world(read(world(plane_brush(planes))).value(), {}, &report);
    ASSERT_FALSE(empty.ok());
    EXPECT_EQ(empty.error().code, ErrorCode::kMalformed);
    EXPECT_NE(
        empty.error().reason.find("no face is left that a cast could meet; 1 brush, 0 of them portals or data; left "
                                  "out: brushes without volume: 1 (brush 0: "),
        std::string::npos)
        << empty.error().reason;
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_EQ(report.notes[0].what, BrushNote::What::kNoVolume);
}

std::string patch3(const std::string& size = "3 3 4 4 0 0 0") {
    std::string text = "{\npatchDef3\n{\n\"textures/a/curve\"\n( " + size + " )\n(\n";
    for (int x = 0; x < 3; ++x) {
        text += "( ";
        for (int y = 0; y < 3; ++y) text += "( " + std::to_string(64 * x) + " " + std::to_string(32 * y) + " 16 0 0 ) ";
        text += ")\n";
    }
    return text + ")\n}\n}\n";
}

TEST(ReadPrimitives, PatchDef3IsAPatch) {
    const BrushLevel level = read(world(patch3())).value();
    ASSERT_EQ(level.surfaces.faces.size(), 1u);
    EXPECT_EQ(level.surfaces.materials[level.surfaces.faces[0].material], "textures/a/curve");
    EXPECT_TRUE(level.notes.empty());
    EXPECT_EQ(error_of(world(patch3("3 3 0 0 0"))),
              "a.map:7: expected a number of a patch's size in brush 0 of entity 0, found ')'");
}

// In Doom 3's files what belongs to an entity stands relative to its origin; in others it does not.
TEST(ReadPrimitives, PlacedByTheEntitysOrigin) {
    const std::string rest = "{\n\"classname\" \"func_static\"\n\"origin\" \"320 64 -32\"\n" +
                             plane_brush(box_planes({0, 0, 0}, {32, 32, 32})) + patch3() + "}\n";
    const BrushLevel placed = read("Version 2\n" + world("") + rest).value();
    const World there = make_world(placed).value();
    EXPECT_EQ(there.bounds().low, (Vec3{10, 2, -1}));
    EXPECT_EQ(there.bounds().high, (Vec3{14, 4, 0}));
    EXPECT_EQ(make_world(read(world("") + rest).value()).value().bounds().low, (Vec3{0, 0, 0}));
    std::string turned = rest;
    turned.insert(turned.find("\"origin\""), "\"rotation\" \"0 1 0 -1 0 0 0 0 1\"\n");
    const BrushLevel data = read("Version 2\n" + world("") + turned).value();
    EXPECT_EQ(data.brushes[0].kind, BrushKind::kData);
    ASSERT_EQ(data.omissions.size(), 2u);
    EXPECT_EQ(data.omissions[0].what, "brushes of 'func_static'");
}

TEST(ReadPrimitives, ErrorsNameTheLine) {
    const std::string open = "{\n\"classname\" \"worldspawn\"\n{\n";
    EXPECT_EQ(error_of(open + "brushDef\n("),
              "a.map:5: expected { of a brush's sides in brush 0 of entity 0, found '('");
    EXPECT_EQ(error_of(open + "brushDef\n{\n( 1 2 3 ) ( 1 2 3 ) ( 1 2 3 ) a 0 0 0"),
              "a.map:6: expected ( of the texture's matrix in brush 0 of entity 0, found 'a'");
    EXPECT_EQ(error_of(open + "brushDef3\n{\n( 1 2 3 )"),
              "a.map:6: expected a number of a plane in brush 0 of entity 0, found ')'");
    EXPECT_EQ(error_of(open + "brushDef3\n{\n( 0 0 0 5 ) "), "a.map:6: a plane in brush 0 of entity 0 has no normal");
    EXPECT_EQ(error_of(open + "brushDef3\n{\n( 1e200 1e200 1e200 5 ) "),
              "a.map:6: a plane in brush 0 of entity 0 has no normal");
    EXPECT_EQ(error_of(open + "brushDef3\n{\n}\n"),
              "a.map:7: expected } of the brush in brush 0 of entity 0, the file ends");
    EXPECT_EQ(error_of(open + "brushDef3\n{\n\"key\" }\n"),
              "a.map:6: expected a value for the key 'key' in brush 0 of entity 0, found '}'");
    EXPECT_EQ(error_of(open + "brushDef3\n{\n( 1 0 0 -500000 ) " + kMatrix + "\"a\"\n}\n}\n}\n"),
              "a.map:6: entity 0 (worldspawn), brush 0: side 0: its plane lies outside the world");
    EXPECT_EQ(error_of("Version\n{\n}\n"), "a.map:2: expected a number of the version, found '{'");
}

// Truncated anywhere, or with bytes changed: an error with a place, or a level that can be joined.
TEST(ReadPrimitives, HostileBytes) {
    const double half = std::sqrt(0.5);
    std::vector<PlaneText> planes = box_planes({0, 0, 0}, {64, 32, 96});
    planes.push_back({{half, half, 0}, 50});
    const std::string text = "Version 2\n" +
                             world(primitive_box({64, 0, 0}, {128, 32, 96}) + plane_brush(planes) + patch3()) +
                             "{\n\"classname\" \"func_static\"\n\"origin\" \"1 2 3\"\n" + plane_brush(planes) + "}\n";
    std::size_t levels = 0;
    const auto judge = [&](const std::string& bytes) {
        const auto level = read(bytes);
        if (!level.ok()) {
            ASSERT_TRUE(level.error().place.starts_with("a.map")) << level.error().place;
            return;
        }
        ++levels;
        EXPECT_TRUE(make_world(level.value()).ok());
    };
    for (std::size_t k = 0; k < text.size(); k += 3) judge(text.substr(0, k));
    scenes::Rng rng(12);
    for (int round = 0; round < 1500; ++round) {
        std::string bytes = text;
        for (int change = 0; change < 1 + round % 4; ++change) {
            const auto at = std::size_t(rng.below(std::uint32_t(bytes.size())));
            constexpr char kBytes[] = "{}()[]\"\\/ \n09.-+eaZ\0\x1f\xff";
            bytes[at] = kBytes[rng.below(sizeof kBytes - 1)];
        }
        judge(bytes);
    }
    EXPECT_GT(levels, 200u);
}

}  // namespace
}  // namespace firma

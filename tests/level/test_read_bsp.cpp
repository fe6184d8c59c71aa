// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>

#include "firma/firma.h"
#include "scenes/rng.h"
#include "tests/level/bsp_writer.h"
#include "tests/level/face_corners.h"

namespace firma {
namespace {

using test::BspWriter;

constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();

Result<Level> read_written(const BspWriter& writer, const ReadOptions& options = {}) {
    return read_bsp(writer.bytes(), "map.bsp", options);
}

std::string error_of(const BspWriter& writer, const ReadOptions& options = {}) {
    const auto level = read_written(writer, options);
    return level ? "" : level.error().text();
}

// What every reader promises of its faces.
void expect_sound_surfaces(const Level& level) {
    for (const LevelFace& face : level.faces) {
        ASSERT_EQ(check_polygon(test::corners_of(level, face)), PolygonFault::kNone) << "face " << face.source;
        ASSERT_GE(face.corner_count, 3u);
        ASSERT_LE(face.corner_count, 64u);
        ASSERT_LT(face.source, level.source_faces);
        ASSERT_LT(face.material, level.materials.size());
        ASSERT_LT(face.group, level.groups.size());
    }
}

// A room of 320 units around the origin, faces inward.
BspWriter box_room() {
    BspWriter writer;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-160.0, 160.0}) {
            std::vector<Vec3> outline;
            for (const auto& [u, v] :
                 {std::pair{-160, -160}, std::pair{160, -160}, std::pair{160, 160}, std::pair{-160, 160}}) {
                Vec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = u;
                p[(axis + 2) % 3] = v;
                outline.push_back(p);
            }
            if (side > 0) std::reverse(outline.begin(), outline.end());
            writer.polygon(outline);
        }
    }
    return writer;
}

TEST(ReadBsp, OneTriangle) {
    BspWriter writer;
    writer.polygon({{0, 0, 0}, {32, 0, 0}, {0, 64, 0}});
    const Level level = read_written(writer).value();
    ASSERT_EQ(level.faces.size(), 1u);
    const LevelFace& face = level.faces[0];
    EXPECT_EQ(face.kind, FaceKind::kPolygon);
    EXPECT_EQ(face.source, 0u);
    EXPECT_FALSE(face.two_sided);
    EXPECT_EQ(level.materials[face.material], "textures/tests/wall");
    EXPECT_EQ(level.groups[face.group], "model 0");
    EXPECT_EQ(level.name, "map.bsp");
    EXPECT_EQ(level.source_faces, 1u);
    EXPECT_EQ(level.ignored_entries, 0u);
    EXPECT_TRUE(level.notes.empty());
    EXPECT_EQ(test::twice_area(test::corners_of(level, face)), (Vec3{0, 0, 2}));  // counter-clockwise, a thirty-second
}

TEST(ReadBsp, ScaleIsTheCallers) {
    BspWriter writer;
    writer.polygon({{0, 0, 0}, {32, 0, 0}, {0, 64, 0}});
    const Level level = read_written(writer, {.scale = 0.25}).value();
    EXPECT_EQ(test::twice_area(test::corners_of(level, level.faces[0])), (Vec3{0, 0, 128}));
    EXPECT_EQ(error_of(writer, {.scale = -1}), "map.bsp: scale -1 is not a positive number");
    EXPECT_EQ(error_of(writer, {.scale = INFINITY}), "map.bsp: scale inf is not a positive number");
    EXPECT_EQ(error_of(writer, {.scale = NAN}), "map.bsp: scale nan is not a positive number");
    EXPECT_EQ(error_of(writer, {.patch_tolerance = 0}), "map.bsp: patch tolerance 0 is not a positive number");
    EXPECT_EQ(error_of(writer, {.patch_tolerance = NAN}), "map.bsp: patch tolerance nan is not a positive number");
    EXPECT_EQ(read_written(writer, {.scale = -1}).error().code, ErrorCode::kInvalid);
}

TEST(ReadBsp, BoxRoomIsSixPolygonsThatFaceInward) {
    const Level level = read_written(box_room()).value();
    expect_sound_surfaces(level);
    ASSERT_EQ(level.faces.size(), 6u);
    EXPECT_EQ(level.vertices.size(), 8u);
    for (const LevelFace& face : level.faces) {
        EXPECT_EQ(face.corner_count, 4u);
        const auto corners = test::corners_of(level, face);
        EXPECT_LT(dot(test::twice_area(corners), corners[0]), 0);
    }
    const World world = make_world(level).value();
    for (const Face& face : world.faces())
        for (std::uint32_t edge = 0; edge < face.corners.size(); ++edge)
            EXPECT_TRUE(other_face(world, face.ref(), edge).valid());
    const Hit hit = cast(world, {{0, 0, 0}, 0.5}, {20, 0, 0});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.fraction, 4.5 / 20);
    EXPECT_EQ(hit.normal, (Vec3{-1, 0, 0}));
    EXPECT_EQ(world.face_info(hit.face)->source, 1u);
}

TEST(ReadBsp, CornersAlongASideAreKept) {
    BspWriter writer;
    writer.polygon({{0, 0, 0}, {32, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}, {0, 32, 0}});
    const Level level = read_written(writer).value();
    ASSERT_EQ(level.faces.size(), 1u);
    EXPECT_EQ(level.faces[0].corner_count, 6u);
    EXPECT_TRUE(level.notes.empty());
}

TEST(ReadBsp, VerticesOfTheirOwnForEachTriangleAreJoinedByPosition) {
    BspWriter writer;
    writer.triangles(BspFace::kPlanar, {{0, 0, 0}, {32, 0, 0}, {32, 32, 0}, {0, 0, 0}, {32, 32, 0}, {0, 32, -0.0}},
                     {{0, 1, 2}, {3, 4, 5}});
    const Level level = read_written(writer).value();
    ASSERT_EQ(level.faces.size(), 1u);
    EXPECT_EQ(level.faces[0].corner_count, 4u);
}

TEST(ReadBsp, ConcaveOutlineIsDividedAndNoted) {
    BspWriter writer;
    writer.triangles(BspFace::kPlanar, {{0, 0, 0}, {64, 0, 0}, {64, 32, 0}, {32, 32, 0}, {32, 64, 0}, {0, 64, 0}},
                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
    const Level level = read_written(writer).value();
    expect_sound_surfaces(level);
    EXPECT_EQ(level.faces.size(), 4u);
    EXPECT_EQ(level.count(FaceNote::kSplit), 1u);
    Vec3 area;
    for (const LevelFace& face : level.faces) area = area + test::twice_area(test::corners_of(level, face));
    EXPECT_EQ(area, (Vec3{0, 0, 2 * 3}));
}

TEST(ReadBsp, OutlineOfMoreThanSixtyFourCornersIsDivided) {
    std::vector<Vec3> outline;
    for (int k = 0; k < 40; ++k) outline.push_back({-800.0 + 20 * k + 20, double(k * k), 0});
    for (int k = 39; k >= 0; --k) outline.push_back({-800.0 + 20 * k + 20, 4000.0 - k * k, 0});
    BspWriter writer;
    writer.polygon(outline);
    const Level level = read_written(writer).value();
    expect_sound_surfaces(level);
    EXPECT_GT(level.faces.size(), 1u);
    EXPECT_EQ(level.count(FaceNote::kSplit), 1u);
}

// A planar face without a normal is bent terrain: another division of its outline would be another surface.
TEST(ReadBsp, BentPlanarFaceKeepsItsTriangles) {
    BspWriter writer;
    writer.triangles(BspFace::kPlanar, {{0, 0, 0}, {32, 0, 0}, {32, 32, 8}, {0, 32, 0}}, {{0, 1, 2}, {0, 2, 3}},
                     {0, 0, 0});
    const Level level = read_written(writer).value();
    ASSERT_EQ(level.faces.size(), 2u);
    EXPECT_EQ(test::corners_of(level, level.faces[1])[1], (Vec3{1, 1, 0.25}));
    EXPECT_EQ(level.faces[1].source, 0u);
    EXPECT_TRUE(level.notes.empty());

    // Nor does a normal make it flat.
    writer.faces[0].normal = {0, 0, 1};
    EXPECT_EQ(read_written(writer).value().faces.size(), 2u);
    EXPECT_TRUE(read_written(writer).value().notes.empty());
    writer.faces[0].normal = {0, 0, NAN};
    EXPECT_EQ(read_written(writer).value().faces.size(), 2u);
    EXPECT_TRUE(read_written(writer).value().notes.empty());
}

TEST(ReadBsp, SoupsStaySoups) {
    BspWriter writer = box_room();
    writer.triangles(BspFace::kSoup, {{0, 0, 0}, {32, 0, 0}, {32, 32, 0}, {0, 32, 0}},
                     {{0, 1, 2}, {0, 2, 3}, {0, 0, 3}});
    const Level level = read_written(writer).value();
    ASSERT_EQ(level.faces.size(), 8u);
    EXPECT_EQ(level.faces[7].kind, FaceKind::kTriangleSoup);
    EXPECT_EQ(level.faces[7].source, 6u);
    EXPECT_TRUE(level.notes.empty());  // one triangle of three has no area: the face has
}

TEST(ReadBsp, FaceWithoutAreaIsNotedOnce) {
    BspWriter writer = box_room();
    writer.triangles(BspFace::kPlanar, {{0, 0, 0}, {32, 0, 0}, {64, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 2, 3}});
    writer.triangles(BspFace::kSoup, {{0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}}, {{0, 1, 2}, {1, 2, 0}});
    writer.patch(3, 3, std::vector<Vec3>(9, Vec3{1, 2, 3}));
    const Level level = read_written(writer).value();
    EXPECT_EQ(level.faces.size(), 6u);
    ASSERT_EQ(level.notes.size(), 3u);
    for (std::uint32_t k = 0; k < 3; ++k) {
        EXPECT_EQ(level.notes[k].what, FaceNote::kNoArea);
        EXPECT_EQ(level.notes[k].source, 6 + k);
    }
}

TEST(ReadBsp, IgnoresFlaresOtherModelsAndEmptyFaces) {
    BspWriter writer;
    writer.polygon({{500, 0, 0}, {532, 0, 0}, {500, 64, 0}}).type = 99;  // of another model: not looked at
    writer.polygon({{0, 0, 0}, {32, 0, 0}, {0, 64, 0}});
    BspFace flare;
    flare.type = BspFace::kFlare;
    flare.shader = -1;
    writer.faces.push_back(flare);
    BspFace empty;
    empty.type = BspFace::kPlanar;
    writer.faces.push_back(empty);
    writer.models = {{1, 3}, {0, 1}};
    const Level level = read_written(writer).value();
    ASSERT_EQ(level.faces.size(), 1u);
    EXPECT_EQ(level.faces[0].source, 1u);
    EXPECT_EQ(level.source_faces, 4u);
    EXPECT_EQ(level.ignored_entries, 3u);
    ASSERT_EQ(level.omissions.size(), 1u);
    EXPECT_EQ(level.omissions[0].what, "surfaces of models other than the first");
    EXPECT_EQ(level.omissions[0].count, 1u);
    EXPECT_EQ(level.vertices.size(), 3u);
}

TEST(ReadBsp, MaterialsAreShaderNamesAsUsed) {
    BspWriter writer = box_room();
    writer.shader("textures/unused");
    writer.faces[3].shader = writer.shader("textures/skies/blue");
    const Level level = read_written(writer).value();
    EXPECT_EQ(level.materials, (std::vector<std::string>{"", "textures/tests/wall", "textures/skies/blue"}));
    EXPECT_EQ(level.materials[level.faces[3].material], "textures/skies/blue");
}

// A quarter of a tube of radius 128 units around z, front outward.
std::vector<Vec3> quarter_tube(double height) {
    std::vector<Vec3> control;
    for (const double z : {0.0, height / 2, height}) {
        for (const Vec3& p : {Vec3{128, 0, z}, Vec3{128, 128, z}, Vec3{0, 128, z}}) control.push_back(p);
    }
    return control;
}

TEST(ReadBsp, PatchIsWithinToleranceOfItsCurve) {
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        BspWriter writer;
        writer.patch(3, 3, quarter_tube(64));
        const Level level = read_written(writer, {.patch_tolerance = tolerance}).value();
        expect_sound_surfaces(level);
        EXPECT_TRUE(level.notes.empty());
        double stray = 0;
        for (const LevelFace& face : level.faces) {
            EXPECT_EQ(face.kind, FaceKind::kPatch);
            EXPECT_EQ(face.corner_count, 4u);  // straight up: each cell is flat, and whole
            const auto corners = test::corners_of(level, face);
            const Vec3 outward = {corners[0].x + corners[1].x, corners[0].y + corners[1].y, 0};
            EXPECT_GT(dot(test::twice_area(corners), outward), 0);
            for (int k = 0; k <= 16; ++k) {
                // The curve is where sqrt(4 - x) and sqrt(4 - y) sum to 2, in metres.
                const Vec3 p = corners[0] + (k / 16.0) * (corners[1] - corners[0]);
                const double x = 4 - p.x, y = 4 - p.y, root = std::sqrt(x) + std::sqrt(y) - 2;
                const double slope = x > 0 && y > 0 ? std::hypot(0.5 / std::sqrt(x), 0.5 / std::sqrt(y)) : INFINITY;
                stray = std::max(stray, std::fabs(root) / slope);
            }
        }
        EXPECT_LE(stray, tolerance * 1.02 + 0.0002);  // and the snap
        EXPECT_GT(stray, tolerance / 4);
    }
}

// Two patches on one curve, one straight above the other bent, in all ways round: every inner edge has both its faces.
TEST(ReadBsp, PatchesThatShareACurveLeaveNoCrack) {
    const std::vector<Vec3> below = quarter_tube(64);
    std::vector<Vec3> above(below.begin() + 6, below.end());
    for (int row = 1; row < 3; ++row) {
        for (int k = 0; k < 3; ++k)
            above.push_back(below[std::size_t(k)] * (1 + 0.7 * row * k) + Vec3{0, 0, 64.0 + 50 * row});
    }
    for (const bool transposed : {false, true}) {
        for (const bool reversed : {false, true}) {
            std::vector<Vec3> other(9);
            for (std::size_t y = 0; y < 3; ++y) {
                for (std::size_t x = 0; x < 3; ++x) other[transposed ? 3 * x + y : 3 * y + x] = above[3 * y + x];
            }
            if (reversed) std::reverse(other.begin(), other.end());
            BspWriter writer;
            writer.patch(3, 3, below);
            writer.patch(3, 3, other);
            const Level level = read_written(writer).value();
            expect_sound_surfaces(level);
            // Edges at z = 2 m, undirected: the other way of winding, when transposed, is no crack.
            std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
            for (const LevelFace& face : level.faces) {
                for (std::uint32_t k = 0; k < face.corner_count; ++k) {
                    const std::uint32_t a = level.corners[face.first_corner + k];
                    const std::uint32_t b = level.corners[face.first_corner + (k + 1) % face.corner_count];
                    if (to_metres(level.vertices[a]).z == 2 && to_metres(level.vertices[b]).z == 2)
                        ++uses[std::minmax(a, b)];
                }
            }
            EXPECT_GT(uses.size(), 4u);
            for (const auto& [edge, count] : uses) EXPECT_EQ(count, 2);
        }
    }
}

TEST(ReadBsp, PatchThatComesToAPointIsTriangles) {
    BspWriter writer;
    std::vector<Vec3> control(3, Vec3{0, 0, 100});
    for (const double s : {0.5, 1.0}) {
        for (const Vec3& p : {Vec3{64, 0, 0}, Vec3{64, 64, 0}, Vec3{0, 64, 0}})
            control.push_back(s * p + Vec3{0, 0, 100 - 100 * s});
    }
    writer.patch(3, 3, control);
    const Level level = read_written(writer).value();
    expect_sound_surfaces(level);
    EXPECT_GT(level.faces.size(), 4u);
    EXPECT_TRUE(level.notes.empty());
}

TEST(ReadBsp, ErrorsNameLumpAndEntry) {
    const auto broken = [](auto&& change) {
        BspWriter writer = box_room();
        writer.patch(3, 3, quarter_tube(64));
        change(writer);
        return error_of(writer);
    };
    EXPECT_EQ(broken([](BspWriter&) {}), "");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].first_vertex = 99; }),
              "map.bsp: lump 13 (faces), entry 2: 4 vertices from number 99 on, of 33");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].first_vertex = -1; }),
              "map.bsp: lump 13 (faces), entry 2: 4 vertices from number -1 on, of 33");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].vertex_count = kMost; }),
              "map.bsp: lump 13 (faces), entry 2: 2147483647 vertices from number 8 on, of 33");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].vertex_count = -4; }),
              "map.bsp: lump 13 (faces), entry 2: -4 vertices");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].first_mesh_vertex = 32; }),
              "map.bsp: lump 13 (faces), entry 2: 6 mesh vertices from number 32 on, of 36");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].first_mesh_vertex = -7; }),
              "map.bsp: lump 13 (faces), entry 2: 6 mesh vertices from number -7 on, of 36");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].mesh_vertex_count = kMost; }),
              "map.bsp: lump 13 (faces), entry 2: 2147483647 mesh vertices from number 12 on, of 36");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].mesh_vertex_count = -3; }),
              "map.bsp: lump 13 (faces), entry 2: -3 mesh vertices");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].mesh_vertex_count = 5; }),
              "map.bsp: lump 13 (faces), entry 2: 5 mesh vertices are not whole triangles");
    EXPECT_EQ(broken([](BspWriter& w) { w.mesh_vertices[13] = 4; }),
              "map.bsp: lump 11 (mesh vertices), entry 13: vertex 4 of the 4 of face 2");
    EXPECT_EQ(broken([](BspWriter& w) { w.mesh_vertices[13] = -1; }),
              "map.bsp: lump 11 (mesh vertices), entry 13: vertex -1 of the 4 of face 2");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].shader = 1; }), "map.bsp: lump 13 (faces), entry 2: shader 1 of 1");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].shader = -1; }),
              "map.bsp: lump 13 (faces), entry 2: shader -1 of 1");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[2].type = 5; }),
              "map.bsp: lump 13 (faces), entry 2: type 5; types are 1 to 4");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[6].patch_width = 4; }),
              "map.bsp: lump 13 (faces), entry 6: patch of 4 x 3 control points; both must be odd and 3 or more");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[6].patch_height = -3; }),
              "map.bsp: lump 13 (faces), entry 6: patch of 3 x -3 control points; both must be odd and 3 or more");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[6].patch_height = w.faces[6].patch_width = kMost; }),
              "map.bsp: lump 13 (faces), entry 6: patch of 2147483647 x 2147483647 control points, but 9 vertices");
    EXPECT_EQ(broken([](BspWriter& w) { w.vertices[7].y = NAN; }), "map.bsp: lump 10 (vertices), entry 7: y is nan");
    EXPECT_EQ(broken([](BspWriter& w) { w.vertices[7].z = -INFINITY; }),
              "map.bsp: lump 10 (vertices), entry 7: z is -inf");
    EXPECT_EQ(broken([](BspWriter& w) { w.vertices[7].x = 262144; }),
              "map.bsp: lump 10 (vertices), entry 7: lies outside the world: x = 8192 m");
    EXPECT_EQ(broken([](BspWriter& w) {
                  w.models[0].first_face = 5;
                  w.models[0].face_count = 3;
              }),
              "map.bsp: lump 7 (models), entry 0: 3 faces from number 5 on, of 7");
    EXPECT_EQ(broken([](BspWriter& w) { w.models[0].face_count = kMost; }),
              "map.bsp: lump 7 (models), entry 0: 2147483647 faces from number 0 on, of 7");
    EXPECT_EQ(broken([](BspWriter& w) { w.models.clear(); }),
              "map.bsp: lump 7 (models): is empty; the first model is the level");
    EXPECT_EQ(broken([](BspWriter& w) { w.models[0].face_count = 0; }),
              "map.bsp: lump 13 (faces): the first model has no surface to cast against");
}

TEST(ReadBsp, ErrorsHaveTheRightCode) {
    BspWriter writer = box_room();
    writer.vertices[0].x = NAN;
    EXPECT_EQ(read_written(writer).error().code, ErrorCode::kOutOfRange);
    writer = box_room();
    writer.faces[0].type = 0;
    EXPECT_EQ(read_written(writer).error().code, ErrorCode::kMalformed);
}

// Many faces that name the same many mesh vertices: the file is small, what it asks for is not.
TEST(ReadBsp, CountsAreLimitedBeforeMemoryIsTaken) {
    BspWriter writer;
    writer.triangles(BspFace::kSoup, {{0, 0, 0}, {32, 0, 0}, {32, 32, 0}}, {{0, 1, 2}});
    writer.mesh_vertices.resize(30000);
    writer.faces[0].mesh_vertex_count = 30000;
    writer.faces.resize(200, writer.faces[0]);
    EXPECT_EQ(error_of(writer), "map.bsp: lump 13 (faces), entry 139: surfaces have more than 4194304 corners in all");
    EXPECT_EQ(read_written(writer).error().code, ErrorCode::kTooLarge);

    BspWriter patches;
    std::vector<Vec3> control;
    for (int k = 0; k < 9; ++k) control.push_back({double(k * 77 % 13), double(k * 37 % 11), double(k * k * 7 % 17)});
    patches.patch(3, 3, control);
    patches.faces.resize(2000, patches.faces[0]);
    EXPECT_EQ(
        error_of(patches, {.patch_tolerance = 1e-12}),
        "map.bsp: lump 13 (faces): patches come to more than 4194304 cells at this tolerance; a larger patch_tolerance "
        "makes fewer");
}

TEST(ReadBsp, EveryTruncationIsAnError) {
    const auto bytes = box_room().bytes();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const auto level = read_bsp(std::span(bytes).first(size), "map.bsp");
        ASSERT_FALSE(level.ok()) << size;
        EXPECT_TRUE(level.error().place.starts_with("map.bsp"));
    }
}

// Whatever four bytes are changed to: a sound level or an error, here and in the check.
TEST(ReadBsp, ChangedBytesAreAnswered) {
    BspWriter writer = box_room();
    writer.patch(3, 3, quarter_tube(64));
    writer.triangles(BspFace::kSoup, {{0, 0, 0}, {32, 0, 0}, {32, 32, 0}}, {{0, 1, 2}});
    const auto sound = writer.bytes();
    constexpr std::array<std::int32_t, 8> kValues = {
        -1, 0, 1, 2, 3, kMost, std::numeric_limits<std::int32_t>::min(), 0x7f800000};
    scenes::Rng rng(3);
    int read_well = 0;
    for (std::size_t at = 0; at + 4 <= sound.size(); at += 4) {
        for (const std::int32_t value : kValues) {
            auto bytes = sound;
            test::poke(bytes, at, value);
            if (rng.chance(0.3))
                test::poke(bytes, 4 * rng.below(std::uint32_t(bytes.size() / 4)), kValues[rng.below(8)]);
            const auto level = read_bsp(bytes, "map.bsp");
            const auto check = check_bsp(bytes, "map.bsp");
            ASSERT_EQ(level.ok(), check.ok());
            read_well += level.ok();
            if (level.ok()) {
                expect_sound_surfaces(level.value());
            } else {
                EXPECT_TRUE(level.error().place.starts_with("map.bsp")) << level.error().text();
                EXPECT_EQ(level.error().text(), check.error().text());
            }
        }
    }
    EXPECT_GT(read_well, 100);
}

TEST(ReadBsp, ReadsByEnding) {
    const auto path = std::filesystem::temp_directory_path() / "firma_test_read.BSP";
    const auto bytes = box_room().bytes();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ptrdiff_t(bytes.size()));
    const auto level = read_level(path.string());
    std::filesystem::remove(path);
    ASSERT_TRUE(level.ok()) << level.error().text();
    EXPECT_EQ(level.value().faces.size(), 6u);
}

}  // namespace
}  // namespace firma

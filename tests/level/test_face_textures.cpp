// SPDX-License-Identifier: MIT
// Texture coordinates of corners, of .obj, .bsp and meshes in memory: as projections of faces, through cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/memory.h"
#include "firma/mesh.h"
#include "firma/rooms.h"
#include "firma/triangles.h"
#include "firma/world.h"
#include "level/fit_texture.h"
#include "tests/level/bsp_writer.h"

namespace firma {
namespace {

TextureProjection texture_at(const World& world, const Vec3& on) {
    for (const Face& face : world.faces()) {
        // A point of the face: a little inside of all its sides.
        bool inside = std::fabs(dot(on - face.corners[0], face.normal)) < 1e-9;
        for (std::size_t k = 0; k < face.corners.size() && inside; ++k) {
            const Vec3 &from = face.corners[k], &to = face.corners[(k + 1) % face.corners.size()];
            inside = dot(cross(to - from, on - from), face.normal) > 0;
        }
        if (!inside) continue;
        const std::optional<TextureProjection> found = texture_of(world, face.ref());
        EXPECT_TRUE(found);
        return found.value_or(TextureProjection{});
    }
    ADD_FAILURE() << "no face there";
    return {};
}

void expect_near(const TexturePoint& made, double u, double v) {
    EXPECT_NEAR(made[0], u, 1e-9);
    EXPECT_NEAR(made[1], v, 1e-9);
}

TEST(FitTexture, ThroughThreeCornersExactly) {
    const std::vector<Vec3> corners{{1, 2, 3}, {5, 2, 3}, {1, 4, 7}};
    const std::vector<TexturePoint> uvs{{0.25, 7}, {-1, 3}, {2, 2}};
    const TextureProjection map = fit_texture(corners, uvs).value();
    for (std::size_t k = 0; k < 3; ++k) expect_near(map.at(corners[k]), uvs[k][0], uvs[k][1]);
    EXPECT_EQ(map.unit, TextureUnit::kRepeats);
    EXPECT_NEAR(dot(map.u_axis, cross(corners[1] - corners[0], corners[2] - corners[0])), 0, 1e-12);
}

TEST(FitTexture, OfMoreCornersWhereTheyAgree) {
    std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 3, 0}, {0, 2, 0}};
    std::vector<TexturePoint> uvs;
    for (const Vec3& p : corners) uvs.push_back({p.x / 2 + p.y, 3 - p.y});
    ASSERT_TRUE(fit_texture(corners, uvs));
    uvs[3][0] += 1.0 / 600;
    EXPECT_FALSE(fit_texture(corners, uvs));
    uvs[3][0] -= 1.0 / 600;
    corners[3].x += 0.0004;  // as a snap does, however finely the texture is laid
    for (TexturePoint& uv : uvs) uv = {uv[0] * 100, uv[1] * 100};
    EXPECT_TRUE(fit_texture(corners, uvs));
    corners[3].x += 0.004;
    EXPECT_FALSE(fit_texture(corners, uvs));
    EXPECT_TRUE(fit_texture(corners, uvs, 0.01));
}

TEST(FitTexture, NothingOnALineOrBeyondNumbers) {
    const std::vector<TexturePoint> uvs{{0, 0}, {1, 0}, {0, 1}};
    EXPECT_FALSE(fit_texture(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, uvs));
    EXPECT_FALSE(fit_texture(std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, uvs));
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_FALSE(fit_texture(corners, std::vector<TexturePoint>{{0, 0}, {1e300, 0}, {0, 1}}));
    EXPECT_FALSE(fit_texture(corners, std::vector<TexturePoint>{{0, 0}, {NAN, 0}, {0, 1}}));
}

TEST(BoxProjection, AlongTheNearestAxisAndNeverMirrored) {
    for (const Vec3& normal : {Vec3{1, 0.2, -0.3}, {-3, 1, 2}, {0, 1, 0}, {0.1, -5, 4}, {0, 0, 2}, {0.5, 0.5, -0.7}}) {
        const TextureProjection box = box_projection(normal);
        EXPECT_EQ(box.unit, TextureUnit::kMetres);
        EXPECT_GT(dot(cross(box.u_axis, -box.v_axis), normal), 0) << "to the right, up, toward the eye";
        EXPECT_EQ(length(box.u_axis), 1);
        EXPECT_EQ(length(box.v_axis), 1);
    }
    EXPECT_EQ(box_projection({1, 1, 1}).v_axis, (Vec3{0, -1, 0})) << "z first";
    EXPECT_EQ(box_projection({1, 1, 0}).u_axis, (Vec3{0, 1, 0})) << "then x";
    EXPECT_TRUE(is_usable(box_projection({NAN, 0, 0})));
}

// ---- .obj ----

const std::string kTent =  // a quad, a triangle, a triangle without coordinates, a quad that no one map fits
    "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 0 0 1\nv 8 0 0\nv 8 2 0\nv 0 4 0\nv 4 4 0\n"
    "vt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\nvt 1 0.5 0\nvt x y\nvt 3\n"
    "f 1/1 2/2 3/3 4/4\nf 1/1/1 2/-6/1 5/5/1\nf 1/6 2/2 5/5\nf 2/1 6/2 7/3 3/5\nf 4 3 9 8\nf 4/99 3/1 9/2 8/3\n";

TEST(ObjTextures, CornersHaveTheirCoordinates) {
    const Level level = read_obj("vn 0 0 1\n" + kTent, "a.obj").value();
    ASSERT_EQ(level.faces.size(), 7u) << "one quad is divided";
    const auto map = [&](std::size_t face) { return level.textures.at(level.faces[face].texture); };
    // v points up in the file, down here.
    expect_near(map(0).at({4, 2, 0}), 2, 1 - 1);
    expect_near(map(0).at({2, 1, 0}), 1, 1 - 0.5);
    expect_near(map(1).at({4, 0, 0}), 2, 1 - 0);
    expect_near(map(1).at({0, 0, 1}), 1, 1 - 0.5);
    EXPECT_EQ(level.faces[2].texture, kNoTexture) << "x is no number";
    EXPECT_EQ(level.faces[5].texture, kNoTexture);
    EXPECT_EQ(level.faces[6].texture, kNoTexture) << "there is no 99";
    EXPECT_EQ(level.count(FaceNote::kTexture), 1u);
    EXPECT_EQ(level.notes[0].source, 3u);
    EXPECT_EQ(level.faces[3].source, 3u);
    EXPECT_EQ(level.faces[4].source, 3u);
    // Each triangle fits its own corners.
    for (const std::size_t face : {3u, 4u})
        for (std::uint32_t c = 0; c < 3; ++c) {
            const Vec3 p = to_metres(level.vertices[level.corners[level.faces[face].first_corner + c]]);
            const double u = p.y == 0 ? (p.x == 4 ? 0 : 2) : p.x == 4 ? 1 : 2;
            const double v = p.y == 0 ? 0 : p.x == 4 ? 0.5 : 1;
            expect_near(map(face).at(p), u, 1 - v);
        }
}

TEST(ObjTextures, PiecesOfAFaceAreToldApartByTheirPlace) {
    const World world = make_world(read_obj(kTent, "a.obj").value()).value();
    expect_near(texture_at(world, {1, 1, 0}).at({0, 0, 0}), 0, 1);
    // Either side of the diagonal of the quad from (4, 0) to (8, 2), whichever it is.
    const TextureProjection low = texture_at(world, {6, 0.25, 0}), high = texture_at(world, {6, 1.75, 0});
    EXPECT_FALSE(low == high);
    expect_near(low.at({6, 0, 0}), 1, 1);
    expect_near(high.at({6, 2, 0}), 1.5, 1 - 0.75);
    for (const Face& face : world.faces()) {
        if (face.source == 4) {
            EXPECT_FALSE(texture_of(world, face.ref()));
        }
    }
    EXPECT_FALSE(texture_of(world, FaceRef{}));
    EXPECT_FALSE(texture_of(World(), world.faces()[0].ref()));
}

/// A box in rock, each wall of it a quad from (0, 0) to (1, 1) in repeats.
std::string papered_room(bool warped) {
    std::string text;
    for (int k = 0; k < 8; ++k)
        for (int axis = 0; axis < 3; ++axis)
            text += (axis == 0 ? "v " : " ") + std::string(k >> axis & 1 ? "8" : "0") + (axis == 2 ? "\n" : "");
    text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.75\n";
    constexpr int kSides[6][4] = {{2, 4, 3, 1}, {7, 8, 6, 5}, {5, 6, 2, 1}, {4, 8, 7, 3}, {3, 7, 5, 1}, {6, 8, 4, 2}};
    for (const auto& side : kSides) {
        text += "f";
        for (int k = 0; k < 4; ++k)
            text += " " + std::to_string(side[k]) + "/" + std::to_string(warped && k == 2 ? 5 : k + 1);
        text += "\n";
    }
    return text;
}

TEST(ObjTextures, SurviveCutsWholeOrInPieces) {
    for (const bool warped : {false, true}) {
        World world = make_world(read_obj(papered_room(warped), "room.obj").value()).value();
        ASSERT_EQ(world.face_count(), warped ? 12u : 6u);
        ASSERT_EQ(world.solid().face_count(), world.face_count());
        const TextureProjection one = texture_at(world, {6, 2.5, 0}), other = texture_at(world, {2.5, 6, 0});
        EXPECT_EQ(one == other, !warped);
        world = carve(world, make_crater(CutterShape::kRocky, 5), {.position = {4, 4, 0}, .scale = 2}).world;
        ASSERT_EQ(world.solid().edits(), 1u);
        std::size_t pieces = 0;
        for (const Face& face : world.faces()) {
            const std::optional<TextureProjection> lies = texture_of(world, face.ref());
            EXPECT_EQ(lies.has_value(), face.source_edit == 0);
            if (!lies || face.normal.z < 0.9) continue;
            ++pieces;
            Vec3 middle;
            for (const Vec3& corner : face.corners) middle = middle + corner * (1.0 / double(face.corners.size()));
            // By the diagonal between the corners that were not warped; without, both are one.
            EXPECT_TRUE(*lies == (middle.x > middle.y ? one : other)) << middle.x << " " << middle.y;
        }
        EXPECT_GT(pieces, 6u);
    }
}

TEST(ObjTextures, AreLeftOutOnRequest) {
    const Level level = read_obj(papered_room(true), "room.obj").value();
    WorldOptions without;
    without.textures = false;
    const World kept = make_world(level).value(), bare = make_world(level, without).value();
    EXPECT_TRUE(texture_of(kept, kept.faces()[0].ref()));
    EXPECT_FALSE(texture_of(bare, bare.faces()[0].ref()));
    EXPECT_EQ(hash_world(kept), hash_world(bare));
    const std::size_t bytes = memory_used({&kept, 1}) - memory_used({&bare, 1});
    EXPECT_GT(bytes, 12 * sizeof(TextureProjection));
    EXPECT_LT(bytes, 12 * sizeof(TextureProjection) + 2000);
    const World cut = carve(kept, make_crater(CutterShape::kBox, 1), {.position = {4, 4, 0}}).world;
    const World bare_cut = carve(bare, make_crater(CutterShape::kBox, 1), {.position = {4, 4, 0}}).world;
    EXPECT_EQ(memory_used(std::vector{kept, cut}) - memory_used(std::vector{bare, bare_cut}), bytes)
        << "versions share them";
}

TEST(ObjTextures, StayWherePortalsDivideTheLevel) {
    const Level level = read_obj(papered_room(false), "room.obj").value();
    const LevelPortal portal{"middle", {{*snap({4, 0, 0}), *snap({4, 8, 0}), *snap({4, 8, 8}), *snap({4, 0, 8})}}};
    const World world = make_divided_world(level, {&portal, 1}).value();
    ASSERT_EQ(world.room_count(), 2u);
    const World plain = make_world(level).value();
    for (const double x : {1.0, 7.0}) EXPECT_TRUE(texture_at(world, {x, 3, 0}) == texture_at(plain, {3, 3, 0}));
}

// ---- meshes in memory ----

TEST(MeshTextures, OneACorner) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    const std::vector<std::uint32_t> corners{0, 1, 2, 3}, counts{4};
    std::vector<TexturePoint> uvs{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Mesh mesh;
    mesh.vertices = vertices;
    mesh.corners = corners;
    mesh.corner_counts = counts;
    mesh.uvs = uvs;
    const World world = make_world(level_from_mesh(mesh, "m").value()).value();
    expect_near(texture_at(world, {1, 0.5, 0}).at({1, 0.5, 0}), 0.5, 0.5);
    const TriangleMesh made = triangles_of(world, {.uvs = true});
    ASSERT_EQ(made.uvs.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_FLOAT_EQ(made.uvs[k][0], made.positions[k][0] / 2);
        EXPECT_FLOAT_EQ(made.uvs[k][1], made.positions[k][1]);
    }
    EXPECT_EQ(made.sources[0].uv_unit, TextureUnit::kRepeats);
    mesh.uvs = std::span(uvs).first(3);
    EXPECT_EQ(level_from_mesh(mesh, "m").error().text(), "m: has 3 texture coordinates for 4 corners");
    uvs[2][1] = INFINITY;
    mesh.uvs = uvs;
    EXPECT_EQ(level_from_mesh(mesh, "m").error().text(), "m: face 0: has texture coordinates that are not finite");
}

TEST(MeshTextures, ALevelFilledByHandIsJudged) {
    Level level = read_obj(papered_room(false), "a.obj").value();
    level.faces[2].texture = 99;
    EXPECT_EQ(make_world(level).error().text(),
              "a.obj: face 2: its texture 99 is not there: there are " + std::to_string(level.textures.size()));
    level.faces[2].texture = kNoTexture;
    EXPECT_TRUE(make_world(level).ok());
    level.textures[0].v_axis.y = 1e30;
    EXPECT_EQ(make_world(level).error().text(), "a.obj: texture 0: its numbers are not finite, or too large");
}

// ---- .bsp ----

TEST(BspTextures, SurfacesHaveThoseOfTheirVertices) {
    test::BspWriter file;
    file.polygon({{0, 0, 0}, {64, 0, 0}, {64, 32, 0}, {0, 32, 0}});
    std::vector<Vec3> control;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) control.push_back({100.0 + 32 * x, 32.0 * y, x == 1 ? 20.0 : 0.0});
    file.patch(3, 3, control);
    for (const Vec3& vertex : file.vertices) file.uvs.push_back({float(vertex.x / 64), float(2 - vertex.y / 32)});
    const World world = make_world(read_bsp(file.bytes(), "a.bsp").value()).value();
    std::size_t of_patch = 0;
    for (const Face& face : world.faces()) {
        const TextureProjection lies = texture_of(world, face.ref()).value();
        of_patch += face.source == 1;
        for (const Vec3& corner : face.corners) {
            EXPECT_NEAR(lies.at(corner)[0], corner.x * 32 / 64, 2e-3);
            EXPECT_NEAR(lies.at(corner)[1], 2 - corner.y, 2e-3);
        }
    }
    EXPECT_EQ(world.face_count() - of_patch, 1u) << "its triangles are one face, as their coordinates agree";
    EXPECT_GT(of_patch, 2u);
    file.uvs[2][0] = 40;
    const Level bent = read_bsp(file.bytes(), "a.bsp").value();
    EXPECT_EQ(bent.count(FaceNote::kTexture), 1u);
    file.uvs[2][0] = NAN;
    const Level broken = read_bsp(file.bytes(), "a.bsp").value();
    EXPECT_EQ(broken.faces[0].texture, kNoTexture);
    EXPECT_NE(broken.faces[1].texture, kNoTexture);
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// Slivers along an edge of a cube, which the snap flattens: without them the cube is closed, and can be carved.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/world.h"

namespace firma {
namespace {

/// A cube of 4 m, less its front (y = 0) and top; corners 1 to 8, then what the test adds.
std::string cube(const std::string& vertices, const std::string& faces) {
    return "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 4\nv 4 0 4\nv 4 4 4\nv 0 4 4\n" + vertices +
           "f 4 3 2 1\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n" + faces;
}

Level read_text(const std::string& text) {
    return read_obj(text, "cube").value();
}

std::size_t solid_faces(const World& world) {
    const std::vector<Face> faces = world.faces();
    return std::size_t(std::count_if(faces.begin(), faces.end(), [](const Face& face) { return face.solid; }));
}

void expect_closed_cube(const Level& level, std::size_t dropped, std::size_t corners_on_edge) {
    EXPECT_EQ(level.count(FaceNote::kNoArea), dropped);
    EXPECT_EQ(level.faces.size(), 6u);
    EXPECT_EQ(level.corners.size(), 24 + 2 * corners_on_edge);  // the front's and the top's
    const World world = make_world(level).value();
    EXPECT_FALSE(check_world(world));
    EXPECT_EQ(solid_faces(world), 6u);
    const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, 1), {{2, 0, 4}, random_turn(1), 1});
    EXPECT_TRUE(cut.done()) << cut.error.text();
    EXPECT_FALSE(check_world(cut.world));
    EXPECT_EQ(solid_faces(cut.world), cut.world.face_count());
}

TEST(MendDropped, ASliver) {
    expect_closed_cube(read_text(cube("v 2 0.00001 4\n", "f 1 2 6 5\nf 5 9 6 7 8\nf 5 6 9\n")), 1, 1);
}

TEST(MendDropped, ASliverBesideASliver) {
    expect_closed_cube(
        read_text(cube("v 1 0.00001 4\nv 3 0.00001 4\n", "f 1 2 6 5\nf 5 9 10 6 7 8\nf 5 6 9\nf 9 6 10\n")), 2, 2);
}

TEST(MendDropped, ASliverOfManyCorners) {
    expect_closed_cube(read_text(cube("v 1 0.00001 4\nv 2 0.00002 4\nv 3 0.00001 4\n",
                                      "f 1 2 6 5\nf 5 9 10 11 6 7 8\nf 5 6 11 10 9\n")),
                       1, 3);
}

TEST(MendDropped, WhatWasOpenStaysOpen) {
    // No sliver between: a T-joint of the file's own, for `firma check` to report.
    const Level level = read_text(cube("v 2 0 4\n", "f 1 2 6 5\nf 5 9 6 7 8\n"));
    EXPECT_EQ(level.corners.size(), 25u);
    EXPECT_EQ(solid_faces(make_world(level).value()), 0u);
    // A sliver that belongs to nothing changes nothing.
    EXPECT_EQ(read_text(cube("v 1 9 9\nv 2 9 9\nv 3 9 9\n", "f 1 2 6 5\nf 5 6 7 8\nf 9 10 11\n")).corners.size(), 24u);
}

TEST(MendDropped, NoFaceGetsMoreThan64Corners) {
    // The top has 60 corners on one edge and 4 others; a sliver beside it would give it two more.
    std::string vertices, top = "f 5";
    for (int k = 1; k <= 62; ++k) vertices += "v " + std::to_string(k * 0.0625) + " 0 4\n";
    for (int k = 1; k <= 60; ++k) top += ' ' + std::to_string(8 + k);
    const Level level = read_text(cube(vertices, "f 1 2 6 5\n" + top + " 6 7 8\nf 6 68 69 70\n"));
    EXPECT_EQ(level.count(FaceNote::kNoArea), 1u);
    for (const LevelFace& face : level.faces) EXPECT_LE(face.corner_count, 64u);
    EXPECT_TRUE(make_world(level).ok());
}

}  // namespace
}  // namespace firma

// SPDX-License-Identifier: MIT
// What is written reads back, and what cannot be written leaves nothing behind. `firma check` judges more of it in
// tests/cli/test_carve.py.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/save.h"

namespace firma {
namespace {

/// A tetrahedron of air, with a material for each face.
constexpr const char* kRoom = R"(v 0 0 0
v 4 0 0
v 0 4 0
v 0 0 4
usemtl rock
f 1 2 3
f 1 4 2
usemtl  two  words
f 1 3 4
usemtl
f 2 4 3
)";

World world_of(const std::string& text) {
    return make_world(read_obj(text, "room").value()).value();
}

std::string text_of(const World& world) {
    std::string text;
    const auto put = [&](std::string_view piece) {
        text += piece;
        return true;
    };
    const ObjWritten written = write_obj(world, put).value();
    EXPECT_EQ(written.bytes, text.size());
    EXPECT_EQ(written.faces, world.face_count());
    return text;
}

void expect_same_faces(const World& a, const World& b) {
    const std::vector<Face> ours = a.faces(), theirs = b.faces();
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t k = 0; k < ours.size(); ++k) {
        EXPECT_EQ(ours[k].corners, theirs[k].corners);
        EXPECT_EQ(a.material_name(ours[k].material), b.material_name(theirs[k].material));
    }
}

TEST(WriteObj, WhatLiesOnTheInputGridReadsBackAsItWas) {
    const World world = world_of(kRoom);
    const std::string text = text_of(world);
    expect_same_faces(world, world_of(text));
    EXPECT_EQ(text_of(world_of(text)), text);
    EXPECT_EQ(text.find("usemtl rock"), text.rfind("usemtl rock"));  // once for both faces
}

TEST(WriteObj, VerticesOfACraterHaveAllTheirDigits) {
    const World world = world_of(kRoom);
    const CarveResult cut =
        carve(world, make_crater(CutterShape::kRocky, 3), {{0.7, 0.8, 0}, random_turn(3), 0.5}, {"fresh\nrock \\"});
    ASSERT_TRUE(cut.done()) << cut.error.text();
    std::istringstream lines(text_of(cut.world));
    std::vector<Vec3> vertices;
    std::vector<std::vector<Vec3>> faces;
    std::string material;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line.substr(line.find(' ') + 1));
        if (line[0] == 'v') {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            vertices.push_back(p);
        } else if (line[0] == 'f') {
            faces.emplace_back();
            for (std::size_t k = 0; words >> k;) faces.back().push_back(vertices[k - 1]);
        } else if (line[0] == 'u') {
            material = line;
        }
    }
    EXPECT_EQ(material, "usemtl fresh_rock _");  // what an .obj cannot hold is replaced
    const std::vector<Face> ours = cut.world.faces();
    ASSERT_EQ(faces.size(), ours.size());
    for (std::size_t k = 0; k < faces.size(); ++k) EXPECT_EQ(faces[k], ours[k].corners);
}

TEST(WriteObj, StopsWhereTheSinkDoes) {
    int calls = 0;
    const Result<ObjWritten> written = write_obj(world_of(kRoom), [&](std::string_view) { return ++calls, false; });
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
    EXPECT_EQ(calls, 1);
}

TEST(WriteObj, AFileAppearsWholeOrNotAtAll) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "firma_write_obj";
    std::filesystem::remove_all(folder);
    const std::string path = (folder / "out.obj").string();
    const World world = world_of(kRoom);
    const Result<ObjWritten> missing = write_obj(world, path);  // no folder yet
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::kCannotWrite);
    EXPECT_EQ(missing.error().place, path);

    std::filesystem::create_directories(folder / "out.obj");
    EXPECT_FALSE(write_obj(world, path));  // a folder of that name
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
    std::filesystem::remove(folder / "out.obj");

    const Result<ObjWritten> written = write_obj(world, path);
    ASSERT_TRUE(written) << written.error().text();
    std::ifstream file(path);
    const std::string held((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    EXPECT_EQ(held, text_of(world));
    EXPECT_EQ(written.value().vertices, 4u);
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
    std::filesystem::remove_all(folder);
}

TEST(WriteObj, SaysThatTheDiskTakesNoMore) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "firma_write_obj_full";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "out.obj") << "as it was";
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit little{50, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &little);
    const Result<ObjWritten> written = write_obj(world_of(kRoom), (folder / "out.obj").string());
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
    EXPECT_FALSE(std::filesystem::exists(folder / "out.obj.part"));
    std::ifstream file(folder / "out.obj");
    EXPECT_EQ(std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>()), "as it was");
    std::filesystem::remove_all(folder);
}

TEST(WriteObj, WritesThroughLinksAndKeepsPermissions) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "firma_write_obj_link";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "real.obj") << "as it was";
    std::filesystem::permissions(folder / "real.obj",
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::filesystem::create_symlink("real.obj", folder / "out.obj");
    ASSERT_TRUE(write_obj(world_of(kRoom), (folder / "out.obj").string()));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "out.obj"));
    EXPECT_EQ(std::filesystem::status(folder / "real.obj").permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    EXPECT_GT(std::filesystem::file_size(folder / "real.obj"), 50u);
    std::filesystem::create_symlink("nowhere.obj", folder / "lost.obj");
    EXPECT_FALSE(write_obj(world_of(kRoom), (folder / "lost.obj").string()));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace firma

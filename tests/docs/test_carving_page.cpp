// SPDX-License-Identifier: MIT
// The pieces of docs/carving.md that its program does not have: they compile without a warning, run, and are what the
// page shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "firma/firma.h"

namespace {

void draw_a_frame() {}

TEST(CarvingPage, ItsPiecesRun) {
    const firma::Level level = firma::read_level(FIRMA_ROOT "/levels/first.obj").value();
    firma::World world = firma::make_world(level).value();
    const firma::World before = world;
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    const firma::Pose pose{.position = {35, 29, 0.2}};
    const std::vector<firma::Pose> shots{pose, {.position = {20, 29, 0.2}}, {.position = {35, 29, 1e300}}};
    int refused = 0;

    // clang-format off
    // piece
    firma::CarveRules rules;
    rules.zones.push_back({.name = "base", .box = {{0, 0, 0}, {10, 10, 4}}, .hardness = 0.5});
    rules.hardness = {0, 0, 1};                       // by material: the third cannot be carved
    world = firma::with_rules(world, rules).value();  // or WorldOptions::rules when the world is made
    // piece
    EXPECT_EQ(firma::hash_world(world), firma::hash_world(before));
    world = before;
    // piece
    firma::WorldEdit edit(world);                     // several edits, one version
    for (const firma::Pose& shot : shots)
        if (!edit.carve(crater, shot).done()) ++refused;  // or it met nothing; the others count
    const firma::World next = edit.finish();

    world = before;                                   // undo is assignment

    firma::CarveJob job(world, crater, pose);         // in slices, between frames
    while (!job.run(200)) draw_a_frame();             // 200 microseconds at a time
    world = job.result().world;                       // the same bits as in one go
    // piece
    // clang-format on
    EXPECT_EQ(refused, 1);
    EXPECT_EQ(next.version(), before.version() + 1);
    EXPECT_EQ(firma::hash_world(world), firma::hash_world(firma::carve(before, crater, pose).world));
}

std::string text_of(const char* path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// Without blanks at the beginnings of lines.
std::string unindented(const std::string& text) {
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, std::min(line.size(), line.find_first_not_of(' ')));
        all += line + '\n';
    }
    return all;
}

TEST(CarvingPage, ThePageShowsThem) {
    const std::string page = unindented(text_of(FIRMA_ROOT "/docs/carving.md"));
    const std::string source = unindented(text_of(FIRMA_ROOT "/tests/docs/test_carving_page.cpp"));
    const std::string mark = "\n// piece\n";
    std::size_t pieces = 0;
    for (std::size_t begin = source.find(mark); begin != std::string::npos; begin = source.find(mark, begin + 1)) {
        const std::size_t end = source.find(mark, begin + 1);
        const std::string piece = source.substr(begin + mark.size(), end - begin - mark.size());
        if (page.find("```cpp\n" + piece + "\n```") != std::string::npos) ++pieces;
        if (end == std::string::npos) break;
    }
    EXPECT_EQ(pieces, 2u);
}

}  // namespace

// SPDX-License-Identifier: MIT
// Levels that a program filled by hand, and wrongly.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "firma/world.h"

namespace firma {
namespace {

Level tetrahedron() {
    constexpr std::int32_t kMetre = 262144;
    Level level;
    level.name = "made";
    level.vertices = {{0, 0, 0}, {kMetre, 0, 0}, {0, kMetre, 0}, {0, 0, kMetre}};
    level.materials = {"", "stone"};
    level.groups = {""};
    constexpr std::uint32_t kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        LevelFace face;
        face.first_corner = 3 * k;
        face.corner_count = 3;
        face.source = 10 + k;
        level.faces.push_back(face);
        level.corners.insert(level.corners.end(), kFaces[k], kFaces[k] + 3);
    }
    return level;
}

std::string said(const std::function<void(Level&)>& change) {
    Level level = tetrahedron();
    change(level);
    const Result<World> world = make_world(level);
    EXPECT_EQ(level_solidity(level).solid_faces, world.ok() ? 4u : 0u);
    return world.ok() ? "" : world.error().text();
}

TEST(JudgeLevel, NamesTheFace) {
    EXPECT_EQ(said([](Level&) {}), "");
    EXPECT_EQ(said([](Level& level) { level.faces[2].material = 2; }),
              "made: face 12: its material 2 is not there: there are 2");
    EXPECT_EQ(said([](Level& level) { level.faces[2].group = 100000000; }),
              "made: face 12: its group 100000000 is not there: there are 1");
    EXPECT_EQ(said([](Level& level) { level.faces[3].first_corner = ~0u; }),
              "made: face 13: its corners are not there");
    EXPECT_EQ(said([](Level& level) { level.faces[3].corner_count = ~0u; }),
              "made: face 13: it does not have 3 to 64 corners");
    EXPECT_EQ(said([](Level& level) { level.corners[0] = 4; }), "made: face 10: a corner names no vertex");
    EXPECT_EQ(said([](Level& level) { level.corners[0] = 1; }),
              "made: face 10: it is not convex and planar, with area");
}

// A cut's material is added behind those of the level, not in the place of its first.
TEST(JudgeLevel, WithoutMaterialsThereIsTheOneWithoutAName) {
    Level level = tetrahedron();
    level.materials.clear();
    level.groups.clear();
    const World world = make_world(level).value();
    EXPECT_EQ(world.material_name(0), "");
    const CarveResult cut =
        carve(world, make_crater(CutterShape::kRocky, 1), {.position = {0, 0, 0}}, {.material = "rubble"});
    ASSERT_EQ(cut.status, CarveStatus::kDone);
    EXPECT_EQ(cut.world.material_name(0), "");
    EXPECT_EQ(cut.world.material_name(1), "rubble");
}

}  // namespace
}  // namespace firma

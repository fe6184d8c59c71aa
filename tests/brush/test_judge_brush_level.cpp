// SPDX-License-Identifier: MIT
// Levels of brushes that a program filled by hand, and wrongly: fault F3. Each ends in an Error that names the place.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "firma/brush_world.h"
#include "scenes/brush_piles.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr std::int32_t kMetre = 262144;  // surface steps

BrushLevel two_boxes() {
    BrushLevel level;
    level.name = "made";
    level.materials = {"", "stone"};
    level.entities.resize(1);
    scenes::add_box(level, {0, 0, 0}, {4096, 4096, 4096});
    scenes::add_box(level, {8192, 0, 0}, {12288, 4096, 4096}, BrushKind::kGlass);
    level.surfaces.materials = {""};
    level.surfaces.groups = {""};
    level.surfaces.vertices = {{0, 0, 2 * kMetre}, {kMetre, 0, 2 * kMetre}, {0, kMetre, 2 * kMetre}};
    level.surfaces.corners = {0, 1, 2};
    LevelFace face;
    face.corner_count = 3;
    face.source = 12;
    level.surfaces.faces = {face};
    return level;
}

/// What make_world() says of two boxes after such a change. divide_rooms() must say the same.
std::string said(const std::function<void(BrushLevel&)>& change) {
    BrushLevel level = two_boxes();
    change(level);
    const Result<World> world = make_world(level);
    const Result<BrushLevel> divided = divide_rooms(level, {.max_cells = 4096});
    EXPECT_EQ(world.ok(), divided.ok());
    if (world.ok()) return "";
    EXPECT_EQ(world.error().text(), divided.error().text());
    EXPECT_EQ(world.error().code, ErrorCode::kInvalid);
    return world.error().text();
}

TEST(JudgeBrushLevel, ASoundOneIsTaken) {
    EXPECT_EQ(said([](BrushLevel&) {}), "");
    EXPECT_EQ(said([](BrushLevel& level) { level.entities.clear(); }), "");
    EXPECT_EQ(said([](BrushLevel& level) { level.brushes.pop_back(); }), "");  // sides of no brush
    EXPECT_EQ(make_world(two_boxes()).value().face_count(), 13u);
}

TEST(JudgeBrushLevel, IndicesThatAreNotThere) {
    EXPECT_EQ(said([](BrushLevel& level) { level.brushes[0].first_side = 100000000; }),
              "made: brush 0: its sides 100000000 to 100000006 are not there: there are 12");
    EXPECT_EQ(said([](BrushLevel& level) { level.brushes[1].side_count = ~0u; }),
              "made: brush 1: its sides 6 to 4294967301 are not there: there are 12");
    EXPECT_EQ(said([](BrushLevel& level) { level.brushes[1].first_side = 5; }),
              "made: brush 1: its sides begin at 5, before those of an earlier brush end");
    EXPECT_EQ(said([](BrushLevel& level) { std::swap(level.brushes[0], level.brushes[1]); }),
              "made: brush 1: its sides begin at 0, before those of an earlier brush end");
    EXPECT_EQ(said([](BrushLevel& level) { level.brushes[1].entity = 7; }),
              "made: brush 1: its entity 7 is not there: there are 1");
    EXPECT_EQ(said([](BrushLevel& level) { level.brushes[1].kind = BrushKind(200); }),
              "made: brush 1: its kind is none");
    EXPECT_EQ(said([](BrushLevel& level) { level.sides[8].material = 2; }),
              "made: brush 1, side 2: its material 2 is not there: there are 2");
    EXPECT_EQ(said([](BrushLevel& level) {
                  level.brushes[1].line = 17;
                  level.sides[8].material = ~0u;
              }),
              "made: brush 1 (line 17), side 2: its material 4294967295 is not there: there are 2");
    EXPECT_EQ(said([](BrushLevel& level) {
                  level.brushes.pop_back();
                  level.sides[8].material = 2;
              }),
              "made: side 8: its material 2 is not there: there are 2");
}

TEST(JudgeBrushLevel, PlanesThatAreNone) {
    EXPECT_EQ(said([](BrushLevel& level) { level.sides[7] = {}; }),
              "made: brush 1, side 1: its three points lie on a line");
    EXPECT_EQ(said([](BrushLevel& level) { level.sides[0].points[1].x += 1; }),
              "made: brush 0, side 0: a point of it is not on the input grid");
    EXPECT_EQ(said([](BrushLevel& level) { level.metres_a_unit = 0; }),
              "made: metres_a_unit must be a finite number above zero");
    EXPECT_EQ(said([](BrushLevel& level) { level.metres_a_unit = NAN; }),
              "made: metres_a_unit must be a finite number above zero");
}

TEST(JudgeBrushLevel, SurfacesThatAreNone) {
    EXPECT_EQ(said([](BrushLevel& level) { level.surfaces.faces[0].material = 100000000; }),
              "made: surfaces, face 12: its material 100000000 is not there: there are 1");
    EXPECT_EQ(said([](BrushLevel& level) { level.surfaces.faces[0].group = 1; }),
              "made: surfaces, face 12: its group 1 is not there: there are 1");
    EXPECT_EQ(said([](BrushLevel& level) { level.surfaces.faces[0].first_corner = ~0u; }),
              "made: surfaces, face 12: its corners are not there");
    EXPECT_EQ(said([](BrushLevel& level) { level.surfaces.corners[2] = 3; }),
              "made: surfaces, face 12: a corner names no vertex");
    EXPECT_EQ(said([](BrushLevel& level) { level.surfaces.corners[2] = 1; }),
              "made: surfaces, face 12: it is not convex and planar, with area");
    EXPECT_EQ(said([](BrushLevel& level) { level.surfaces.vertices[2].y += 1; }),
              "made: surfaces, face 12: a corner of it is not on the input grid");
}

// Lists of names may be empty: then all is of the material without a name, also what surfaces are of.
TEST(JudgeBrushLevel, NamesMayBeMissing) {
    BrushLevel level = two_boxes();
    level.materials.clear();
    level.surfaces.materials.clear();
    level.surfaces.groups.clear();
    for (BrushSide& side : level.sides) side.material = 0;
    const World world = make_world(level).value();
    EXPECT_EQ(world.face_count(), 13u);
    EXPECT_EQ(world.material_name(0), "");
    level.surfaces.materials = {"curve"};
    EXPECT_EQ(make_world(level).value().material_name(0), "");
    EXPECT_EQ(make_world(level).value().material_name(1), "curve");
}

TEST(JudgeBrushLevel, OptionsThatAreNone) {
    for (const double contact_offset : {-1.0, double(NAN), double(INFINITY)}) {
        WorldOptions options;
        options.tolerance.contact_offset = contact_offset;
        const Result<World> world = make_world(two_boxes(), options);
        ASSERT_FALSE(world.ok());
        EXPECT_EQ(world.error().text(), "made: the contact offset must be a finite number, not below zero");
    }
    EXPECT_TRUE(divide_rooms(two_boxes(), {.max_cells = 0}).ok());
    EXPECT_TRUE(find_leak(make_world(two_boxes()).value(), {NAN, 0, 0}).empty());
}

// Any number of the struct replaced by any other: a world or an error, under the sanitizers too.
TEST(JudgeBrushLevel, HostileNumbers) {
    scenes::Rng rng(4);
    const auto wild = [&]() -> std::uint32_t {
        constexpr std::uint32_t kWild[] = {0,  1,  2,  5,  6,        7,          11,         12,
                                           13, 63, 64, 65, 1u << 20, 0x7fffffff, 0x80000000, ~0u};
        return kWild[rng.below(std::size(kWild))];
    };
    std::size_t taken = 0;
    for (int round = 0; round < 2000; ++round) {
        BrushLevel level = two_boxes();
        Brush& brush = level.brushes[rng.below(2)];
        BrushSide& side = level.sides[rng.below(12)];
        LevelFace& face = level.surfaces.faces[0];
        switch (rng.below(10)) {
            case 0:
                brush.first_side = wild();
                break;
            case 1:
                brush.side_count = wild();
                break;
            case 2:
                brush.entity = wild();
                break;
            case 3:
                side.material = wild();
                break;
            case 4:
                side.points[rng.below(3)][int(rng.below(3))] = std::int32_t(wild());
                break;
            case 5:
                face.first_corner = wild();
                break;
            case 6:
                face.corner_count = wild();
                break;
            case 7:
                face.material = wild();
                break;
            case 8:
                level.surfaces.corners[rng.below(3)] = wild();
                break;
            default:
                level.surfaces.vertices[rng.below(3)][int(rng.below(3))] = std::int32_t(wild());
        }
        const Result<World> world = make_world(level);
        taken += world.ok();
        if (!world.ok()) continue;
        EXPECT_FALSE(check_world(world.value()));
    }
    EXPECT_GT(taken, 200u);
    EXPECT_LT(taken, 1500u);
}

}  // namespace
}  // namespace firma

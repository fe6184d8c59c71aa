// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "firma/brush_level.h"
#include "firma/level.h"
#include "scenes/rng.h"

namespace firma {
namespace {

Result<BrushLevel> read(std::string_view text, const ReadOptions& options = {}) {
    return read_map(text, "a.map", options);
}

std::string read_error(std::string_view text, const ReadOptions& options = {}) {
    const auto level = read(text, options);
    return level ? "" : level.error().text();
}

std::string point(const std::array<double, 3>& p) {
    std::string text = "( ";
    for (const double x : p) text += std::to_string(x) + " ";
    return text + ") ";
}

// The six sides of a box in Quake's order of points, each with its texture and what follows it.
std::string box_sides(const std::array<double, 3>& low, const std::array<double, 3>& high,
                      const std::array<std::string, 6>& textures, const std::string& tail = " 0 0 0 1 1") {
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool top : {false, true}) {
            std::array<double, 3> a = low, b, c;
            a[axis] = top ? high[axis] : low[axis];
            b = c = a;
            // Counter-clockwise seen from the axis' end is u, then v; Quake has it the other way round.
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            b[top ? v : u] = high[top ? v : u];
            c[top ? u : v] = high[top ? u : v];
            text += point(a) + point(b) + point(c) + textures[2 * axis + top] + tail + "\n";
        }
    }
    return text;
}

std::array<std::string, 6> all(const std::string& name) {
    return {name, name, name, name, name, name};
}

std::string textured_box(const std::string& texture = "wall", const std::string& tail = " 0 0 0 1 1") {
    return "{\n" + box_sides({0, 0, 0}, {64, 32, 96}, all(texture), tail) + "}\n";
}

std::string world(const std::string& content) {
    return "{\n\"classname\" \"worldspawn\"\n" + content + "}\n";
}

Vec3 normal_of(const BrushSide& side) {
    const Vec3 a = to_metres(side.points[0]), b = to_metres(side.points[1]), c = to_metres(side.points[2]);
    return cross(b - a, c - a);
}

TEST(ReadMap, BoxFacesOutwardInMetres) {
    const BrushLevel level = read(world(textured_box())).value();
    ASSERT_EQ(level.brushes.size(), 1u);
    const Brush& brush = level.brushes[0];
    EXPECT_EQ(brush.kind, BrushKind::kSolid);
    EXPECT_EQ(brush.side_count, 6u);
    EXPECT_EQ(brush.line, 3u);
    EXPECT_FALSE(brush.detail);
    const Vec3 centre = {1, 0.5, 1.5};
    for (const BrushSide& side : level.sides) {
        EXPECT_LT(dot(centre - to_metres(side.points[0]), normal_of(side)), 0);
        EXPECT_EQ(side.mask, kStopsSolid);
        EXPECT_EQ(level.materials[side.material], "wall");
        EXPECT_FALSE(side.portal);
    }
    EXPECT_EQ(level.sides[5].points[0].z, 3 * 262144);
    EXPECT_EQ(level.materials, (std::vector<std::string>{"", "wall"}));
    EXPECT_EQ(level.name, "a.map");
    EXPECT_EQ(level.metres_a_unit, 1.0 / 32);
    EXPECT_EQ(level.max_shift, 0);
    EXPECT_TRUE(level.notes.empty());
    EXPECT_TRUE(level.surfaces.faces.empty());
}

TEST(ReadMap, ScaleIsTheCallers) {
    EXPECT_EQ(read(world(textured_box()), {.scale = 0.25}).value().sides[5].points[0].z, 24 * 262144);
    EXPECT_EQ(read(world(textured_box()), {.scale = 0.25}).value().metres_a_unit, 0.25);
    EXPECT_EQ(read_error(world(textured_box()), {.scale = -1}), "a.map: scale -1 is not a positive number");
    EXPECT_EQ(read_error(world(textured_box()), {.patch_tolerance = 0}),
              "a.map: patch tolerance 0 is not a positive number");
}

TEST(ReadMap, EntitiesAndKeysAreKept) {
    const BrushLevel level = read(
                                 "// Game: Quake\n// entity 0\n{\n\"classname\" \"worldspawn\"\n"
                                 "\"message\" \"a \\\"word\\\" and\\nmore {}\"\n\"wad\" \"C:\\quake\\\"\n}\n"
                                 "// entity 1\n{ \"classname\" \"info_player_start\" \"origin\" \"1 2 3\" bare word }")
                                 .value();
    ASSERT_EQ(level.entities.size(), 2u);
    EXPECT_EQ(level.entities[0].line, 3u);
    EXPECT_EQ(level.entities[0].value("message"), "a \"word\" and\\nmore {}");
    EXPECT_EQ(level.entities[0].value("wad"), "C:\\quake\\");
    EXPECT_EQ(level.entities[1].line, 9u);
    EXPECT_EQ(level.entities[1].value("origin"), "1 2 3");
    EXPECT_EQ(level.entities[1].value("bare"), "word");
    EXPECT_EQ(level.entities[1].value("none"), "");
    EXPECT_EQ(level.entities[1].keys.size(), 3u);
}

TEST(ReadMap, EveryFormOfASideIsTheSame) {
    const BrushLevel standard = read(world(textured_box())).value();
    for (const char* tail :
         {" 0 0 0 1 1 0 0 0", " -0 +1.5e1 .5 -5. 1e-3 ", " [ 1 0 0 0 ] [ 0 -1 0 -16.5 ] 0 1 1",
          " [ 1 0 0 0 ] [ 0 -1 0 -16.5 ] 0 1 1 0 0 0", " [1 0 0 0] [0 -1 0 -16.5] 0 1 1 // side", " 0\n0 0\n1 1"}) {
        const auto level = read(world(textured_box("wall", tail)));
        ASSERT_TRUE(level.ok()) << tail << level.error().text();
        ASSERT_EQ(level.value().sides.size(), 6u);
        EXPECT_TRUE(level.value().notes.empty());
        for (std::size_t k = 0; k < 6; ++k)
            for (int corner = 0; corner < 3; ++corner)
                EXPECT_EQ(level.value().sides[k].points[corner], standard.sides[k].points[corner]);
    }
}

TEST(ReadMap, LineEndsOfEveryKind) {
    std::string text = world(textured_box());
    const auto lines_of = [](const std::string& t) { return read(t).value().brushes[0].line; };
    text.pop_back();  // the last line's end
    EXPECT_EQ(lines_of(text), 3u);
    EXPECT_EQ(lines_of("\xEF\xBB\xBF" + text), 3u);
    std::string dos, mac = text;
    for (const char c : text) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(lines_of(dos), 3u);
    for (char& c : mac) c = c == '\n' ? '\r' : c;
    EXPECT_EQ(lines_of("// a comment\r" + mac), 4u);
    std::string tight;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool beside = text[k] == ' ' && k > 0 && (text[k - 1] == '(' || text[k + 1] == ')');
        if (!beside) tight += text[k];
    }
    EXPECT_NE(tight, text);
    EXPECT_EQ(read(tight).value().sides.size(), 6u);
}

TEST(ReadMap, TexturesMayHoldAnythingButBlanks) {
    for (const char* name :
         {"*water", "+0button", "{fence", "}odd", "(sign)", "[x]", "a//b", "#1", "\\back\\slash", "\xC3\xA9"}) {
        const auto level = read(world(textured_box(name)));
        ASSERT_TRUE(level.ok()) << level.error().text();
        EXPECT_EQ(level.value().materials[1], name);
    }
    EXPECT_EQ(read(world(textured_box("\"two words\""))).value().materials[1], "two words");
    EXPECT_EQ(read(world(textured_box("\"a \\\"b\\\"\""))).value().materials[1], "a \"b\"");
}

BrushKind kind_of(const std::string& texture, const std::string& tail = " 0 0 0 1 1") {
    return read(world(textured_box(texture, tail))).value().brushes[0].kind;
}

TEST(ReadMap, KindsByTexture) {
    for (const char* name : {"wall", "common/caulk", "NODRAW", "skip", "waterfall", "clipboard", "textures/base/hint2"})
        EXPECT_EQ(kind_of(name), BrushKind::kSolid) << name;
    for (const char* name : {"clip", "common/clip", "textures\\common\\PlayerClip", "common/full_clip", "metalclip"})
        EXPECT_EQ(kind_of(name), BrushKind::kPlayerClip) << name;
    for (const char* name : {"weapclip", "shotclip", "missileclip", "clips/weaponclip"})
        EXPECT_EQ(kind_of(name), BrushKind::kShotClip) << name;
    for (const char* name : {"trigger", "common/origin", "nodrop", "textures/fogs/red", "lightgrid", "botclip",
                             "donotenter", "common/nodrawnonsolid"})
        EXPECT_EQ(kind_of(name), BrushKind::kData) << name;
    for (const char* name : {"*lava1", "!water", "textures/liquids/calm", "liquids/slime", "common/watercaulk"})
        EXPECT_EQ(kind_of(name), BrushKind::kLiquid) << name;
    for (const char* name : {"sky1", "SKY4", "skies/blue", "textures/skies/hell", "e1u1/sky1"})
        EXPECT_EQ(kind_of(name), BrushKind::kSky) << name;
    for (const char* name : {"portal", "hint", "common/areaportal", "COMMON/HINT"})
        EXPECT_EQ(kind_of(name), BrushKind::kPortal) << name;
    for (const char* name : {"glass", "textures/glass/pane", "{grate"})
        EXPECT_EQ(kind_of(name), BrushKind::kGlass) << name;
}

TEST(ReadMap, KindsByFlagsGoFirst) {
    const auto tail = [](const std::string& contents, const std::string& flags = "0") {
        return " 0 0 0 1 1 " + contents + " " + flags + " 0";
    };
    EXPECT_EQ(kind_of("e1u1/a", tail("1")), BrushKind::kSolid);
    EXPECT_EQ(kind_of("e1u1/clip", tail("1")), BrushKind::kSolid);
    EXPECT_EQ(kind_of("e1u1/a", tail("2")), BrushKind::kGlass);
    EXPECT_EQ(kind_of("e1u1/a", tail("536870913")), BrushKind::kGlass);
    for (const char* liquid : {"8", "16", "32"}) EXPECT_EQ(kind_of("e1u1/a", tail(liquid)), BrushKind::kLiquid);
    EXPECT_EQ(kind_of("e1u1/a", tail("64")), BrushKind::kData);
    EXPECT_EQ(kind_of("e1u1/a", tail("32768")), BrushKind::kPortal);
    EXPECT_EQ(kind_of("e1u1/a", tail("65536")), BrushKind::kPlayerClip);
    EXPECT_EQ(kind_of("e1u1/a", tail("131072")), BrushKind::kData);
    EXPECT_EQ(kind_of("e1u1/a", tail("16777216")), BrushKind::kData);
    EXPECT_EQ(kind_of("e1u1/a", tail("-2147483648")), BrushKind::kData);
    EXPECT_EQ(kind_of("e1u1/a", tail("0", "4")), BrushKind::kSky);
    EXPECT_EQ(kind_of("e1u1/a", tail("0", "256")), BrushKind::kPortal);
    EXPECT_EQ(kind_of("clip", tail("0.5", "1e300")), BrushKind::kPlayerClip);  // no flags at all

    const BrushLevel detail = read(world(textured_box("e1u1/a", tail("134217728")))).value();
    EXPECT_EQ(detail.brushes[0].kind, BrushKind::kSolid);
    EXPECT_TRUE(detail.brushes[0].detail);
}

std::uint32_t mask_of(const std::string& texture) {
    return read(world(textured_box(texture))).value().sides[0].mask;
}

TEST(ReadMap, MasksByKind) {
    EXPECT_EQ(mask_of("wall"), kStopsSolid);
    EXPECT_EQ(mask_of("skies/a"), kStopsSolid | kIsSky);
    EXPECT_EQ(mask_of("glass"), kStopsWalk | kStopsShots);
    EXPECT_EQ(mask_of("clip"), kStopsWalk);
    EXPECT_EQ(mask_of("weapclip"), kStopsShots);
    EXPECT_EQ(mask_of("*water"), kStopsLiquid);
    EXPECT_EQ(mask_of("hint"), 0u);
    EXPECT_EQ(mask_of("trigger"), 0u);
}

BrushLevel mixed(const std::array<std::string, 6>& textures) {
    return read(world("{\n" + box_sides({0, 0, 0}, {64, 32, 96}, textures) + "}\n")).value();
}

TEST(ReadMap, FillersSayNothingBesideOthers) {
    const BrushLevel sky = mixed({"caulk", "caulk", "skies/a", "caulk", "caulk", "caulk"});
    EXPECT_EQ(sky.brushes[0].kind, BrushKind::kSky);
    EXPECT_EQ(sky.sides[0].mask, kStopsSolid);
    EXPECT_EQ(sky.sides[2].mask, kStopsSolid | kIsSky);
    EXPECT_EQ(mixed({"nodrawnonsolid", "caulk", "skip", "*water", "wall", "wall"}).brushes[0].kind, BrushKind::kLiquid);
    EXPECT_EQ(mixed({"nodrawnonsolid", "caulk", "skip", "wall", "*water", "wall"}).brushes[0].kind, BrushKind::kSolid);
    EXPECT_EQ(mixed({"wall", "wall", "wall", "wall", "wall", "sky1"}).sides[5].mask, kStopsSolid | kIsSky);
}

std::string portals_of(const BrushLevel& level) {
    std::string marks;
    for (const BrushSide& side : level.sides) marks += side.portal ? '1' : '0';
    return marks;
}

TEST(ReadMap, PortalsAreTheMarkedSidesOrTheLargest) {
    const BrushLevel marked = mixed({"hintskip", "skip", "wall", "common/hint", "skip", "portal"});
    EXPECT_EQ(marked.brushes[0].kind, BrushKind::kPortal);
    EXPECT_EQ(portals_of(marked), "000101");
    for (const BrushSide& side : marked.sides) EXPECT_EQ(side.mask, 0u);
    // 64 x 32 x 96: the sides across y are the largest, and the first of them is taken.
    EXPECT_EQ(portals_of(mixed(all("areaportal"))), "001000");
    EXPECT_EQ(portals_of(mixed(all("wall"))), "000000");
}

TEST(ReadMap, EntitiesThatMoveAreData) {
    std::string text = world(textured_box());
    for (const char* name : {"func_group", "func_detail", "func_detail_wall", "func_static", "func_wall", "func_door",
                             "trigger_push", "func_detail_illusionary", "func_areaportal"})
        text += std::string("{\n\"classname\" \"") + name + "\"\n" + textured_box() + "}\n";
    const BrushLevel level = read(text + text.substr(world(textured_box()).size())).value();
    ASSERT_EQ(level.brushes.size(), 19u);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(level.brushes[k].kind, BrushKind::kSolid) << k;
    for (std::size_t k = 6; k < 9; ++k) EXPECT_EQ(level.brushes[k].kind, BrushKind::kData) << k;
    EXPECT_EQ(level.brushes[9].kind, BrushKind::kPortal);
    EXPECT_EQ(level.brushes[7].entity, 7u);
    EXPECT_FALSE(level.brushes[1].detail);
    EXPECT_TRUE(level.brushes[2].detail);
    ASSERT_EQ(level.notes.size(), 3u);
    EXPECT_EQ(level.notes[0],
              "brushes of 'func_door' are kept as data: first a.map:69: entity 6 (func_door), brush 0, 2 in all");
    // Triggers and illusions are there to be walked through.
    ASSERT_EQ(level.omissions.size(), 1u);
    EXPECT_EQ(level.omissions[0].what, "brushes of 'func_door'");
    EXPECT_EQ(level.omissions[0].count, 2u);
}

TEST(ReadMap, FirstEntityIsTheWorld) {
    const BrushLevel level = read("{ \"classname\" \"func_door\"\n" + textured_box() + "}").value();
    EXPECT_EQ(level.brushes[0].kind, BrushKind::kSolid);
    EXPECT_EQ(level.notes, (std::vector<std::string>{"the first entity is no worldspawn: a.map:1"}));
    EXPECT_EQ(read_error(""), "a.map: no entity in the file");
    EXPECT_EQ(read_error(" // nothing\n"), "a.map: no entity in the file");
}

TEST(ReadMap, UnknownPrimitivesAreNotedAndKept) {
    const std::string text = world(
        "{ brushDef9 { ( 0 0 1 -5 ) ( ( 1 0 0 ) ( 0 1 0 ) ) \"a\" { {x } }}\n"
        "{\nbrushDef8\n{\n( 1 2 3 ) ( 1 2 3 ) ( 1 2 3 ) ( ( 1 0 0 ) ( 0 1 0 ) ) {fence 0 0 0\n}\n}\n"
        "{ patchDef7 { a } }\n" +
        textured_box());
    const BrushLevel level = read(text).value();
    EXPECT_EQ(level.brushes.size(), 1u);
    EXPECT_EQ(level.brushes[0].line, 11u);
    ASSERT_EQ(level.notes.size(), 3u);
    EXPECT_EQ(level.notes[0], "primitive 'brushDef9' is not understood: a.map:3 in brush 0 of entity 0");
    EXPECT_EQ(level.notes[1], "primitive 'brushDef8' is not understood: a.map:5 in brush 1 of entity 0");
    EXPECT_EQ(level.notes[2], "primitive 'patchDef7' is not understood: a.map:10 in brush 2 of entity 0");
    const std::vector<UnknownPart>& kept = level.entities[0].unknown;
    ASSERT_EQ(kept.size(), 3u);
    EXPECT_EQ(kept[0].text, "brushDef9 { ( 0 0 1 -5 ) ( ( 1 0 0 ) ( 0 1 0 ) ) \"a\" { {x } }");
    EXPECT_EQ(kept[1].text, "brushDef8\n{\n( 1 2 3 ) ( 1 2 3 ) ( 1 2 3 ) ( ( 1 0 0 ) ( 0 1 0 ) ) {fence 0 0 0\n}\n");
    EXPECT_EQ(kept[1].line, 5u);
    EXPECT_EQ(kept[2].text, "patchDef7 { a } ");
    ASSERT_EQ(level.omissions.size(), 3u);
    EXPECT_EQ(level.omissions[0].what, "primitives 'brushDef9'");
    EXPECT_EQ(level.omissions[0].count, 1u);
    EXPECT_EQ(level.omissions[0].first, "a.map:3 in brush 0 of entity 0");
    EXPECT_EQ(read("Version 2\n" + text).value().notes.size(), 3u);
}

TEST(ReadMap, NotesOfOneKindAreOne) {
    std::string bad;
    for (int k = 0; k < 1000; ++k) bad += "{ brushDef8 { } }\n";
    for (int k = 0; k < 1000; ++k) bad += "{ what" + std::to_string(k) + " { } }\n";
    const BrushLevel level = read(world(bad)).value();
    ASSERT_EQ(level.notes.size(), 257u);
    EXPECT_EQ(level.notes[0],
              "primitive 'brushDef8' is not understood: first a.map:3 in brush 0 of entity 0, 1000 in all");
    EXPECT_EQ(level.notes[256], "745 further notes of other kinds");
    ASSERT_EQ(level.omissions.size(), 257u);
    EXPECT_EQ(level.omissions[0].count, 1000u);
    EXPECT_EQ(level.omissions[256].what, "things of other kinds");
    EXPECT_EQ(level.omissions[256].count, 745u);
}

TEST(ReadMap, FurtherWordsOfASideAreLeft) {
    const BrushLevel level = read(world(textured_box("wall", " 0 0 0 1 1 0 0 0 7 +surfparm detail"))).value();
    EXPECT_EQ(level.sides.size(), 6u);
    EXPECT_EQ(level.notes, (std::vector<std::string>{
                               "further words of a side are left: first a.map:4 in brush 0 of entity 0, 18 in all"}));
}

TEST(ReadMap, SidesWithoutAPlaneAreLeftOut) {
    const std::string line = "( 0 0 0 ) ( 1 1 1 ) ( 2 2 2 ) wall 0 0 0 1 1\n";
    const std::string snapped = "( 0 40 0 ) ( 64 40 0 ) ( 32 40 0.001 ) wall 0 0 0 1 1\n";
    const BrushLevel level = read(world("{\n" + line + box_sides({0, 0, 0}, {64, 32, 96}, all("wall")) + snapped +
                                        "}\n" + "{\n" + line + line + line + line + "}\n{ }\n"))
                                 .value();
    ASSERT_EQ(level.brushes.size(), 3u);
    EXPECT_EQ(level.brushes[0].kind, BrushKind::kSolid);
    EXPECT_EQ(level.brushes[0].side_count, 6u);
    EXPECT_EQ(level.brushes[1].kind, BrushKind::kData);
    EXPECT_EQ(level.brushes[1].side_count, 0u);
    EXPECT_EQ(level.brushes[2].kind, BrushKind::kData);
    ASSERT_EQ(level.notes.size(), 2u);
    EXPECT_EQ(level.notes[0],
              "side whose three points lie on a line is left out: first a.map:4: entity 0 (worldspawn), "
              "brush 0, 6 in all");
    EXPECT_EQ(level.notes[1],
              "brush of fewer than four sides is kept as data: first a.map:13: entity 0 (worldspawn), "
              "brush 1, 2 in all");
}

// Of a side: normal . p + offset, in metres.
double height_over(const BrushSide& side, const Vec3& p) {
    const Vec3 normal = normal_of(side);
    return dot(normal * (1 / length(normal)), p - to_metres(side.points[0]));
}

// The top of a box by points a unit apart, one of them 0.4 of a grid step higher: the far end is 25.6 steps higher.
TEST(ReadMap, PointsOffTheGridGiveWayToCornersOfTheFace) {
    const double unit = 1.0 / 128;  // a grid step, in units of a 32nd of a metre
    std::string sides = box_sides({0, 0, 0}, {64, 32, 96}, all("wall"));
    for (int k = 0; k < 3; ++k) sides.resize(sides.rfind("( "));
    sides += point({0, 0, 96}) + point({0, 1, 96}) + point({1, 0, 96 + 0.4 * unit}) + "wall 0 0 0 1 1\n";
    const BrushLevel level = read(world("{\n" + sides + "}\n")).value();
    ASSERT_EQ(level.sides.size(), 6u);
    EXPECT_NEAR(height_over(level.sides[5], {0, 1, 3}), 0, 0.6 / 4096);
    EXPECT_NEAR(height_over(level.sides[5], {2, 0, 3 + 25.6 / 4096}), 0, 0.6 / 4096);
    EXPECT_GT(level.max_shift, 0);
    EXPECT_LT(level.max_shift, 0.6 / 4096);
    EXPECT_TRUE(level.notes.empty());
    // The other sides are as in the file.
    EXPECT_EQ(to_metres(level.sides[3].points[0]).y, 1);
}

// A box with its low corner at (x, 0, 0) turned by a 3-4-5 triangle and moved off the grid; points a unit apart.
std::string turned_box(double x) {
    const auto at = [](const Vec3& p) {
        return point({100.1 + 0.8 * p.x - 0.6 * p.y, -37.7 + 0.6 * p.x + 0.8 * p.y, 5.3 + p.z});
    };
    const Vec3 low = {x, 0, 0}, high = {x + 32, 64, 96};
    std::string text = "{\n";
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool top : {false, true}) {
            Vec3 a = top ? high : low, b = a, c = a;
            b[(axis + (top ? 2 : 1)) % 3] += 1;
            c[(axis + (top ? 1 : 2)) % 3] += 1;
            text += at(a) + at(b) + at(c) + "wall 0 0 0 1 1\n";
        }
    }
    return text + "}\n";
}

TEST(ReadMap, TurnedNeighboursShareAPlane) {
    const BrushLevel level = read(world(turned_box(0) + turned_box(32))).value();
    ASSERT_EQ(level.sides.size(), 12u);
    const auto points = [&](std::size_t k) { return level.sides[k].points; };
    EXPECT_EQ(points(1)[0], points(6)[0]);  // high x of the one, low x of the other
    EXPECT_EQ(points(1)[1], points(6)[2]);
    EXPECT_EQ(points(1)[2], points(6)[1]);
    for (const std::size_t k : {2u, 3u, 4u, 5u})  // low and high y and z: the same plane from the same side
        for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(points(k)[corner], points(k + 6)[corner]) << k;
    EXPECT_GT(level.max_shift, 1e-6);
    EXPECT_LT(level.max_shift, 0.0003);
    const Vec3 centre = Vec3{100.1 + 0.8 * 32 - 0.6 * 32, -37.7 + 0.6 * 32 + 0.8 * 32, 5.3 + 48} * (1.0 / 32);
    for (const std::size_t k : {0u, 2u, 3u, 4u, 5u, 7u}) EXPECT_LT(height_over(level.sides[k], centre), -0.9) << k;
}

TEST(ReadMap, PlanesOnTheGridWin) {
    std::string off = box_sides({64, 0, 0}, {128, 32, 96}, all("wall"));
    for (int k = 0; k < 3; ++k) off.resize(off.rfind("( "));
    off += point({64.3, 0.3, 96.001}) + point({64.3, 1.3, 96.001}) + point({65.3, 0.3, 96.001}) + "wall 0 0 0 1 1\n";
    const BrushLevel level = read(world(textured_box() + "{\n" + off + "}\n")).value();
    for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(level.sides[11].points[corner], level.sides[5].points[corner]);
    EXPECT_NEAR(level.max_shift, 0.001 / 32, 1e-9);
}

std::string patch(const std::string& texture = "curve", const std::string& size = "3 3 0 0 0") {
    std::string text = "{\npatchDef2\n{\n" + texture + "\n( " + size + " )\n(\n";
    for (int x = 0; x < 3; ++x) {
        text += "( ";
        for (int y = 0; y < 3; ++y) text += "( " + std::to_string(64 * x) + " " + std::to_string(32 * y) + " 16 0 0 ) ";
        text += ")\n";
    }
    return text + ")\n}\n}\n";
}

TEST(ReadMap, PatchesAreSurfaces) {
    const BrushLevel level = read(world(textured_box() + patch() + patch("common/clip") + patch("skies/a"))).value();
    ASSERT_EQ(level.surfaces.faces.size(), 3u);
    const LevelFace& face = level.surfaces.faces[0];
    EXPECT_EQ(face.source, 6u);
    EXPECT_EQ(face.kind, FaceKind::kPatch);
    EXPECT_EQ(face.mask, kStopsSolid);
    EXPECT_EQ(level.surfaces.materials[face.material], "curve");
    EXPECT_EQ(level.surfaces.source_faces, 9u);
    EXPECT_EQ(level.surfaces.faces[1].mask, kStopsWalk);
    EXPECT_EQ(level.surfaces.faces[2].mask, kStopsSolid | kIsSky);
    EXPECT_EQ(level.surfaces.faces[2].source, 8u);
    // 4 m by 2 m, half a metre up; its front is above.
    Vec3 twice;
    const auto corner = [&](std::uint32_t k) { return to_metres(level.surfaces.vertices[level.surfaces.corners[k]]); };
    for (std::uint32_t k = 2; k < face.corner_count; ++k)
        twice = twice + cross(corner(k - 1) - corner(0), corner(k) - corner(0));
    EXPECT_EQ(twice, (Vec3{0, 0, 16}));
    EXPECT_EQ(corner(0).z, 0.5);
    EXPECT_TRUE(level.notes.empty());
}

TEST(ReadMap, PatchesThatNothingMeetsAreLeftOut) {
    const BrushLevel level = read(world(patch("trigger")) + "{ \"classname\" \"func_door\"\n" + patch() + "}").value();
    EXPECT_TRUE(level.surfaces.faces.empty());
    ASSERT_EQ(level.notes.size(), 2u);
    EXPECT_EQ(level.notes[1], "patches of 'func_door' are left out: a.map:17: entity 1 (func_door), brush 0");
    EXPECT_EQ(level.notes[0], "patch that nothing meets is left out: a.map:3: entity 0 (worldspawn), brush 0");
}

TEST(ReadMap, ErrorsNameTheLine) {
    const std::string open = "{\n\"classname\" \"worldspawn\"\n{\n";
    EXPECT_EQ(read_error("}"), "a.map:1: expected { of an entity, found '}'");
    EXPECT_EQ(read_error("\nword"), "a.map:2: expected { of an entity, found 'word'");
    EXPECT_EQ(read_error("{\n}\n}"), "a.map:3: expected { of an entity after entity 0, found '}'");
    EXPECT_EQ(read_error("{\n"), "a.map:2: expected a key, a brush or } of entity 0, the file ends");
    EXPECT_EQ(read_error("{\n)"), "a.map:2: expected a key, a brush or } of entity 0, found ')'");
    EXPECT_EQ(read_error("{ \"a\"\n}"), "a.map:2: expected a value for the key 'a' of entity 0, found '}'");
    EXPECT_EQ(read_error("{ \"a\" \"b }\n\n"), "a.map:1: quote without an end: 'b }\\x0a\\x0a'");
    EXPECT_EQ(read_error(open), "a.map:4: expected ( of a side or } in brush 0 of entity 0, the file ends");
    EXPECT_EQ(read_error(open + "( 1 2 )"), "a.map:4: expected a number of a point in brush 0 of entity 0, found ')'");
    EXPECT_EQ(read_error(open + "( 1 2 x )"),
              "a.map:4: expected a number of a point in brush 0 of entity 0, found 'x'");
    EXPECT_EQ(read_error(open + "( 1 2 nan )"),
              "a.map:4: expected a number of a point in brush 0 of entity 0, found 'nan'");
    EXPECT_EQ(read_error(open + "( 1 2 1e999 )"), "a.map:4: '1e999' in brush 0 of entity 0 is too large for a number");
    EXPECT_EQ(read_error(open + "( 1 2 3 4 )"), "a.map:4: expected ) of a point in brush 0 of entity 0, found '4'");
    const std::string points = "( 0 0 0 ) ( 0 1 0 ) ( 1 0 0 ) ";
    EXPECT_EQ(read_error(open + points), "a.map:4: expected a texture in brush 0 of entity 0, the file ends");
    EXPECT_EQ(read_error(open + points + "wall 0 0 0 1\n}"),
              "a.map:5: expected a number of the texture's alignment in brush 0 of entity 0, found '}'");
    EXPECT_EQ(read_error(open + points + "wall [ 0 0 0 1 ] 0 0 0 0 ] 0 1 1\n}"),
              "a.map:4: expected [ of the texture's alignment in brush 0 of entity 0, found '0'");
    EXPECT_EQ(read_error(open + points + "wall 0 0 0 1 1\n\"a\""),
              "a.map:5: expected ( of a side or } in brush 0 of entity 0, found 'a'");
    EXPECT_EQ(read_error(open + "brushDef8\n{\n}\n"),
              "a.map:4: 'brushDef8' in brush 0 of entity 0 has no end: braces do not match");
    EXPECT_EQ(read_error(world(patch("a", "3 4 0 0 0"))),
              "a.map:7: patch of 3 x 4 control points in brush 0 of entity 0; both must be odd, from 3 to 1023");
    EXPECT_EQ(read_error(world(patch("a", "1e9 3 0 0 0"))),
              "a.map:7: patch of 1e+09 x 3 control points in brush 0 of entity 0; both must be odd, from 3 to 1023");
    EXPECT_EQ(read_error(world(patch("a", "5 3 0 0 0"))),
              "a.map:12: expected ( of a patch's points in brush 0 of entity 0, found ')'");
    EXPECT_EQ(read_error(world(patch("a", "3 5 0 0 0"))),
              "a.map:9: expected ( of a patch's points in brush 0 of entity 0, found ')'");
}

TEST(ReadMap, PointsOutsideTheWorldNameTheirBrush) {
    std::string text = world(textured_box());
    const std::size_t at = text.find("64.000000");
    text.replace(at, 9, "262144");
    EXPECT_EQ(read_error(text),
              "a.map:5: entity 0 (worldspawn), brush 0: side 1, point 0: lies outside the world: x = 8192 m");
    EXPECT_EQ(read(text).error().code, ErrorCode::kOutOfRange);
    std::string bent = world(patch());
    bent.replace(bent.find("( 128 0 16"), 10, "( 128 0 -1e30");
    EXPECT_EQ(read_error(bent),
              "a.map:3: entity 0 (worldspawn), brush 0: control point 2: lies outside the world: "
              "z = -3.125e+28 m");
}

TEST(ReadMap, CountsAreLimited) {
    std::string sides;
    for (int k = 0; k < 1024; ++k) sides += "( 0 0 0 ) ( 0 1 0 ) ( 1 0 0 ) wall 0 0 0 1 1\n";
    EXPECT_EQ(read(world("{\n" + sides + "}\n")).value().sides.size(), 1024u);
    const auto many = read(world("{\n" + sides + "( 0 0 0 ) ( 0 1 0 ) ( 1 0 0 ) wall 0 0 0 1 1\n}\n"));
    ASSERT_FALSE(many.ok());
    EXPECT_EQ(many.error().text(), "a.map:1028: more than 1024 sides in brush 0 of entity 0");
    EXPECT_EQ(many.error().code, ErrorCode::kTooLarge);
    const std::string braces(1000000, '{');
    EXPECT_FALSE(read(braces).ok());
    EXPECT_FALSE(read("{ { a " + braces).ok());
    EXPECT_TRUE(read("{ { a " + braces + std::string(1000000, '}') + " } }").ok());
    EXPECT_FALSE(read("{ " + std::string(1000000, '"')).ok());
}

// Truncated anywhere, or with bytes changed: an error with a place, or a level.
TEST(ReadMap, HostileBytes) {
    const std::string text =
        world(textured_box() + textured_box("{fence", " [ 1 0 0 0 ] [ 0 -1 0 -16.5 ] 0 1 1 0 0 0") + patch() +
              "{ brushDef8 { } }\n") +
        world(
            "{ brushDef { ( 0 0 0 ) ( 0 1 0 ) ( 1 0 0 ) ( ( 1 0 0 ) ( 0 1 0 ) ) a/b 0 0 0 } }\n"
            "{ brushDef3 { \"k\" \"v\" ( 0 0.6 0.8 -5.25 ) ( ( 1 0 0 ) ( 0 1 0 ) ) \"a\" 0 0 0 } }\n") +
        "{ \"classname\" \"func_door\" \"a\" \"b \\\" c\"\n" + textured_box("*water") + "}\n";
    std::size_t errors = 0;
    const auto judge = [&](const std::string& bytes) {
        const auto level = read(bytes);
        if (level.ok()) {
            for (const Brush& brush : level.value().brushes) {
                ASSERT_LE(std::size_t(brush.first_side) + brush.side_count, level.value().sides.size());
                ASSERT_LT(brush.entity, level.value().entities.size());
            }
            return;
        }
        ++errors;
        ASSERT_TRUE(level.error().place.starts_with("a.map")) << level.error().place;
        ASSERT_LT(level.error().text().size(), 300u);
    };
    for (std::size_t k = 0; k < text.size(); ++k) judge(text.substr(0, k));
    EXPECT_GT(errors, text.size() * 9 / 10);
    scenes::Rng rng(11);
    for (int round = 0; round < 3000; ++round) {
        std::string bytes = text;
        for (int change = 0; change < 1 + round % 4; ++change) {
            const auto at = std::size_t(rng.below(std::uint32_t(bytes.size())));
            constexpr char kBytes[] = "{}()[]\"\\/ \n09.-+eaZ\0\x1f\xff";
            bytes[at] = kBytes[rng.below(sizeof kBytes - 1)];
        }
        judge(bytes);
    }
}

}  // namespace
}  // namespace firma

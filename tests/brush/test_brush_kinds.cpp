// SPDX-License-Identifier: MIT
// Which game a .map is of, and what its names and numbers then mean.
#include "brush/brush_kinds.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/brush/map_text.h"

namespace firma {
namespace {

using namespace map_text;

/// Of the last brush.
BrushKind kind_in(const std::string& text) {
    const auto level = read_map(text, "a.map");
    EXPECT_TRUE(level.ok()) << level.error().text();
    return level.ok() ? level.value().brushes.back().kind : BrushKind::kData;
}

std::string one(const std::string& texture, const std::string& numbers) {
    return world(box({0, 0, 0}, {64, 32, 96}, texture, "0 0 0 0.5 0.5 " + numbers));
}

// Finding 22: what editors left of a texture that was there before.
TEST(BrushKinds, StaleNumbersOfShaderGamesAreNothing) {
    EXPECT_EQ(kind_in(one("common/caulk", "0 4 0")), BrushKind::kSolid);
    EXPECT_EQ(kind_in(one("common/hint", "1 0 0")), BrushKind::kPortal);
    EXPECT_EQ(kind_in(one("common/clip", "1 4 0")), BrushKind::kPlayerClip);
    EXPECT_EQ(kind_in(one("COMMON\\Trigger", "1 0 0")), BrushKind::kData);
    EXPECT_EQ(kind_in(one("textures/base_wall/a", "0 4 0")), BrushKind::kSolid);
    EXPECT_EQ(kind_in(one("textures/skies/a", "1 0 0")), BrushKind::kSky);
    // One such name in a file is enough for all of it.
    const std::string wall = box({0, 0, 0}, {8, 8, 8}, "base_wall/a", "0 0 0 1 1 0 4 0");
    EXPECT_EQ(kind_in(world(wall)), BrushKind::kSky);
    EXPECT_EQ(kind_in(world(box({9, 0, 0}, {10, 8, 8}, "common/caulk") + wall)), BrushKind::kSolid);
    EXPECT_EQ(kind_in(world(primitive_box({9, 0, 0}, {10, 8, 8}) + wall)), BrushKind::kSolid);
    EXPECT_EQ(kind_in(world(primitive_box({9, 0, 0}, {10, 8, 8}, "a/b", "0 4 0"))), BrushKind::kSolid);
    const BrushLevel detail = read_map(one("common/caulk", "134217728 0 0"), "a.map").value();
    EXPECT_TRUE(detail.brushes[0].detail);  // this bit alone compilers look at
    EXPECT_EQ(detail.brushes[0].kind, BrushKind::kSolid);
}

TEST(BrushKinds, TheCommentOnTheFormatGoesFirst) {
    const std::string quake3 = "// Game: Quake 3\n// Format: Quake3 (legacy)\n// entity 0\n";
    const std::string quake2 = "\xEF\xBB\xBF// Game: Quake 2\r\n// Format: Quake2\r\n";
    EXPECT_EQ(kind_in(one("base_wall/a", "0 4 0")), BrushKind::kSky);
    EXPECT_EQ(kind_in(quake3 + one("base_wall/a", "0 4 0")), BrushKind::kSolid);
    EXPECT_EQ(kind_in(quake2 + one("e1u1/a", "0 4 0")), BrushKind::kSky);
    EXPECT_EQ(kind_in(quake2 + one("common/caulk", "0 4 0")), BrushKind::kSky);
    EXPECT_EQ(kind_in("// Game: x\n" + one("common/caulk", "0 4 0")), BrushKind::kSolid);
    EXPECT_EQ(kind_in(one("a", "0 4 0") + quake3), BrushKind::kSky);  // not at the top
}

TEST(BrushKinds, GameByWhatOnlyItHas) {
    const auto game = [](std::string_view format, bool primitives, std::vector<std::string_view> textures) {
        return map_game(format, primitives, textures);
    };
    EXPECT_EQ(game("", false, {}), MapGame::kNumbers);
    EXPECT_EQ(game("", false, {"e1u1/clip", "common", "uncommon/caulk", "city4_2"}), MapGame::kNumbers);
    EXPECT_EQ(game("", false, {"a", "Textures\\Common\\caulk"}), MapGame::kShaders);
    EXPECT_EQ(game("", false, {"textures/a"}), MapGame::kShaders);
    EXPECT_EQ(game("", true, {}), MapGame::kShaders);
    for (const char* format : {"Quake3", "Quake3 (legacy)", "Quake3 (Valve)"})
        EXPECT_EQ(game(format, false, {}), MapGame::kShaders);
    for (const char* format : {"Quake2", "Quake2 (Valve)", "Valve", "Standard", "Hexen2", "Daikatana"})
        EXPECT_EQ(game(format, true, {"common/caulk"}), MapGame::kNumbers);
}

TEST(BrushKinds, NamesOfShaderGames) {
    const auto kind_of = [](const std::string& name) {
        return kind_in(world(primitive_box({0, 0, 0}, {64, 32, 96}, name, "1 4 0")));
    };
    struct {
        BrushKind kind;
        std::vector<const char*> names;
    } const kinds[] = {
        {BrushKind::kSolid,
         {"common/caulk", "textures/common/caulk", "Textures\\COMMON\\Caulk", "common/forcecaulk", "common/terrain2",
          "common/nolightmap", "common/invisible", "common/collision", "a/slick", "a/nodraw", "base_trim/skip",
          "common/noimpact", "hellfog"}},
        {BrushKind::kPlayerClip,
         {"common/clip", "textures/common/playerclip", "common/player_clip", "common/full_clip", "common/metalclip",
          "common/missileclip", "common/clip_metal", "common/clipfull", "common/clipmissile", "common/ladder",
          "common/nowalljumpclip", "editor/no_walljump", "common/slickplayerclip", "mymap/clip"}},
        {BrushKind::kGlass,
         {"common/weapclip", "common/weaponclip", "common/fullclip", "common/clipweap_metal", "common/slick",
          "common/cushion", "textures/glass/pane"}},
        {BrushKind::kShotClip, {"common/clipshot", "mymap/weapclip"}},
        {BrushKind::kPortal,
         {"common/hint", "common/areaportal", "common/subtlehint", "common/hintlocal", "textures/editor/visportal",
          "common/portal"}},
        {BrushKind::kData,
         {"common/botclip",    "common/monsterclip",   "common/monster_clip",     "common/clipmonster",
          "common/donotenter", "common/aidonotenter",  "common/clusterportal",    "common/antiportal",
          "common/lightgrid",  "common/origin",        "common/trigger",          "textures/common/trigmulti",
          "common/nodrop",     "common/nodraw",        "common/nodrawnonsolid",   "common/skip",
          "common/hintskip",   "common/nobuild",       "common/nohumanbuild",     "common/alpha_050",
          "common/shadow2",    "common/moveable_clip", "textures/common/ik_clip", "fogs/a",
          "sfx/fog_intel",     "sfx/hellfog",          "sfx/xdensegreyfog"}},
        {BrushKind::kLiquid,
         {"liquids/lava1", "textures/liquids_water/a", "common/watercaulk", "common/lavacaulk", "common/slimecaulk",
          "common/nodrawwater", "common/water", "common/lava"}},
        {BrushKind::kSky, {"skies/a", "textures/skies/hell", "common/sky", "common/skybox", "mymap/sky1", "sky/a"}},
    };
    for (const auto& [kind, names] : kinds)
        for (const char* name : names) EXPECT_EQ(kind_of(name), kind) << name;
}

// What the documentation tells authors of levels for Firma, whatever game their editor is set up for.
TEST(BrushKinds, NamesOfOurs) {
    const std::string valve = "// Game: Firma\n// Format: Valve\n";
    const auto kind_of = [&](const std::string& name) {
        return kind_in(valve + world(box({0, 0, 0}, {64, 32, 96}, name, "[ 1 0 0 0 ] [ 0 -1 0 0 ] 0 1 1")));
    };
    EXPECT_EQ(kind_of("common/weapclip"), BrushKind::kShotClip);
    EXPECT_EQ(kind_of("common/missileclip"), BrushKind::kShotClip);
    EXPECT_EQ(kind_of("common/skip"), BrushKind::kSolid);
    EXPECT_EQ(kind_of("common/nodraw"), BrushKind::kSolid);
    EXPECT_EQ(kind_of("common/portal"), BrushKind::kPortal);
}

TEST(BrushKinds, PatchesGoByTheirNamesToo) {
    std::string text = "{\npatchDef2\n{\nbase/curve\n( 3 3 0 4 0 )\n(\n";
    for (int x = 0; x < 3; ++x) {
        text += "( ";
        for (int y = 0; y < 3; ++y) text += "( " + std::to_string(64 * x) + " " + std::to_string(32 * y) + " 16 0 0 ) ";
        text += ")\n";
    }
    const BrushLevel level = read_map(world(text + ")\n}\n}\n"), "a.map").value();
    ASSERT_EQ(level.surfaces.faces.size(), 1u);
    EXPECT_EQ(level.surfaces.faces[0].mask, side_mask(BrushKind::kSolid, false));
}

}  // namespace
}  // namespace firma

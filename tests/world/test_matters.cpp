// SPDX-License-Identifier: MIT
// What worlds are made of: tables, which texture is of which matter, pieces of brushes and meshes, overlaps.
#include <gtest/gtest.h>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/matter.h"
#include "firma/save.h"
#include "join/body_solid.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/solid/solid_levels.h"
#include "tests/world/matter_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

TEST(Matters, TheBuiltInTableKnowsUsualNames) {
    const MatterTable& table = default_matters();
    EXPECT_FALSE(check_matters(table));
    const auto of = [&](const char* texture) { return table.matters[matter_of_texture(table, texture)].name; };
    EXPECT_EQ(of("depot/brick_dark"), "brick");
    EXPECT_EQ(of("CONCRETE_wall"), "concrete");
    EXPECT_EQ(of("textures\\base\\Metal4"), "steel");
    EXPECT_EQ(of("depot/wood_panel"), "wood");
    EXPECT_EQ(of("glass"), "glass");
    EXPECT_EQ(of("glass/clear"), "glass");
    EXPECT_EQ(of("Glass\\brick_frame"), "glass");
    EXPECT_EQ(of("textures/glass/clear"), "glass");
    EXPECT_EQ(of("hourglass/clear"), "");
    EXPECT_EQ(of("glasses/clear"), "");
    EXPECT_EQ(of("mossy_rocks"), "rock");
    EXPECT_EQ(of("brick/door"), "");  // a folder does not say it
    EXPECT_EQ(of(""), "");
    for (const char* name : {"brick", "concrete", "wood", "steel", "glass", "rock"}) {
        const auto index = matter_named(table, name);
        ASSERT_TRUE(index) << name;
        EXPECT_EQ(table.matters[*index].inside, std::string("matter/") + name);
        EXPECT_EQ(table.matters[*index].hardness, 0);
    }
    EXPECT_EQ(matter_named(table, "jelly"), std::nullopt);
}

TEST(Matters, PatternsStandForAnyLetters) {
    MatterTable table;
    table.matters.emplace_back().name = "it";
    const auto fits = [&](const char* pattern, const char* name) {
        table.patterns = {{pattern, 1}};
        return matter_of_texture(table, name) == 1;
    };
    EXPECT_TRUE(fits("*", "anything"));
    EXPECT_TRUE(fits("a*c", "abbbc"));
    EXPECT_TRUE(fits("a*c", "AC"));
    EXPECT_FALSE(fits("a*c", "acd"));
    EXPECT_TRUE(fits("a*b*c", "axbxbxc"));
    EXPECT_FALSE(fits("a", "b/ab"));
    EXPECT_TRUE(fits("a*", "b/ab"));
    EXPECT_TRUE(fits("b/*", "b/ab"));
    EXPECT_FALSE(fits("b/*", "c/b/ab"));
    EXPECT_TRUE(fits("*/b/*", "c/b/ab"));
    // Takes the product of the lengths at most.
    EXPECT_FALSE(fits("*a*a*a*a*a*a*a*a*a*a*a*b", std::string(255, 'a').c_str()));
}

TEST(Matters, ATableIsReadAsText) {
    const Result<MatterTable> read = read_matters(
        "# a game's\r\n\nmatter jelly\n  inside jelly/cut open\n\ttexture *jelly*\n  texture sweets/*\n density 1.1e3\n"
        "strength 0\nhardness .25\nfracture splinters\nmatter diamond\nhardness 1\ntexture gem*\n",
        "table");
    ASSERT_TRUE(read.ok()) << read.error().text();
    const MatterTable& table = read.value();
    EXPECT_FALSE(check_matters(table));
    ASSERT_EQ(table.matters.size(), 3u);
    EXPECT_EQ(table.matters[0], Matter{});
    EXPECT_EQ(table.matters[1], (Matter{"jelly", "jelly/cut open", 1100, 0, 0.25, FractureStyle::kSplinters}));
    EXPECT_EQ(table.matters[2].hardness, 1);
    EXPECT_EQ(matter_of_texture(table, "sweets/lolly"), 1u);
    EXPECT_EQ(matter_of_texture(table, "x/gem7"), 2u);
    const Result<MatterTable> other =
        read_matters("default b\nmatter a\ntexture a\nmatter b\nmatter c\ntexture c\n", "t");
    ASSERT_TRUE(other.ok()) << other.error().text();
    ASSERT_EQ(other.value().matters.size(), 3u);
    EXPECT_EQ(other.value().matters[0].name, "b");
    EXPECT_EQ(other.value().matters[matter_of_texture(other.value(), "a")].name, "a");
    EXPECT_EQ(other.value().matters[matter_of_texture(other.value(), "c")].name, "c");
    EXPECT_EQ(matter_of_texture(other.value(), "x"), 0u);
}

TEST(Matters, BadTablesSayWhere) {
    const auto error = [](const std::string& text) {
        const Result<MatterTable> read = read_matters(text, "t.matter");
        return read.ok() ? std::string("fine") : read.error().text();
    };
    EXPECT_EQ(error(""), "t.matter: there is no 'matter' in it");
    EXPECT_EQ(error("density 3\n"), "t.matter:1: 'density' stands before the first 'matter'");
    EXPECT_EQ(
        error("matter a\ncolour red\n"),
        "t.matter:2: 'colour' is none of: matter, inside, texture, density, strength, hardness, fracture, default");
    EXPECT_EQ(error("matter a\n\nmatter a\n"), "t.matter:3: there is a matter 'a' already");
    EXPECT_EQ(error("matter\n"), "t.matter:1: 'matter' has no value");
    EXPECT_EQ(error("matter a\ndensity 0\n"), "t.matter:2: a density must be above zero");
    EXPECT_EQ(error("matter a\ndensity heavy\n"), "t.matter:2: 'heavy' is no finite number");
    EXPECT_EQ(error("matter a\ndensity 1e999\n"), "t.matter:2: '1e999' is no finite number");
    EXPECT_EQ(error("matter a\nstrength -1\n"), "t.matter:2: a strength must not be below zero");
    EXPECT_EQ(error("matter a\nhardness 1.5\n"), "t.matter:2: a hardness must be within 0 and 1");
    EXPECT_EQ(error("matter a\nfracture melts\n"), "t.matter:2: 'melts' is none of: chunks, splinters, bends, pane");
    EXPECT_EQ(error("matter a\ndefault b\n"), "t.matter:2: no matter 'b' is in the table");
    EXPECT_EQ(error("default a\ndefault a\nmatter a\n"), "t.matter:2: a second 'default'");
    EXPECT_EQ(error("matter " + std::string(300, 'x') + "\n"), "t.matter:1: a value of more than 255 bytes");
    EXPECT_EQ(error(std::string("matter a\0b", 10)), "t.matter:1: holds a zero byte");
    std::string many;
    for (int k = 0; k < 4097; ++k) many += "matter m" + std::to_string(k) + "\n";
    EXPECT_EQ(error(many), "t.matter:4096: more than 4095 matters");
}

TEST(Matters, BadTablesByHandAreRefused) {
    const auto fault = [](auto change) {
        MatterTable table = default_matters();
        change(table);
        WorldOptions options;
        options.matters = table;
        const Result<World> world = make_world(test::box_level({0, 0, 0}, {1, 1, 1}), options);
        return world.ok() ? std::string("fine") : world.error().text();
    };
    EXPECT_EQ(fault([](MatterTable&) {}), "fine");
    EXPECT_EQ(fault([](MatterTable& t) { t.matters.clear(); }), "matters: there is none");
    EXPECT_EQ(fault([](MatterTable& t) { t.matters[1].density = -1; }),
              "matter 1 'brick': its density is no finite number above zero");
    EXPECT_EQ(fault([](MatterTable& t) { t.matters[2].hardness = 2; }),
              "matter 2 'concrete': its hardness is not within 0 and 1");
    EXPECT_EQ(fault([](MatterTable& t) { t.matters[2].name = "brick"; }),
              "matter 2 'brick': another one has the same name");
    EXPECT_EQ(fault([](MatterTable& t) { t.matters[1].fracture = FractureStyle(9); }),
              "matter 1 'brick': its fracture style is none");
    EXPECT_EQ(fault([](MatterTable& t) { t.patterns[0].matter = 99; }),
              "pattern 0: it is of a matter that is not there");
    EXPECT_EQ(fault([](MatterTable& t) { t.patterns[0].pattern = ""; }),
              "pattern 0: it is empty, or of more than 255 bytes");
}

TEST(Matters, BrushesAreOfTheMatterOfTheirTextures) {
    const World world = test::brush_world(test::three_matters());
    EXPECT_EQ(test::name_at(world, {1, 1, 1}), "brick");
    EXPECT_EQ(test::name_at(world, {5, 1, 1}), "wood");
    EXPECT_EQ(test::name_at(world, {9, 1, 1}), "steel");
    EXPECT_EQ(test::name_at(world, {20, 1, 1}), "");
    EXPECT_EQ(test::name_at(world, {1e300, 1, 1}), "");
    EXPECT_EQ(test::name_at(world, {NAN, 1, 1}), "");
    const MatterCounts counts = count_matters(world);
    EXPECT_EQ(counts.pieces, 3u);
    EXPECT_EQ(counts.protected_pieces, 0u);
    EXPECT_EQ(counts.of_matter[*matter_named(default_matters(), "wood")], 1u);
    for (const Face& face : world.faces()) {
        const auto found = matter_of(world, face.ref());
        ASSERT_TRUE(found);
        Vec3 sum;
        for (const Vec3& corner : face.corners) sum = sum + corner;
        EXPECT_EQ(*found, matter_at(world, sum * (1.0 / double(face.corners.size())) - face.normal * 0.01));
    }
    EXPECT_EQ(matter_of(world, FaceRef{}), std::nullopt);
}

TEST(Matters, MostSidesDecideAndFillersSayNothing) {
    std::string brush = "{\n";
    const auto points = map_text::box_points({0, 0, 0}, {4, 4, 4});
    const char* textures[6] = {"common/caulk", "common/caulk", "wood1", "brick1", "plain", "wood2"};
    for (int k = 0; k < 6; ++k) {
        for (const Vec3& p : points[std::size_t(k)]) brush += map_text::point(p);
        brush += std::string(textures[k]) + " 0 0 0 1 1\n";
    }
    EXPECT_EQ(test::name_at(test::brush_world(brush + "}\n"), {1, 1, 1}), "wood");
}

TEST(Matters, WhereBrushesOverlapTheLowerNumberWinsAndWhatMayNotBeCarvedBeforeIt) {
    const std::string level = map_text::box({0, 0, 0}, {4, 4, 4}, "brick") +
                              map_text::box({2, 0, 0}, {6, 4, 4}, "wood") +
                              map_text::box({3, 0, 0}, {8, 4, 4}, "skyblue");
    const World world = test::brush_world(level);
    EXPECT_EQ(test::name_at(world, {1, 1, 1}), "brick");
    EXPECT_EQ(test::name_at(world, {2.5, 1, 1}), "brick");
    EXPECT_EQ(test::name_at(world, {3.5, 1, 1}), "");  // the sky
    EXPECT_EQ(test::name_at(world, {5, 1, 1}), "");
    EXPECT_EQ(count_matters(world).protected_pieces, 1u);
    MatterTable table = default_matters();
    table.matters[*matter_named(table, "wood")].hardness = 1;
    WorldOptions options;
    options.matters = table;
    const World hard = test::brush_world(level, options);
    EXPECT_EQ(test::name_at(hard, {2.5, 1, 1}), "wood");
    EXPECT_EQ(test::name_at(hard, {3.5, 1, 1}), "wood");
    EXPECT_EQ(count_matters(hard).protected_pieces, 2u);
    // What the rules say of the sky's material counts.
    CarveRules rules;
    rules.hardness.assign(16, 0);
    EXPECT_EQ(count_matters(with_rules(world, rules).value()).protected_pieces, 0u);
}

TEST(Matters, AnEntityMaySayIt) {
    const std::string text =
        "{\n\"classname\" \"worldspawn\"\n\"matter\" \"rock\"\n" + map_text::box({0, 0, 0}, {1, 1, 1}, "plain") +
        map_text::box({2, 0, 0}, {3, 1, 1}, "brick") + "}\n{\n\"classname\" \"func_group\"\n\"matter\" \"glass\"\n" +
        map_text::box({4, 0, 0}, {5, 1, 1}, "brick") + "}\n";
    const World world = make_world(read_map(text, "m", {.scale = 1}).value()).value();
    EXPECT_EQ(test::name_at(world, {0.5, 0.5, 0.5}), "rock");
    EXPECT_EQ(test::name_at(world, {2.5, 0.5, 0.5}), "brick");
    EXPECT_EQ(test::name_at(world, {4.5, 0.5, 0.5}), "glass");
}

Level three_boxes() {
    Level level = test::empty_level();
    level.materials = {"brick", "wood", "x"};
    test::add_box(level, {-9, -9, -9}, {9, 9, 9}, true);  // rock outside
    test::add_box(level, {-4, -4, -4}, {4, 4, 4});        // a block in the air
    test::add_box(level, {-3, -3, -3}, {3, 3, 3}, true);  // hollow
    test::add_box(level, {-2, -2, -2}, {2, 2, 2});        // and a block in it
    for (std::size_t k = 0; k < level.faces.size(); ++k) level.faces[k].material = k < 6 ? 0 : k < 18 ? 1 : 2;
    level.matters = {"", "", "steel"};
    return level;
}

TEST(Matters, ClosedMeshesAreOfTheMatterOfTheirFaces) {
    const World world = make_world(three_boxes()).value();
    EXPECT_EQ(test::name_at(world, {20, 0, 0}), "brick");
    EXPECT_EQ(test::name_at(world, {3.5, 0, 0}), "wood");
    EXPECT_EQ(test::name_at(world, {0, 0, 0}), "steel");
    EXPECT_EQ(count_matters(world).pieces, 2u);
    for (const Face& face : world.faces()) {
        const std::uint32_t found = *matter_of(world, face.ref());
        EXPECT_EQ(matter(world, found).name, face.source < 6 ? "brick" : face.source < 18 ? "wood" : "steel");
    }
    Level all = three_boxes();
    for (LevelFace& face : all.faces) face.material = 1;
    const World wood = make_world(all).value();
    EXPECT_EQ(count_matters(wood).pieces, 0u);  // nothing to tell apart
    EXPECT_EQ(test::name_at(wood, {0, 0, 0}), "wood");
    const World none = make_world(test::box_level({0, 0, 0}, {1, 1, 1})).value();
    EXPECT_EQ(none.data().matters, nullptr);
}

void expect_same_matter(const World& a, const World& b) {
    EXPECT_EQ(hash_world(a), hash_world(b));
    EXPECT_EQ(matters_of(a), matters_of(b));
    scenes::Rng rng(5);
    for (int k = 0; k < 300; ++k) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = rng.uniform(-10, 14);
        EXPECT_EQ(matter_at(a, p), matter_at(b, p));
    }
    for (const Face& face : a.faces()) EXPECT_EQ(matter_of(a, face.ref()), matter_of(b, face.ref()));
    EXPECT_EQ(count_matters(a).of_matter, count_matters(b).of_matter);
    EXPECT_EQ(count_matters(a).protected_pieces, count_matters(b).protected_pieces);
}

TEST(Matters, StayWithTheWorldThroughEditsAndFiles) {
    MatterTable table = default_matters();
    table.matters[1].hardness = 0.5;
    WorldOptions options;
    options.matters = table;
    for (const World& world :
         {test::brush_world(test::three_matters() + map_text::box({0, 4, 0}, {4, 8, 4}, "sky"), options),
          make_world(three_boxes()).value()}) {
        const Result<World> read = unpack_world(pack_world(world), "m");
        ASSERT_TRUE(read.ok()) << read.error().text();
        expect_same_matter(world, read.value());
        EXPECT_EQ(pack_world(read.value()), pack_world(world));
        const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, 3), test::pose_at(4, 1, 1, 1.5));
        ASSERT_TRUE(cut.done()) << cut.error.text();
        EXPECT_EQ(cut.world.data().matters, world.data().matters);  // shared
        const CarveResult again = carve(read.value(), make_crater(CutterShape::kRocky, 3), test::pose_at(4, 1, 1, 1.5));
        expect_same_matter(cut.world, again.world);
        const Result<World> cut_read = unpack_world(pack_world(cut.world), "m");
        ASSERT_TRUE(cut_read.ok()) << cut_read.error().text();
        expect_same_matter(cut.world, cut_read.value());
    }
}

TEST(Matters, AreInTheHash) {
    const World plain = test::brush_world(test::three_matters());
    EXPECT_EQ(hash_world(plain), hash_world(test::brush_world(test::three_matters())));
    MatterTable table = default_matters();
    table.matters[1].strength = 7;
    WorldOptions options;
    options.matters = table;
    EXPECT_NE(hash_world(plain), hash_world(test::brush_world(test::three_matters(), options)));
    EXPECT_EQ(hash_solid(plain), hash_solid(test::brush_world(test::three_matters(), options)));
}

TEST(BodySolid, IsTheCommonPartOfHalfSpaces) {
    // Rotated boxes and cut corners: vertices off the grid.
    scenes::Rng rng(7);
    for (int round = 0; round < 40; ++round) {
        std::vector<Ref<const SolidPlane>> planes;
        for (int axis = 0; axis < 3; ++axis) {
            planes.emplace_back(new SolidPlane(axis_plane(axis, 4096)));
            planes.emplace_back(new SolidPlane(flipped(axis_plane(axis, -4096))));
        }
        for (int k = 0; k < round % 9; ++k) {
            InputPoint p[3];
            for (InputPoint& it : p)
                for (int axis = 0; axis < 3; ++axis) it[axis] = std::int32_t(rng.uniform(-6000, 6000));
            Plane plane = plane_through(p[0], p[1], p[2]);
            if (!plane.valid()) continue;
            if (side_of_plane(plane, {0, 0, 0}) > 0) plane = flipped(plane);
            planes.emplace_back(new SolidPlane(plane));
        }
        const std::optional<Solid> solid = solid_of_planes(planes);
        ASSERT_TRUE(solid);
        const auto fault = check_solid(*solid);
        EXPECT_FALSE(fault) << fault->what;
        EXPECT_GT(measure_solid(*solid).volume, 0);
        EXPECT_LE(measure_solid(*solid).volume, 8 + 1e-9);
        for (int k = 0; k < 200; ++k) {
            Vec3 point;
            for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(-1.2, 1.2);
            const GridPoint at = *snap(point);
            bool inside = true, on = false;
            for (const auto& plane : planes) {
                inside = inside && side_of_plane(plane->plane, at) < 0;
                on = on || side_of_plane(plane->plane, at) == 0;
            }
            if (on) continue;
            EXPECT_EQ(locate(*solid, to_metres(at)) == Where::kSolid, inside);
        }
    }
    std::vector<Ref<const SolidPlane>> open{Ref<const SolidPlane>(new SolidPlane(axis_plane(0, 1)))};
    EXPECT_FALSE(solid_of_planes(open));
    EXPECT_FALSE(solid_of_planes({}));
}

}  // namespace
}  // namespace firma

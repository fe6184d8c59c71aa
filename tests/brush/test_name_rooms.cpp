// SPDX-License-Identifier: MIT
// Names that an author gives to rooms and portals, and volumes that mark something.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/rooms.h"

namespace firma {
namespace {

// Clockwise seen from outside, as Quake has it.
std::string brush_box(int x0, int x1, int y0, int y1, int z0, int z1, const std::string& texture,
                      const std::string& low_x = "") {
    const auto side = [&](int ax, int ay, int az, int bx, int by, int bz, int cx, int cy, int cz,
                          const std::string& t) {
        const auto point = [](int x, int y, int z) {
            return "( " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + " ) ";
        };
        return point(ax, ay, az) + point(bx, by, bz) + point(cx, cy, cz) + t + " 0 0 0 1 1\n";
    };
    return "{\n" + side(x0, y0, z0, x0, y1, z0, x0, y0, z1, low_x.empty() ? texture : low_x) +
           side(x1, y0, z0, x1, y0, z1, x1, y1, z0, texture) + side(x0, y0, z0, x0, y0, z1, x1, y0, z0, texture) +
           side(x0, y1, z0, x1, y1, z0, x0, y1, z1, texture) + side(x0, y0, z0, x1, y0, z0, x0, y1, z0, texture) +
           side(x0, y0, z1, x0, y1, z1, x1, y0, z1, texture) + "}\n";
}

std::string entity(const std::string& keys, const std::string& brushes = "") {
    return "{\n" + keys + brushes + "}\n";
}

std::string room(const std::string& name, const std::string& origin) {
    return entity("\"classname\" \"firma_room\"\n\"name\" \"" + name + "\"\n\"origin\" \"" + origin + "\"\n");
}

// A box of air from 0 to 256 by 128 by 128 within walls of 16, divided at x = 128.
std::string two_rooms() {
    const std::string walls =
        brush_box(-16, 0, -16, 144, -16, 144, "wall") + brush_box(256, 272, -16, 144, -16, 144, "wall") +
        brush_box(0, 256, -16, 0, -16, 144, "wall") + brush_box(0, 256, 128, 144, -16, 144, "wall") +
        brush_box(0, 256, 0, 128, -16, 0, "floor") + brush_box(0, 256, 0, 128, 128, 144, "roof");
    return entity("\"classname\" \"worldspawn\"\n", walls) +
           entity("\"classname\" \"func_areaportal\"\n\"targetname\" \"gate\"\n",
                  brush_box(128, 130, -8, 136, -8, 136, "skip", "portal"));
}

struct Made {
    BrushLevel level;
    World world;
    BrushWorldReport report;
};
Made make(const std::string& text) {
    BrushLevel level = read_map(text, "a.map").value();
    BrushWorldReport report;
    World world = make_world(level, {}, &report).value();
    return {std::move(level), std::move(world), std::move(report)};
}

std::string name_at(const World& world, const Vec3& units) {
    const Location at = locate(world, units * (1.0 / 32));
    return at.where == Where::kAir ? std::string(room_info(world, at.room)->name) : "nowhere";
}

TEST(NameRooms, ByEntitiesInThem) {
    const World world = make(two_rooms() + room("west", "32 64 64") + room("east", " 200  64 64.5 ")).world;
    ASSERT_EQ(world.room_count(), 3u);
    EXPECT_EQ(name_at(world, {100, 20, 20}), "west");
    EXPECT_EQ(name_at(world, {150, 20, 20}), "east");
    EXPECT_EQ(name_at(world, {500, 20, 20}), "exterior");
}

TEST(NameRooms, TheFirstNameStaysAndWhatIsInNoRoomNamesNone) {
    const Made made =
        make(two_rooms() + room("in the wall", "-8 64 64") + room("", "200 64 64") + room("nowhere", "200 64") +
             room("nowhere", "200 64 64 64") + room("nowhere", "x y z") + room("first", "32 64 64") +
             room("second", "40 64 64") + room("outer", "900 0 0") + room("on a wall", "0 64 64"));
    const World& world = made.world;
    EXPECT_EQ(name_at(world, {100, 20, 20}), "first");
    EXPECT_EQ(name_at(world, {150, 20, 20}), "");
    EXPECT_EQ(name_at(world, {500, 20, 20}), "exterior");
    std::vector<std::string> told;
    for (const EntityNote& note : made.report.entity_notes)
        told.push_back(std::to_string(note.entity) + " " + note.reason);
    const std::string no_origin = "it has no origin of three numbers";
    EXPECT_EQ(told, (std::vector<std::string>{
                        "2 it stands in the solid", "3 it has no name", "4 " + no_origin, "5 " + no_origin,
                        "6 " + no_origin, "8 the room it stands in has the name 'first' already",
                        "9 the room it stands in has the name 'exterior' already", "10 it stands on a face"}));
}

TEST(NameRooms, WithoutWallsAllIsTheExterior) {
    const Made made = make(entity("\"classname\" \"worldspawn\"\n", brush_box(0, 64, 0, 64, 0, 64, "common/clip")) +
                           room("meadow", "200 64 64"));
    EXPECT_EQ(locate(made.world, {3, 1, 1}), (Location{Where::kAir, {0}}));
    EXPECT_EQ(locate(made.world, {1, 1, 1}), (Location{Where::kAir, {0}}));
    ASSERT_EQ(made.report.entity_notes.size(), 1u);
    EXPECT_EQ(made.report.entity_notes[0].reason, "the room it stands in has the name 'exterior' already");
}

TEST(NameRooms, NamesChangeNothingElse) {
    const World plain = make(two_rooms()).world, named = make(two_rooms() + room("west", "32 64 64")).world;
    EXPECT_EQ(plain.face_count(), named.face_count());
    EXPECT_EQ(portal_info(plain, {0})->rooms, portal_info(named, {0})->rooms);
    EXPECT_FALSE(check_world(named));
}

TEST(NameRooms, PortalsAreNamedByTheirEntity) {
    const World world = make(two_rooms()).world;
    ASSERT_EQ(portal_count(world), 1u);
    EXPECT_EQ(portal_info(world, {0})->name, "gate");
}

TEST(NameRooms, AnchorsAreDataWithoutANote) {
    const Made made = make(
        two_rooms() + entity("\"classname\" \"firma_anchor\"\n", brush_box(-16, 16, 0, 128, 0, 128, "common/anchor")) +
        entity("\"classname\" \"firma_anchor\"\n", brush_box(-16, 16, 0, 128, 0, 128, "wall")));
    EXPECT_TRUE(made.level.notes.empty()) << made.level.notes[0];
    ASSERT_EQ(made.level.brushes.size(), 9u);
    EXPECT_EQ(made.level.brushes[7].kind, BrushKind::kData);
    EXPECT_EQ(made.level.brushes[8].kind, BrushKind::kData);
    EXPECT_EQ(made.world.face_count(), make(two_rooms()).world.face_count());
    const std::string anchor = entity("\"classname\" \"worldspawn\"\n", brush_box(0, 8, 0, 8, 0, 8, "common/anchor"));
    EXPECT_EQ(read_map(anchor, "a.map").value().brushes[0].kind, BrushKind::kData);
}

}  // namespace
}  // namespace firma

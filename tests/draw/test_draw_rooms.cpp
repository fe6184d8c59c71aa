// SPDX-License-Identifier: MIT
// Rooms and portals in plans and views: in numbers and colours; how they look is for eyes.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "draw/draw_plan.h"
#include "draw/draw_view.h"
#include "draw/plan_raster.h"
#include "draw/room_colours.h"
#include "firma/brush_world.h"
#include "firma/firma.h"
#include "firma/rooms.h"
#include "tests/world/two_halves.h"

namespace firma::draw {
namespace {

std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

const World& depot() {
    static const World world = make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value();
    return world;
}

TEST(RoomColours, ExteriorIsGreyAndManyDiffer) {
    const Vec3 grey = room_colour({5}, true);
    EXPECT_NEAR(grey.x, grey.z, 0.05);
    std::set<std::string> colours{hex_colour(grey)};
    for (std::uint32_t room = 0; room < 33; ++room) colours.insert(hex_colour(room_colour({room}, false)));
    EXPECT_EQ(colours.size(), 34u);
    EXPECT_EQ(hex_colour({0, 1, 0.5}), "#00ff80");
}

TEST(RoomColours, EachFaceIsOfItsRoom) {
    const World world = two_halves();
    const std::vector<Face> faces = world.faces();
    const std::vector<RoomId> rooms = rooms_of_faces(faces);
    for (std::size_t k = 0; k < faces.size(); ++k) EXPECT_EQ(rooms[k].value, k < 5 ? 0u : 1u);
    EXPECT_EQ(count_inner_rooms(world), 2u);
    EXPECT_EQ(room_label(world, {1}), "1");
}

TEST(RoomColours, PlansLeaveTheHullAndClipsAway) {
    const std::vector<Face> shown = faces_to_show(depot());
    EXPECT_LT(shown.size(), depot().face_count());
    Box box;
    for (const Face& face : shown) {
        EXPECT_NE(face.mask, kStopsWalk);
        for (const Vec3& corner : face.corners) box.add(corner);
    }
    EXPECT_GT(box.low.x, depot().bounds().low.x);
    const World open = make_world(read_obj("v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n", "sheet").value()).value();
    EXPECT_EQ(faces_to_show(open).size(), 1u);
}

TEST(DrawRooms, TwoRoomsAndADoor) {
    const Plan open = draw_plan(two_halves(), {}), closed = draw_plan(two_halves(false), {});
    EXPECT_TRUE(open.shows_rooms);
    EXPECT_EQ(open.rooms_labelled, 2u);
    EXPECT_EQ(open.portals_drawn, 1u);
    EXPECT_EQ(count_of(open.svg, "class=\"portal open\" d=\"M"), 3u);  // plan, section, legend
    EXPECT_EQ(count_of(open.svg, "portal closed"), 0u);
    EXPECT_GE(count_of(closed.svg, "class=\"portal closed\""), 2u);
    EXPECT_NE(closed.svg.find("<title>portal 0 door: 0 - 1, closed</title>"), std::string::npos);

    const Plan plain = draw_plan(two_halves(), {}, {.rooms = false});
    EXPECT_FALSE(plain.shows_rooms);
    EXPECT_EQ(plain.portals_drawn + plain.rooms_labelled, 0u);
    EXPECT_EQ(count_of(plain.svg, "class=\"portal"), 0u);
    EXPECT_EQ(plain.faces_in_plan, open.faces_in_plan);
}

TEST(DrawRooms, OneRoomOnlyWhenAsked) {
    const World world = make_world(read_obj("v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n", "sheet").value()).value();
    EXPECT_FALSE(draw_plan(world, {}).shows_rooms);
    EXPECT_EQ(draw_plan(world, {}, {.rooms = true}).rooms_labelled, 1u);
    EXPECT_EQ(draw_plan(World(), {}, {.rooms = true}).rooms_labelled, 0u);
}

TEST(DrawRooms, AStoreyOfTheDepot) {
    const Plan all = draw_plan(depot(), {}), ground = draw_plan(depot(), {}, {.below = 3.0});
    EXPECT_NE(all.svg.find("director"), std::string::npos);
    EXPECT_NE(ground.svg.find(">office_west</text>"), std::string::npos);
    EXPECT_NE(ground.svg.find(">hall</text>"), std::string::npos);
    EXPECT_EQ(ground.svg.find(">director</text>"), std::string::npos);  // upstairs: in the legend alone
    EXPECT_NE(ground.svg.find("7 director</text>"), std::string::npos);
    EXPECT_NE(ground.svg.find("Plan: cut at z = 3 m"), std::string::npos);
    EXPECT_LT(ground.portals_drawn, all.portals_drawn);
    EXPECT_EQ(all.portals_drawn, portal_count(depot()));
}

TEST(PlanRaster, TheNearestFaceInEachSquare) {
    View view;
    view.region = {{0, 0, 0}, {8, 4, 4}};
    view.scale = 30;
    view.corner = {10, 130};
    const std::vector<Face> faces = two_halves().faces();
    const PlanRaster raster = make_raster(view, faces, {});
    ASSERT_EQ(raster.width, 80);
    ASSERT_EQ(raster.height, 40);
    EXPECT_EQ(raster.face[raster.at(10, 20)], 0u);  // floors: the ceilings look down
    EXPECT_EQ(raster.face[raster.at(70, 20)], 5u);
    EXPECT_EQ(raster.nearness[raster.at(10, 20)], 0);
    const std::vector<Vec3> above{{1, 1, 2}, {2, 1, 2}, {1, 2, 2}}, below{{1, 1, -2}, {2, 1, -2}, {1, 2, -2}};
    EXPECT_TRUE(is_seen(raster, view, above));
    EXPECT_FALSE(is_seen(raster, view, below));
    const PlanRaster cut = make_raster(view, faces, -1.0);  // all lies above
    EXPECT_EQ(cut.face[cut.at(10, 20)], PlanRaster::kNothing);
}

Camera through_the_door() {
    Camera camera;
    camera.eye = {1, 2, 2};
    camera.target = {8, 2, 2};
    camera.width = 60;
    camera.height = 40;
    return camera;
}

TEST(DrawRooms, ViewsShowRoomsAndPanes) {
    const Picture plain = draw_view(two_halves(), through_the_door());
    const Picture open = draw_view(two_halves(), through_the_door(), true);
    const Picture closed = draw_view(two_halves(false), through_the_door(), true);
    const Colour far_plain = plain.at(30, 20), far_open = open.at(30, 20), far_closed = closed.at(30, 20);
    EXPECT_NEAR(far_plain[0], far_plain[2], 6);              // grey
    EXPECT_GT(int(far_closed[0]), int(far_closed[1]) + 60);  // behind a red pane
    EXPECT_GT(int(far_open[0]) + 60, int(far_open[1]));      // orange behind a greenish one
    EXPECT_NE(far_open, far_closed);
    const Colour near_wall = open.at(2, 20);  // of the room one stands in, beside the door: blue
    EXPECT_GT(int(near_wall[2]), int(near_wall[0]) + 20);
    EXPECT_EQ(near_wall, closed.at(2, 20));
}

}  // namespace
}  // namespace firma::draw

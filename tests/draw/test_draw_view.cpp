// SPDX-License-Identifier: MIT
// What stands where in a view.
#include <gtest/gtest.h>

#include <string>

#include "draw/draw_view.h"
#include "firma/brush_level.h"
#include "firma/brush_world.h"
#include "firma/firma.h"

namespace firma::draw {
namespace {

/// 8 x 6 x 4 m of air.
World room() {
    std::string text;
    for (int k = 0; k < 8; ++k)
        text += "v " + std::to_string(8 * (k & 1)) + " " + std::to_string(6 * (k >> 1 & 1)) + " " +
                std::to_string(4 * (k >> 2 & 1)) + "\n";
    for (const char* face : {"1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"})
        text += std::string("f ") + face + "\n";
    return make_world(read_obj(text, "room").value()).value();
}

World with_crater(const World& world) {
    return carve(world, make_crater(CutterShape::kRocky, 1), {{8, 3, 2}, random_turn(1), 1}).world;
}

Camera toward_the_far_wall() {
    Camera camera;
    camera.eye = {1, 3, 2};
    camera.target = {8, 3, 2};
    camera.width = 60;
    camera.height = 40;
    return camera;
}

bool is_grey(const Colour& colour) {
    return std::abs(int(colour[0]) - int(colour[2])) < 10;
}

bool is_brown(const Colour& colour) {
    return colour[0] > colour[2] + 25;
}

TEST(DrawView, ACraterIsWhereItWasMade) {
    const World before = room(), after = with_crater(before);
    const Picture plain = draw_view(before, toward_the_far_wall()), carved = draw_view(after, toward_the_far_wall());
    ASSERT_EQ(carved.pixels.size(), 60u * 40u);
    int brown = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) {
            EXPECT_TRUE(is_grey(plain.at(x, y))) << x << ' ' << y;
            EXPECT_GT(plain.at(x, y)[0], 20);  // the room is closed: nothing is black
            EXPECT_GT(carved.at(x, y)[0], 10);
            brown += is_brown(carved.at(x, y));
        }
    EXPECT_TRUE(is_brown(carved.at(30, 20)));
    // A wall 7 m away is 14 m wide in the picture, 4.3 pixels a metre: a crater of about a metre is 50 to 100 of them.
    EXPECT_GT(brown, 30);
    EXPECT_LT(brown, 150);
    EXPECT_TRUE(is_grey(carved.at(2, 2)));
}

TEST(DrawView, UpIsUp) {
    Camera camera = toward_the_far_wall();
    camera.target = {8, 3, 3.9};  // the ceiling's edge comes into the middle
    const World after = with_crater(room());
    const Picture picture = draw_view(after, camera);
    int above = 0, below = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) (y < 20 ? above : below) += is_brown(picture.at(x, y));
    EXPECT_EQ(above, 0);
    EXPECT_GT(below, 30);
}

TEST(DrawView, ShareOfNewFaces) {
    const World before = room(), after = with_crater(before);
    EXPECT_EQ(share_of_new_faces(before.faces(), toward_the_far_wall()), 0);
    const double share = share_of_new_faces(after.faces(), toward_the_far_wall());
    EXPECT_GT(share, 0.01);
    EXPECT_LT(share, 0.07);
    Camera close = toward_the_far_wall();
    close.eye = {6.9, 3, 2};
    EXPECT_LT(share_of_new_faces(after.faces(), close), share);  // too close to be told from anything
}

TEST(DrawView, AnEmptyWorldIsBlack) {
    for (const Colour& colour : draw_view(World(), toward_the_far_wall()).pixels) EXPECT_EQ(colour, Colour{});
}

// Blue where the sky or water is, grey elsewhere.
bool is_blue_at_the_middle(const World& world, const Vec3& eye, const Vec3& target) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.width = camera.height = 9;
    const Picture picture = draw_view(world, camera);
    const Colour colour = picture.at(4, 4);
    return colour[2] > colour[0] + 20;
}

TEST(DrawView, LooksThroughGlassAndClipsAndPaintsSkyAndWater) {
    const World world = make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value();
    EXPECT_TRUE(is_blue_at_the_middle(world, {6.5, 7, 5}, {6.5, 7, 9.9})) << "through the pane of the skylight";
    EXPECT_TRUE(is_blue_at_the_middle(world, {38, 7, 9}, {44, 7, 16.5})) << "through the clip at the roof's edge";
    EXPECT_TRUE(is_blue_at_the_middle(world, {16, -6, 2}, {16, -6.1, -1})) << "the basin";
    EXPECT_FALSE(is_blue_at_the_middle(world, {18.5, 6, 2}, {18.5, 6.1, 0})) << "the hall's floor";
}

}  // namespace
}  // namespace firma::draw

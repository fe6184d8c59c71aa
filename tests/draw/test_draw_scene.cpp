// SPDX-License-Identifier: MIT
// What stands where in a scene: bodies at their poses, their shadows, players, what is in the air.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "draw/draw_scene.h"
#include "firma/firma.h"

namespace firma::draw {
namespace {

/// A closed box as text; its faces look inward where it is a room.
std::string box_text(const Vec3& low, const Vec3& high, bool inward) {
    std::string text;
    for (int k = 0; k < 8; ++k)
        text += "v " + std::to_string(k & 1 ? high.x : low.x) + " " + std::to_string(k >> 1 & 1 ? high.y : low.y) +
                " " + std::to_string(k >> 2 & 1 ? high.z : low.z) + "\n";
    for (const char* face : {"1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"}) {
        std::string corners(face);
        if (!inward) std::swap(corners[0], corners[6]), std::swap(corners[2], corners[4]);
        text += "f " + corners + "\n";
    }
    return text;
}

class DrawScene : public testing::Test {
protected:
    DrawScene() {
        camera.eye = {1, 3, 2};
        camera.target = {8, 3, 1};
        camera.width = 60;
        camera.height = 40;
    }

    Picture draw(const Tasks* tasks = nullptr) const { return draw_scene(world, things, camera, {4, 3, 3.9}, tasks); }
    /// Which pixels are others than without things.
    std::size_t changed(const Picture& picture) const {
        const Picture empty = draw_scene(world, {}, camera, {4, 3, 3.9});
        std::size_t count = 0;
        for (std::size_t k = 0; k < picture.pixels.size(); ++k) count += picture.pixels[k] != empty.pixels[k];
        return count;
    }
    static int sum(const Colour& colour) { return colour[0] + colour[1] + colour[2]; }

    World world = make_world(read_obj(box_text({0, 0, 0}, {8, 6, 4}, true), "room").value()).value();
    Solid cube = make_solid(read_obj(box_text({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, false), "cube").value()).value();
    DrawnThings things;
    Camera camera;
};

TEST_F(DrawScene, ABodyIsWhereItsPoseIs) {
    Pose pose;
    pose.position = {5, 3, 1.4};
    things.solids.push_back({cube, pose, 3});
    const Picture there = draw();
    EXPECT_GT(changed(there), 60u);
    EXPECT_NE(there.at(30, 20), draw_scene(world, {}, camera, {4, 3, 3.9}).at(30, 20));
    things.solids[0].pose.position.y = 5;  // to the left
    const Picture beside = draw();
    EXPECT_EQ(beside.at(30, 20), draw_scene(world, {}, camera, {4, 3, 3.9}).at(30, 20));
    things.solids[0].pose.position.x = -20;  // behind the eye, and behind the wall
    EXPECT_EQ(changed(draw()), 0u);
}

TEST_F(DrawScene, ABodyThrowsAShadowOnTheFloor) {
    Pose pose;
    pose.position = {4, 3, 3.2};  // right under the lamp: out of the picture, but its shadow is in it
    camera.target = {6, 3, -1};
    things.solids.push_back({cube, pose, 0});
    const Picture dark = draw(), bright = draw_scene(world, {}, camera, {4, 3, 3.9});
    std::size_t darker = 0;
    for (std::size_t k = 0; k < dark.pixels.size(); ++k) darker += sum(dark.pixels[k]) + 30 < sum(bright.pixels[k]);
    EXPECT_GT(darker, 100u);
}

TEST_F(DrawScene, PlayersAndWhatIsInTheAir) {
    things.players.push_back({{5, 3, 0.3}, {5, 3, 1.5}, 0.3});
    const Picture player = draw();
    EXPECT_GT(changed(player), 60u);
    EXPECT_GT(int(player.at(30, 20)[2]), int(player.at(30, 20)[0]));  // blue
    things.players.clear();
    DrawnPuff flash;
    flash.at = {5, 3, 1.43};
    flash.light = 1;
    things.puffs.push_back(flash);
    const Picture bright = draw(), empty = draw_scene(world, {}, camera, {4, 3, 3.9});
    EXPECT_GT(sum(bright.at(30, 20)), sum(empty.at(30, 20)));
    things.puffs[0].light = 0;
    things.puffs[0].cover = 1;
    things.puffs[0].colour = {0, 0, 0};
    EXPECT_LT(sum(draw().at(30, 20)), sum(empty.at(30, 20)) / 4);
    things.puffs[0].at.x = 20;  // behind the wall
    EXPECT_EQ(changed(draw()), 0u);
}

TEST_F(DrawScene, TheSameOnAnyTasks) {
    Pose pose;
    pose.position = {5, 3, 1};
    pose.rotation = random_turn(3);
    things.solids.push_back({cube, pose, 0});
    Tasks backward;
    backward.run = [](std::size_t count, void (*work)(void*, std::size_t), void* context, void*) {
        for (std::size_t k = count; k > 0; --k) work(context, k - 1);
    };
    EXPECT_EQ(draw(&backward).pixels, draw().pixels);
}

}  // namespace
}  // namespace firma::draw

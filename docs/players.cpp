// SPDX-License-Identifier: MIT
// The program of docs/players.md: a player walks along a wall, through a hole in it, and is put back when that closes.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::World> read = firma::read_world("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    firma::World world = read.value();
    const firma::PlayerShape shape = firma::make_player_capsule({.radius = 0.3, .height = 1.8}).value();

    // In the middle of a room, a bit above the floor. Nothing else is kept of a player than this.
    firma::Player player;
    player.position = {30, 22, 0.5};
    const auto walk = [&](const firma::PlayerWish& wish, double seconds) {
        for (int tick = 0; tick < int(seconds * 60); ++tick)
            player = firma::move_player(world, shape, player, wish, 1.0 / 60).player;
        std::printf("at %.2f %.2f %.2f, %s\n", player.position.x, player.position.y, player.position.z,
                    player.on_ground ? "on the ground" : "in the air");
    };
    walk({}, 1);                        // it falls
    walk({.velocity = {6, 0, 0}}, 10);  // until a wall stops it
    walk({.velocity = {6, 3, 0}}, 1);   // and along it
    walk({.velocity = {}, .jump = true}, 0.2);

    // A hole in the wall that it stands at, and through.
    const firma::Vec3 wall = player.position + firma::Vec3{0.5, 0, 0.9};
    world =
        firma::carve(world, firma::make_crater(firma::CutterShape::kRocky, 1), {.position = wall, .scale = 2}).world;
    walk({.velocity = {6, 0, 0}}, 0.4);

    // The wall is back: it is put where there is room.
    world = read.value();
    const firma::PlayerMove move = firma::move_player(world, shape, player, {}, 1.0 / 60);
    std::printf("pushed %.2f m, stuck: %s\n", firma::length(move.pushed), move.player.stuck ? "yes" : "no");
}

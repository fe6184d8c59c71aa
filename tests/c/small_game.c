/* SPDX-License-Identifier: MIT */
/* A small game for tests. */
#include "tests/c/small_game.h"

#include <math.h>

static const firma_pose kHere = {{0, 0, 0}, {0, 0, 0, 1}, 1};

firma_world make_hung_room(void) {
    const firma_world room = make_room();
    const firma_cutter hung = make_box(3, 3, 1, 4, 4, 5);
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    firma_world filled = {0}, held = {0};
    CHECK_OK(firma_carve(room, hung, &kHere, &fill, &filled, NULL));
    CHECK_OK(firma_world_with_anchors(filled, NULL, &held));
    CHECK_OK(firma_cutter_release(hung));
    CHECK_OK(firma_world_release(filled));
    CHECK_OK(firma_world_release(room));
    return held;
}

firma_world make_leaf(void) {
    const double x = 0.5, y = 0.125, z = 2;
    const double positions[] = {-x, -y, 0, x, -y, 0, x, y, 0, -x, y, 0, -x, -y, z, x, -y, z, x, y, z, -x, y, z};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8};
    mesh.corners = corners;
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_world world = {0};
    CHECK_OK(firma_world_from_mesh(&mesh, "leaf", NULL, &world));
    return world;
}

firma_body_shape make_ball(void) {
    const double sphere[4] = {0, 0, 0, 0.25};
    firma_mass mass;
    firma_body_shape shape = {0};
    CHECK_OK(firma_mass_of_ball(0.25, 1000, &mass));
    CHECK_OK(firma_body_shape_spheres(sphere, 1, &mass, &shape));
    return shape;
}

uint32_t add_door(firma_game game) {
    const firma_part_stop stops[2] = {{{6, 2, 0}, 0, 0, 1}, {{6, 2, 2}, 0, 1, 1}};
    firma_part_path path;
    firma_part_path_defaults(&path);
    path.stops = stops;
    path.stop_count = 2;
    firma_game_part door;
    firma_game_part_defaults(&door);
    door.world = make_leaf();
    door.path = &path;
    door.name = "door";
    door.waits = 1;
    uint32_t index = 77;
    CHECK_OK(firma_game_add_part(game, &door, &index));
    CHECK_OK(firma_world_release(door.world));
    return index;
}

firma_game make_game(firma_world room) {
    firma_game game = {0};
    CHECK_OK(firma_game_begin(room, 60, &game));
    add_door(game);
    firma_game_player player;
    firma_game_player_defaults(&player);
    CHECK_OK(firma_player_shape_capsule(NULL, &player.shape));
    player.player.position[0] = 1;
    player.player.position[1] = 6;
    player.player.position[2] = 0.01;
    player.wish.velocity[0] = 1;
    uint32_t index = 77;
    CHECK_OK(firma_game_add_player(game, &player, &index));
    CHECK(index == 0);
    CHECK_OK(firma_player_shape_release(player.shape));
    const firma_body_shape ball = make_ball();
    const firma_pose pose = {{2, 5, 1.5}, {0, 0, 0, 1}, 1};
    firma_body body;
    firma_body_defaults(&body);
    body.velocity[0] = 1;
    firma_body_id id = {77, 7};
    CHECK_OK(firma_game_add_body(game, ball, &pose, &body, &id));
    CHECK(id.slot == 0);
    CHECK_OK(firma_body_shape_release(ball));
    return game;
}

static void cut_floor(firma_game game) {
    firma_cutter crater = {0};
    firma_command command = {0};
    const firma_pose pose = {{6, 6, 0}, {0, 0, 0, 1}, 0.5};
    uint32_t status = 77;
    CHECK_OK(firma_cutter_crater(FIRMA_WEDGE, 4, &crater));
    CHECK_OK(firma_command_edit(1, crater, &pose, NULL, &command));
    CHECK_OK(firma_game_edit(game, command, &status));
    CHECK(status == FIRMA_CARVE_DONE);
    CHECK_OK(firma_command_release(command));
    CHECK_OK(firma_cutter_release(crater));
}

void fight(firma_game game, uint64_t from, uint64_t to) {
    const double column[3] = {3.5, 2.9, 3.25}, muzzle[3] = {6, 6, 2}, way[3] = {-30, -12, 4}, lob[3] = {-3, 1, 2};
    firma_player_wish wish = {.size = sizeof wish, .velocity = {1, -1, 0}, .jump = 1};
    firma_charge charge;
    firma_charge_defaults(&charge);
    charge.crater = 1.6;
    for (uint64_t tick = from; tick < to; ++tick) {
        if (tick == 2) CHECK_OK(firma_game_set_off(game, 0));
        if (tick == 5) CHECK_OK(firma_game_fire(game, 1, muzzle, way));
        if (tick == 8) CHECK_OK(firma_game_explode(game, column, &charge));
        if (tick == 20) CHECK_OK(firma_game_wish(game, 0, &wish));
        if (tick == 20) CHECK_OK(firma_game_fire(game, 2, muzzle, lob));
        if (tick == 50) cut_floor(game);
        CHECK_OK(firma_game_step(game));
    }
}

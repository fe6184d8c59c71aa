/* SPDX-License-Identifier: MIT */
/* Parts that move and players: casts of scenes, walking, riding, being pushed; bad arguments. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

/* A solid box around the origin: faces look outward. */
static firma_world make_slab(double x, double y, double z) {
    const double positions[] = {-x, -y, -z, x, -y, -z, x, y, -z, -x, y, -z, -x, -y, z, x, -y, z, x, y, z, -x, y, z};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8};
    mesh.corners = corners;
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_world world = {0};
    CHECK_OK(firma_world_from_mesh(&mesh, "slab", NULL, &world));
    return world;
}

static firma_part part_of(firma_world world, double x, double y, double z) {
    firma_part part;
    firma_part_defaults(&part);
    part.world = world;
    part.motion.position[0] = x;
    part.motion.position[1] = y;
    part.motion.position[2] = z;
    return part;
}

static firma_scene scene_of(firma_world world, firma_parts parts) {
    firma_scene scene;
    firma_scene_defaults(&scene);
    scene.world = world;
    scene.parts = parts;
    return scene;
}

static void test_parts(firma_world room) {
    const firma_world slab = make_slab(1, 1, 0.25);
    firma_parts parts = {0};
    CHECK_OK(firma_parts_create(&parts));
    firma_part lift = part_of(slab, 4, 4, 0.25);
    uint32_t index = 9;
    CHECK_OK(firma_parts_add(parts, &lift, &index));
    CHECK(index == 0);
    CHECK_OK(firma_parts_add(parts, &lift, NULL));
    size_t count = 0;
    CHECK_OK(firma_parts_get_count(parts, &count));
    CHECK(count == 2);

    /* The first comes up by a metre while a ball comes down by one: they meet half way. */
    firma_motion motions[2] = {lift.motion, lift.motion};
    motions[0].path[2] = 1;
    motions[1].position[0] = 1.5;
    CHECK_OK(firma_parts_set_motions(parts, motions, 2));
    firma_scene scene = scene_of(room, parts);
    const firma_mover ball = {.size = sizeof ball, .at = {4, 4, 2}, .radius = 0.5};
    const double down[3] = {0, 0, -1}, none[3] = {0, 0, 0};
    firma_part_hit hit;
    CHECK_OK(firma_cast_scene(&scene, &ball, down, NULL, &hit));
    CHECK(hit.part == 0 && hit.hit.status == FIRMA_HIT && hit.hit.fraction == 0.5 && hit.hit.centre[2] == 1.5);
    CHECK(hit.surface_velocity[2] == 1 && hit.hit.normal[2] == 1);
    /* Over the first half of the motion it comes just so far; what stands is met by what comes. */
    scene.to = 0.5;
    CHECK_OK(firma_cast_scene(&scene, &ball, none, NULL, &hit));
    CHECK(hit.part == FIRMA_NO_PART && hit.hit.status == FIRMA_MISS);
    uint32_t status = 9;
    CHECK_OK(firma_cast_scene_any(&scene, &ball, down, NULL, &status));
    CHECK(status == FIRMA_HIT);
    CHECK_OK(firma_cast_scene_any(&scene, &ball, none, NULL, &status));
    CHECK(status == FIRMA_MISS);
    scene.to = 1;
    /* Capsules and hulls, too. */
    const double half[3] = {0.5, 0.5, 0.5};
    firma_hull box = {0};
    CHECK_OK(firma_hull_box(half, NULL, &box));
    const firma_mover crate = {.size = sizeof crate, .kind = FIRMA_MOVER_HULL, .at = {4, 4, 2}, .hull = box};
    const firma_mover pill = {
        .size = sizeof pill, .kind = FIRMA_MOVER_CAPSULE, .at = {4, 4, 2}, .to = {4, 4, 3}, .radius = 0.5};
    CHECK_OK(firma_cast_scene(&scene, &crate, down, NULL, &hit));
    CHECK(hit.part == 0 && hit.hit.fraction == 0.5);
    CHECK_OK(firma_cast_scene(&scene, &pill, down, NULL, &hit));
    CHECK(hit.part == 0 && hit.hit.fraction == 0.5);
    /* The level is still there. */
    const double aside[3] = {4, 0, 0};
    CHECK_OK(firma_cast_scene(&scene, &ball, aside, NULL, &hit));
    CHECK(hit.part == FIRMA_NO_PART && hit.hit.fraction == 0.875 && hit.surface_velocity[2] == 0);
    /* A mask that the part does not share. */
    lift.mask = 2;
    CHECK_OK(firma_parts_set(parts, 0, &lift));
    CHECK_OK(firma_parts_set_motions(parts, motions, 2));
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.mask = 1;
    CHECK_OK(firma_cast_scene(&scene, &ball, down, &options, &hit));
    CHECK(hit.hit.status == FIRMA_MISS);

    /* Overlaps at the end of the motion: the top of the lift is at 1.5 then. */
    firma_part_near near[8];
    CHECK_OK(firma_overlap_scene(&scene, &ball, 1, NULL, near, 8, &count));
    CHECK(count == 1 && near[0].part == 0 && near[0].near.direction[2] == 1 && near[0].surface_velocity[2] == 1);
    CHECK_OK(firma_overlap_scene(&scene, &ball, 0.5, NULL, NULL, 0, &count));
    CHECK(count == 0);

    /* Bad ones. */
    CHECK_FAILS(firma_overlap_scene(&scene, &ball, 2, NULL, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "0..1");
    CHECK_FAILS(firma_overlap_scene(&scene, &ball, NAN, NULL, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "0..1");
    CHECK_FAILS(firma_overlap_scene(&scene, &ball, 0, NULL, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_scene(NULL, &ball, down, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_scene(&scene, &ball, down, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_scene_any(&scene, NULL, down, NULL, &status), FIRMA_ERROR_BAD_CALL, "null");
    const double nowhere[3] = {0, NAN, 0};
    CHECK_OK(firma_cast_scene(&scene, &ball, nowhere, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_INVALID);
    scene.from = 2;
    CHECK_OK(firma_cast_scene(&scene, &ball, down, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_INVALID);
    scene.from = 0;
    scene.reserved = 1;
    CHECK_FAILS(firma_cast_scene(&scene, &ball, down, NULL, &hit), FIRMA_ERROR_INVALID, "reserved");
    scene.reserved = 0;
    scene.size = 4;
    CHECK_FAILS(firma_cast_scene(&scene, &ball, down, NULL, &hit), FIRMA_ERROR_BAD_CALL, "size");
    /* A shorter one has the whole stretch. */
    scene.size = offsetof(firma_scene, from);
    scene.from = scene.to = NAN;
    CHECK_OK(firma_cast_scene(&scene, &ball, down, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_HIT && hit.hit.fraction == 0.5);

    CHECK_FAILS(firma_parts_set_motions(parts, motions, 1), FIRMA_ERROR_INVALID, "1 motions for 2 parts");
    CHECK_FAILS(firma_parts_set_motions(parts, NULL, 2), FIRMA_ERROR_BAD_CALL, "null");
    motions[0].path[2] = 0.25;
    motions[1].turn[1] = NAN;
    CHECK_FAILS(firma_parts_set_motions(parts, motions, 2), FIRMA_ERROR_OUT_OF_RANGE, "part 1");
    CHECK_OK(firma_cast_scene(&scene, &ball, down, NULL, &hit));
    CHECK(hit.hit.fraction == 0.5); /* the first has its motion yet */
    motions[1].turn[1] = 8.5;
    CHECK_FAILS(firma_parts_set_motions(parts, motions, 2), FIRMA_ERROR_OUT_OF_RANGE, "turns");
    lift.motion.rotation[3] = 0;
    CHECK_FAILS(firma_parts_add(parts, &lift, NULL), FIRMA_ERROR_OUT_OF_RANGE, "rotation");
    lift.size = 0;
    CHECK_FAILS(firma_parts_add(parts, &lift, NULL), FIRMA_ERROR_BAD_CALL, "size");
    firma_part nothing;
    firma_part_defaults(&nothing);
    CHECK_FAILS(firma_parts_add(parts, &nothing, NULL), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK_FAILS(firma_parts_add(parts, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_parts_set(parts, 2, &lift), FIRMA_ERROR_OUT_OF_RANGE, "no part 2");
    CHECK_OK(firma_parts_get_count(parts, &count));
    CHECK(count == 2);
    CHECK_FAILS(firma_parts_get_count(parts, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_parts_create(NULL), FIRMA_ERROR_BAD_CALL, "null");

    /* The parts hold their worlds. */
    CHECK_OK(firma_world_release(slab));
    CHECK_OK(firma_cast_scene(&scene, &ball, down, NULL, &hit));
    CHECK(hit.part == 0);
    CHECK_OK(firma_parts_release(parts));
    CHECK_FAILS(firma_cast_scene(&scene, &ball, down, NULL, &hit), FIRMA_ERROR_BAD_HANDLE, "list of parts");
    CHECK_FAILS(firma_parts_add(parts, &lift, NULL), FIRMA_ERROR_BAD_HANDLE, "list of parts");
    CHECK_FAILS(firma_parts_release(parts), FIRMA_ERROR_BAD_HANDLE, "list of parts");
    CHECK_OK(firma_hull_release(box));
}

static void test_shapes(void) {
    firma_player_size size;
    firma_player_size_defaults(&size);
    CHECK(size.size == sizeof size && size.radius == 0.3 && size.height == 1.8 && size.crouched_height == 1.1);
    CHECK(size.up[2] == 1 && size.up[0] == 0);
    firma_player_shape shape = {0};
    size.radius = NAN;
    CHECK_FAILS(firma_player_shape_capsule(&size, &shape), FIRMA_ERROR_INVALID, "radius");
    size.radius = 1;
    CHECK_FAILS(firma_player_shape_capsule(&size, &shape), FIRMA_ERROR_INVALID, "");
    CHECK_OK(firma_player_shape_box(&size, &shape));
    CHECK_OK(firma_player_shape_release(shape));
    CHECK_FAILS(firma_player_shape_release(shape), FIRMA_ERROR_BAD_HANDLE, "player shape");
    shape.id = 0;
    size.reserved = 1;
    CHECK_FAILS(firma_player_shape_box(&size, &shape), FIRMA_ERROR_INVALID, "reserved");
    size.size = 4;
    CHECK_FAILS(firma_player_shape_box(&size, &shape), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_player_shape_capsule(NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    const double spheres[8] = {0, 0, 0.3, 0.3, 0, 0, 0.9, NAN};
    CHECK_FAILS(firma_player_shape_spheres(spheres, 2, NULL, 0, NULL, &shape), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_player_shape_spheres(spheres, 0, NULL, 0, NULL, &shape), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_player_shape_spheres(NULL, 1, NULL, 0, NULL, &shape), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_player_shape_spheres(spheres, 1, NULL, 1, NULL, &shape), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(shape.id == 0);
    CHECK_OK(firma_player_shape_spheres(spheres, 1, NULL, 0, NULL, &shape));
    CHECK_OK(firma_player_shape_release(shape));
}

static firma_player tick(const firma_scene* scene, firma_player_shape shape, firma_player player,
                         const firma_player_wish* wish, int ticks, firma_player_move* move) {
    move->size = sizeof *move;
    move->player = player;
    for (int k = 0; k < ticks; ++k)
        CHECK_OK(firma_move_player(scene, shape, &move->player, wish, 1.0 / 64, NULL, move));
    return move->player;
}

static void test_walk(firma_world room, firma_player_shape shape) {
    const firma_scene scene = scene_of(room, (firma_parts){0});
    firma_player player;
    firma_player_defaults(&player);
    CHECK(player.mask == UINT32_MAX && player.ground_part == FIRMA_NO_PART && player.room == FIRMA_NO_ROOM);
    player.position[0] = player.position[1] = 4;
    player.position[2] = 0.5;
    firma_player_wish wish = {.size = sizeof wish};
    firma_player_move move;
    player = tick(&scene, shape, player, &wish, 1, &move);
    CHECK(!player.on_ground && player.velocity[2] < 0 && move.contact_count == 0 && player.world_hash == hash_of(room));
    player = tick(&scene, shape, player, &wish, 64, &move);
    CHECK(player.on_ground == 1 && player.position[2] > 0 && player.position[2] < 0.01);
    CHECK(player.ground_normal[2] == 1 && move.contact_count == 1 && move.crushed_by == FIRMA_NO_PART);
    CHECK(move.contacts[0].kind == FIRMA_CONTACT_GROUND && move.contacts[0].face == 0);
    CHECK(move.contacts[0].part == FIRMA_NO_PART && move.contacts[0].portal == FIRMA_NO_PORTAL);

    wish.velocity[0] = 4;
    player = tick(&scene, shape, player, &wish, 128, &move);
    CHECK(player.position[0] > 7.68 && player.position[0] < 7.7 && player.position[1] == 4);
    int walls = 0;
    for (uint32_t k = 0; k < move.contact_count; ++k)
        if (move.contacts[k].kind == FIRMA_CONTACT_WALL && move.contacts[k].normal[0] == -1) ++walls;
    CHECK(walls == 1);
    wish.velocity[0] = 0;
    wish.jump = 1;
    player = tick(&scene, shape, player, &wish, 1, &move);
    CHECK(move.jumped == 1 && player.velocity[2] > 4 && !player.on_ground);
    wish.jump = 0;
    double landed = 0;
    for (int k = 0; k < 100; ++k) {
        player = tick(&scene, shape, player, &wish, 1, &move);
        if (move.landed_speed > landed) landed = move.landed_speed;
    }
    CHECK(landed > 4 && landed < 5 && player.on_ground);
    wish.crouch = 1;
    player = tick(&scene, shape, player, &wish, 1, &move);
    CHECK(player.crouched == 1);

    /* A copy goes the same way, to the bit. */
    firma_player_move first, second;
    memset(&first, 0, sizeof first);
    memset(&second, 0, sizeof second);
    wish = (firma_player_wish){.size = sizeof wish, .velocity = {-3, 1, 0}};
    tick(&scene, shape, player, &wish, 30, &first);
    tick(&scene, shape, player, &wish, 30, &second);
    CHECK(memcmp(&first, &second, sizeof first) == 0 && first.player.position[0] < 7);

    uint32_t fits = 9;
    const double middle[3] = {4, 4, 1}, in_wall[3] = {0.1, 4, 1}, high[3] = {4, 4, 2.5};
    CHECK_OK(firma_player_fits(&scene, shape, middle, 0, UINT32_MAX, &fits));
    CHECK(fits == 1);
    CHECK_OK(firma_player_fits(&scene, shape, in_wall, 0, UINT32_MAX, &fits));
    CHECK(fits == 0);
    CHECK_OK(firma_player_fits(&scene, shape, high, 0, UINT32_MAX, &fits));
    CHECK(fits == 0);
    CHECK_OK(firma_player_fits(&scene, shape, high, 1, UINT32_MAX, &fits));
    CHECK(fits == 1);
}

static void test_ride(firma_world room, firma_player_shape shape) {
    const firma_world slab = make_slab(1, 1, 0.25);
    firma_parts parts = {0};
    CHECK_OK(firma_parts_create(&parts));
    const firma_part lift = part_of(slab, 4, 4, 0.25);
    CHECK_OK(firma_parts_add(parts, &lift, NULL));
    const firma_scene scene = scene_of(room, parts);
    firma_player player;
    firma_player_defaults(&player);
    player.position[0] = player.position[1] = 4;
    player.position[2] = 0.6;
    const firma_player_wish wish = {.size = sizeof wish};
    firma_player_move move;
    player = tick(&scene, shape, player, &wish, 32, &move);
    CHECK(player.on_ground && player.ground_part == 0 && move.contacts[0].part == 0);
    uint32_t crushed = FIRMA_NO_PART;
    double carried = 0;
    firma_motion motion = lift.motion;
    motion.path[2] = 1.0 / 64;
    for (int k = 0; k < 64; ++k) {
        CHECK_OK(firma_parts_set_motions(parts, &motion, 1));
        player = tick(&scene, shape, player, &wish, 1, &move);
        carried += move.carried[2];
        motion.position[2] += motion.path[2];
    }
    CHECK(fabs(player.position[2] - 1.5) < 0.01 && fabs(carried - 1) < 0.02 && player.ground_part == 0);
    CHECK(fabs(player.ground_velocity[2] - 1) < 1e-9 && move.crushed_by == FIRMA_NO_PART);
    /* On against the ceiling. */
    for (int k = 0; k < 64 && crushed == FIRMA_NO_PART; ++k) {
        CHECK_OK(firma_parts_set_motions(parts, &motion, 1));
        player = tick(&scene, shape, player, &wish, 1, &move);
        crushed = move.crushed_by;
        motion.position[2] += motion.path[2];
    }
    CHECK(crushed == 0 && player.position[2] < 2.3);
    CHECK_OK(firma_parts_release(parts));
    CHECK_OK(firma_world_release(slab));
}

static void test_bad_moves(firma_world room, firma_player_shape shape) {
    firma_scene scene = scene_of(room, (firma_parts){0});
    firma_player player;
    firma_player_defaults(&player);
    player.position[0] = player.position[1] = player.position[2] = 2;
    firma_player_wish wish = {.size = sizeof wish};
    firma_player_rules rules;
    firma_player_rules_defaults(&rules);
    CHECK(rules.size == sizeof rules && rules.gravity == 9.81 && rules.step_height == 0.45 && rules.max_push == 4);
    CHECK(rules.jump_speed == 4.4 && rules.crouched_speed == 0.5 && rules.contact_offset == 0);
    firma_player_move move = {.size = sizeof move, .landed_speed = 77};
    const double step = 1.0 / 64;
    CHECK_FAILS(firma_move_player(NULL, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_move_player(&scene, shape, NULL, &wish, step, NULL, &move), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_move_player(&scene, shape, &player, NULL, step, NULL, &move), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    const double bad[] = {NAN, INFINITY, -1, 1.5};
    for (int k = 0; k < 4; ++k)
        CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, bad[k], NULL, &move), FIRMA_ERROR_OUT_OF_RANGE,
                    "seconds");
    rules.gravity = -1;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, &rules, &move), FIRMA_ERROR_OUT_OF_RANGE,
                "rules");
    rules.reserved = 1;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, &rules, &move), FIRMA_ERROR_INVALID, "reserved");
    rules.size = 12;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, &rules, &move), FIRMA_ERROR_BAD_CALL, "size");
    wish.velocity[1] = NAN;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_OUT_OF_RANGE, "wish");
    wish.velocity[1] = 0;
    wish.jump = 2;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_INVALID, "0 or 1");
    wish.jump = 0;
    wish.size = 4;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_BAD_CALL, "size");
    wish.size = sizeof wish;
    firma_player broken = player;
    broken.position[2] = NAN;
    CHECK_FAILS(firma_move_player(&scene, shape, &broken, &wish, step, NULL, &move), FIRMA_ERROR_OUT_OF_RANGE,
                "player");
    broken = player;
    broken.ground_velocity[0] = INFINITY;
    CHECK_FAILS(firma_move_player(&scene, shape, &broken, &wish, step, NULL, &move), FIRMA_ERROR_OUT_OF_RANGE,
                "ground");
    broken = player;
    broken.crouched = 7;
    CHECK_FAILS(firma_move_player(&scene, shape, &broken, &wish, step, NULL, &move), FIRMA_ERROR_INVALID, "0 or 1");
    scene.to = NAN;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_OUT_OF_RANGE, "0..1");
    scene.to = 1;
    scene.world.id = 0;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_BAD_HANDLE, "world");
    scene.world = room;
    CHECK_FAILS(firma_move_player(&scene, (firma_player_shape){room.id}, &player, &wish, step, NULL, &move),
                FIRMA_ERROR_BAD_HANDLE, "player shape");
    CHECK(move.landed_speed == 77); /* nothing was written */
    move.size = 4;
    CHECK_FAILS(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move), FIRMA_ERROR_BAD_CALL, "size");
    /* A shorter one gets the player, and no more. */
    move.size = offsetof(firma_player_move, pushed);
    CHECK_OK(firma_move_player(&scene, shape, &player, &wish, step, NULL, &move));
    CHECK(move.landed_speed == 77 && move.player.velocity[2] < 0 && move.player.world_hash == hash_of(room));

    uint32_t fits = 9;
    const double nowhere[3] = {0, NAN, 0};
    CHECK_FAILS(firma_player_fits(&scene, shape, nowhere, 0, 1, &fits), FIRMA_ERROR_OUT_OF_RANGE, "position");
    CHECK_FAILS(firma_player_fits(&scene, shape, player.position, 2, 1, &fits), FIRMA_ERROR_INVALID, "0 or 1");
    CHECK_FAILS(firma_player_fits(&scene, shape, NULL, 0, 1, &fits), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_player_fits(&scene, (firma_player_shape){0}, player.position, 0, 1, &fits),
                FIRMA_ERROR_BAD_HANDLE, "player shape");
    CHECK(fits == 9);
}

void test_players(void) {
    const size_t before = firma_live_handles();
    const firma_world room = make_room();
    test_parts(room);
    test_shapes();
    const double spheres[] = {0, 0, 0.3, 0.3, 0, 0, 0.9, 0.3, 0, 0, 1.5, 0.3};
    firma_player_shape shapes[3] = {{0}, {0}, {0}};
    CHECK_OK(firma_player_shape_capsule(NULL, &shapes[0]));
    CHECK_OK(firma_player_shape_box(NULL, &shapes[1]));
    CHECK_OK(firma_player_shape_spheres(spheres, 3, spheres, 2, NULL, &shapes[2]));
    for (int k = 0; k < 3; ++k) {
        test_walk(room, shapes[k]);
        test_ride(room, shapes[k]);
    }
    test_bad_moves(room, shapes[0]);
    for (int k = 0; k < 3; ++k) CHECK_OK(firma_player_shape_release(shapes[k]));
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}

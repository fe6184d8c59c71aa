/* SPDX-License-Identifier: MIT */
/* Projectiles: free flight, ricochets, through a slab, at a body; events; bad arguments. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

static firma_projectile shot(double x, double y, double z, double vx, double vy, double vz) {
    firma_projectile made;
    firma_projectile_defaults(&made);
    const double position[3] = {x, y, z}, velocity[3] = {vx, vy, vz};
    memcpy(made.position, position, sizeof position);
    memcpy(made.velocity, velocity, sizeof velocity);
    return made;
}

static firma_shot_view view_of(firma_shot_events events) {
    firma_shot_view view = {.size = sizeof view};
    CHECK_OK(firma_shot_events_get_view(events, &view));
    return view;
}

static uint64_t hash_of_shots(const firma_projectile* shots, size_t count) {
    uint64_t hash = 0;
    CHECK_OK(firma_projectiles_hash(shots, count, &hash));
    return hash;
}

static void test_flight(firma_world room, firma_shot_events events) {
    firma_projectile shots[3] = {shot(1, 4, 3, 8, 0, 0), shot(4, 4, 2, 0, 0, -100), shot(1, 1, 1.5, 50, 0, -2)};
    CHECK(shots[0].mass == 0.01 && shots[0].mask == UINT32_MAX && shots[0].state == FIRMA_PROJECTILE_FLYING);
    shots[2].user = 42;
    firma_projectile same[3];
    memcpy(same, shots, sizeof same);
    firma_fly_report report = {.size = sizeof report};
    const firma_bodies nobody = {0};
    CHECK_OK(firma_fly(shots, 3, room, nobody, 0.125, NULL, events, &report));
    /* On the parabola. */
    CHECK(fabs(shots[0].position[0] - 2) < 1e-9 && fabs(shots[0].position[2] - (3 - 9.81 / 128)) < 1e-9);
    CHECK(fabs(shots[0].velocity[2] + 9.81 / 8) < 1e-9 && shots[0].age == 0.125 &&
          shots[0].world_hash == hash_of(room));
    /* Stopped at the floor, which it met head on. */
    CHECK(shots[1].state == FIRMA_PROJECTILE_STOPPED && shots[1].velocity[2] == 0 && shots[2].user == 42);
    CHECK(report.flying == 2 && report.impacts == 1 && report.chords > 0);
    firma_shot_view view = view_of(events);
    CHECK(view.event_count == 1 && view.length_count == 0);
    CHECK(view.events[0].kind == FIRMA_SHOT_STOPPED && view.events[0].projectile == 1 && view.events[0].face == 0);
    CHECK(view.events[0].normal[2] == 1 && view.events[0].body.slot == FIRMA_NO_BODY);
    CHECK(view.events[0].portal == FIRMA_NO_PORTAL && fabs(view.events[0].point[2]) < 1e-9);
    CHECK(fabs(view.events[0].time - 0.02) < 1e-3 && fabs(view.events[0].impulse[2] + 1) < 0.01);
    CHECK(fabs(view.events[0].energy - 50) < 0.5);

    /* A copy goes the same way, to the bit, with and without events. */
    CHECK(hash_of_shots(shots, 3) != hash_of_shots(same, 3));
    CHECK_OK(firma_fly(same, 3, room, nobody, 0.125, NULL, (firma_shot_events){0}, NULL));
    CHECK(memcmp(shots, same, sizeof same) == 0 && hash_of_shots(shots, 3) == hash_of_shots(same, 3));
    CHECK(view_of(events).event_count == 1); /* of the step before */

    /* Flat on the floor: it ricochets, with 0.4 of the speed along the normal. */
    firma_projectile flat = shot(1, 1, 0.1, 50, 0, -2);
    CHECK_OK(firma_fly(&flat, 1, room, nobody, 0.0625, NULL, events, &report));
    view = view_of(events);
    CHECK(view.event_count == 1 && view.events[0].kind == FIRMA_SHOT_RICOCHET && flat.velocity[0] < 50);
    CHECK(fabs(view.events[0].velocity[2] - 0.4 * sqrt(4 + 2 * 9.81 * 0.1)) < 0.01 && report.flying == 1);
}

/* A rule of the game's own, and what it was asked. */
struct asked {
    double resistance; /* of all that is no body; below 0 it is out of range */
    int times, bodies;
    firma_shot_impact first;
    firma_shot_terms given;
};

static void by_rule(const firma_shot_impact* impact, uint32_t matter, firma_shot_terms* terms, void* user) {
    struct asked* const asked = user;
    if (asked->times++ == 0) asked->first = *impact, asked->given = *terms;
    asked->bodies += impact->body.slot != FIRMA_NO_BODY && matter == 0;
    terms->resistance = asked->resistance;
}

/* As by a table that says the same; what it is asked with; out of range the projectile stops. */
static void test_rule(firma_world walled, firma_shot_events events, const firma_projectile* by_table) {
    struct asked asked = {.resistance = 100};
    firma_fly_options options;
    firma_fly_options_defaults(&options);
    options.gravity[2] = 0;
    options.rule = by_rule;
    options.user = &asked;
    firma_projectile ruled = shot(2, 4, 2, 200, 0, 0);
    CHECK_OK(firma_fly(&ruled, 1, walled, (firma_bodies){0}, 1.0 / 64, &options, events, NULL));
    CHECK(memcmp(&ruled, by_table, sizeof ruled) == 0);
    /* Once for the face, once for the matter behind it. */
    CHECK(asked.times == 2 && asked.bodies == 0 && asked.given.friction == 0.3 && asked.given.resistance > 1e60);
    CHECK(fabs(asked.first.point[0] - 4) < 1e-9 && asked.first.normal[0] == -1 && asked.first.velocity[0] == 200);
    CHECK(asked.first.mass == 0.01 && asked.first.projectile == 0 && asked.first.face != FIRMA_NO_FACE);
    CHECK(asked.first.portal == FIRMA_NO_PORTAL && asked.first.body.slot == FIRMA_NO_BODY && !asked.first.pane);
    CHECK(asked.first.part == FIRMA_NO_PART && asked.first.surface[0] == 0);
    /* A caller that was compiled before there were rules has none. */
    options.other.resistance = 100;
    options.size = offsetof(firma_fly_options, rule);
    firma_projectile older = shot(2, 4, 2, 200, 0, 0);
    CHECK_OK(firma_fly(&older, 1, walled, (firma_bodies){0}, 1.0 / 64, &options, events, NULL));
    CHECK(asked.times == 2 && memcmp(&older, by_table, sizeof older) == 0);
    options.size = sizeof options;
    asked.resistance = -1;
    firma_projectile stopped = shot(2, 4, 2, 200, 0, 0);
    CHECK_OK(firma_fly(&stopped, 1, walled, (firma_bodies){0}, 1.0 / 64, &options, events, NULL));
    CHECK(stopped.state == FIRMA_PROJECTILE_STOPPED && fabs(stopped.position[0] - 4) < 1e-4);
}

/* A slab of 0.5 m in the way: what it takes is its resistance times its thickness. */
static void test_slab(firma_world room, firma_shot_events events) {
    const firma_cutter slab = make_box(4, -1, -1, 4.5, 9, 5);
    const firma_pose here = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    firma_carve_report report = {.size = sizeof report};
    firma_world walled = {0};
    CHECK_OK(firma_carve(room, slab, &here, &fill, &walled, &report));
    firma_shot_terms soft;
    firma_shot_terms_defaults(&soft);
    CHECK(soft.ricochet_below == 0.25 && soft.restitution == 0.4 && soft.friction == 0.3 && soft.resistance > 1e60);
    soft.resistance = 100;
    firma_fly_options options;
    firma_fly_options_defaults(&options);
    CHECK(options.max_impacts == 8 && options.max_age == 10 && options.max_bow == 0.001 && options.stop_speed == 1);
    CHECK(options.gravity[2] == -9.81 && options.max_thickness == 4 && options.other.friction == 0.3);
    options.gravity[2] = 0;
    options.other = soft;
    firma_projectile fast = shot(2, 4, 2, 200, 0, 0);
    CHECK_OK(firma_fly(&fast, 1, walled, (firma_bodies){0}, 1.0 / 64, &options, events, NULL));
    firma_shot_view view = view_of(events);
    CHECK(view.event_count == 2 && view.events[0].kind == FIRMA_SHOT_ENTERED && view.events[1].kind == FIRMA_SHOT_LEFT);
    CHECK(view.events[1].number == 1 && fabs(view.events[1].thickness - 0.5) < 1e-6 && view.length_count == 1);
    CHECK(view.events[1].first_length == 0 && view.events[1].length_count == 1 && view.lengths[0].to == 1);
    /* 200 J at the start, 50 J less behind it. */
    CHECK(fabs(fast.velocity[0] - sqrt(2 * 150 / 0.01)) < 1e-3 && fast.position[0] > 4.5);
    /* The same by a table of one matter. */
    firma_projectile again = shot(2, 4, 2, 200, 0, 0);
    firma_shot_terms table[64];
    for (int k = 0; k < 64; ++k) table[k] = soft;
    firma_shot_terms_defaults(&options.other);
    options.matters = table;
    options.matter_count = 64;
    CHECK_OK(firma_fly(&again, 1, walled, (firma_bodies){0}, 1.0 / 64, &options, events, NULL));
    CHECK(memcmp(&again, &fast, sizeof fast) == 0);
    test_rule(walled, events, &fast);
    CHECK_OK(firma_world_release(walled));
    CHECK_OK(firma_cutter_release(slab));
}

static void test_body(firma_world room, firma_shot_events events) {
    firma_bodies bodies = {0};
    firma_body_shape ball = {0};
    firma_mass mass;
    firma_body_id id;
    const double sphere[4] = {0, 0, 0, 0.5};
    const firma_pose pose = {{4, 4, 2}, {0, 0, 0, 1}, 1};
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_mass_of_ball(0.5, 100, &mass));
    CHECK_OK(firma_body_shape_spheres(sphere, 1, &mass, &ball));
    CHECK_OK(firma_bodies_add(bodies, ball, &pose, &id));
    firma_fly_options options;
    firma_fly_options_defaults(&options);
    options.gravity[2] = 0;
    firma_projectile bullet = shot(1, 4, 2, 400, 0, 0);
    CHECK_OK(firma_fly(&bullet, 1, room, bodies, 1.0 / 64, &options, events, NULL));
    const firma_shot_view view = view_of(events);
    CHECK(view.event_count == 1 && view.events[0].kind == FIRMA_SHOT_STOPPED && view.events[0].face == FIRMA_NO_FACE);
    CHECK(view.events[0].body.slot == id.slot && view.events[0].body.use == id.use);
    firma_body body = {.size = sizeof body};
    CHECK_OK(firma_bodies_get(bodies, id, &body));
    CHECK(fabs(body.velocity[0] * body.mass - 4) < 1e-9);
    /* By a rule: it is asked with the terms of bodies. */
    struct asked asked = {.resistance = 0};
    options.bodies.friction = 0.125;
    options.rule = by_rule;
    options.user = &asked;
    bullet = shot(1, 4, 2, 400, 0, 0);
    CHECK_OK(firma_fly(&bullet, 1, room, bodies, 1.0 / 64, &options, events, NULL));
    CHECK(asked.times == 1 && asked.bodies == 1 && asked.given.friction == 0.125);
    CHECK(asked.first.body.slot == id.slot && asked.first.body.use == id.use && asked.first.face == FIRMA_NO_FACE);
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_body_shape_release(ball));
    CHECK_FAILS(firma_fly(&bullet, 1, room, bodies, 1.0 / 64, NULL, events, NULL), FIRMA_ERROR_BAD_HANDLE, "bodies");
}

/* A wall of 0.5 m that comes at 20 m/s and goes up at 60: what hits it sees that, what stays in it goes along. */
static void test_parts(firma_world room, firma_shot_events events) {
    const double positions[] = {0, -1, -1, 0.5, -1, -1, 0.5, 1, -1, 0, 1, -1, 0, -1, 1, 0.5, -1, 1, 0.5, 1, 1, 0, 1, 1};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8, .corners = corners};
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    const double step = 1.0 / 64;
    firma_part wall;
    firma_part_defaults(&wall);
    CHECK_OK(firma_world_from_mesh(&mesh, "wall", NULL, &wall.world));
    const double position[3] = {4, 4, 1.5};
    memcpy(wall.motion.position, position, sizeof position);
    wall.motion.path[0] = -20 * step;
    wall.motion.path[2] = 60 * step;
    firma_scene scene;
    firma_scene_defaults(&scene);
    scene.world = room;
    CHECK_OK(firma_parts_create(&scene.parts));
    CHECK_OK(firma_parts_add(scene.parts, &wall, NULL));
    firma_fly_options options;
    firma_fly_options_defaults(&options);
    options.gravity[2] = 0;
    options.other.resistance = 1000;
    const firma_bodies nobody = {0};
    firma_projectile stays = shot(2, 4, 2, 220, 0, 0); /* the wall sees (240, 0, -60): 306 J */
    firma_fly_report report = {.size = sizeof report};
    CHECK_OK(firma_fly_scene(&stays, 1, &scene, nobody, step, &options, events, &report));
    firma_shot_view view = view_of(events);
    CHECK(view.event_count == 2 && view.events[1].kind == FIRMA_SHOT_STOPPED && view.events[1].part == 0);
    CHECK(fabs(view.events[1].time - 2 / 240.0) < 1e-9 && fabs(view.events[1].energy - 306) < 1e-6);
    CHECK(fabs(view.events[1].thickness - 0.306) < 1e-9 && report.impacts == 1);
    CHECK(fabs(view.events[1].in_part[0] - 0.306 * 240 / hypot(240, 60)) < 1e-9);
    CHECK(stays.state == FIRMA_PROJECTILE_STOPPED && fabs(stays.velocity[0] + 20) < 1e-9);
    for (int axis = 0; axis < 3; ++axis) {
        const double end = wall.motion.position[axis] + wall.motion.path[axis];
        CHECK(fabs(stays.position[axis] - end - view.events[1].in_part[axis]) < 1e-9);
    }
    /* Without parts as firma_fly(), to the bit. */
    firma_scene level;
    firma_scene_defaults(&level);
    level.world = room;
    firma_projectile one = shot(2, 4, 1, 150, 0, -90), other = one;
    CHECK_OK(firma_fly_scene(&one, 1, &level, nobody, step, NULL, events, NULL));
    CHECK(view_of(events).event_count > 0 && view_of(events).events[0].part == FIRMA_NO_PART);
    CHECK_OK(firma_fly(&other, 1, room, nobody, step, NULL, events, NULL));
    CHECK(memcmp(&one, &other, sizeof one) == 0);
    scene.to = 2;
    CHECK_FAILS(firma_fly_scene(&one, 1, &scene, nobody, step, NULL, events, NULL), FIRMA_ERROR_OUT_OF_RANGE,
                "stretch");
    scene.to = 1;
    wall.motion.path[1] = 1e30;
    CHECK_OK(firma_parts_set_motions(scene.parts, &wall.motion, 1));
    CHECK_FAILS(firma_fly_scene(&one, 1, &scene, nobody, step, NULL, events, NULL), FIRMA_ERROR_INVALID, "part 0");
    CHECK_FAILS(firma_fly_scene(&one, 1, NULL, nobody, step, NULL, events, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_fly_scene(&one, 1, &level, nobody, 0, NULL, events, NULL), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    CHECK_OK(firma_parts_release(scene.parts));
    CHECK_FAILS(firma_fly_scene(&one, 1, &scene, nobody, step, NULL, events, NULL), FIRMA_ERROR_BAD_HANDLE, "parts");
    CHECK(memcmp(&one, &other, sizeof one) == 0);
    CHECK_OK(firma_world_release(wall.world));
}

static void test_bad(firma_world room, firma_shot_events events) {
    const firma_bodies nobody = {0};
    const double step = 1.0 / 64;
    firma_projectile shots[2] = {shot(1, 4, 3, 8, 0, 0), shot(4, 4, 2, 0, 0, NAN)};
    firma_projectile before[2];
    memcpy(before, shots, sizeof before);
    const size_t held = view_of(events).event_count;
    CHECK_FAILS(firma_fly(shots, 2, room, nobody, step, NULL, events, NULL), FIRMA_ERROR_OUT_OF_RANGE, "1");
    CHECK(memcmp(before, shots, sizeof before) == 0 && view_of(events).event_count == held && held == 1);
    const double seconds[] = {0, -1, 1.5, NAN, INFINITY};
    for (int k = 0; k < 5; ++k)
        CHECK_FAILS(firma_fly(shots, 1, room, nobody, seconds[k], NULL, events, NULL), FIRMA_ERROR_OUT_OF_RANGE,
                    "seconds");
    firma_fly_options usual, options;
    firma_fly_options_defaults(&usual);
    double* const numbers[] = {&options.gravity[0],     &options.max_bow,           &options.max_age,
                               &options.stop_speed,     &options.max_thickness,     &options.pane_energy,
                               &options.other.friction, &options.bodies.restitution};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k) {
        options = usual;
        *numbers[k] = NAN;
        CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, &options, events, NULL), FIRMA_ERROR_INVALID, "");
    }
    options = usual;
    options.max_impacts = 0;
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, &options, events, NULL), FIRMA_ERROR_INVALID, "");
    options.max_impacts = UINT32_MAX;
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, &options, events, NULL), FIRMA_ERROR_INVALID, "");
    options = usual;
    options.max_bow = 1e-12;
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, &options, events, NULL), FIRMA_ERROR_TOO_LARGE, "");
    options = usual;
    options.matter_count = 1;
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, &options, events, NULL), FIRMA_ERROR_BAD_CALL, "count");
    options.size = 4;
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, &options, events, NULL), FIRMA_ERROR_BAD_CALL, "size");
    firma_fly_report report = {.size = 4};
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, NULL, events, &report), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_fly(NULL, 1, room, nobody, step, NULL, events, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_fly(shots, 1, (firma_world){0}, nobody, step, NULL, events, NULL), FIRMA_ERROR_BAD_HANDLE,
                "world");
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, NULL, (firma_shot_events){room.id}, NULL),
                FIRMA_ERROR_BAD_HANDLE, "shot events");
    CHECK_OK(firma_fly(NULL, 0, room, nobody, step, NULL, (firma_shot_events){0}, NULL));
    uint64_t hash = 0;
    shots[0].state = 3;
    CHECK_FAILS(firma_fly(shots, 1, room, nobody, step, NULL, events, NULL), FIRMA_ERROR_INVALID, "projectile 0");
    CHECK_FAILS(firma_projectiles_hash(shots, 1, &hash), FIRMA_ERROR_INVALID, "projectile 0");
    CHECK_FAILS(firma_projectiles_hash(shots, 1, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_projectiles_hash(NULL, 1, &hash), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_shot_events_create(NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_shot_events_get_view(events, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

void test_projectiles(void) {
    const size_t before = firma_live_handles();
    const firma_world room = make_room();
    firma_shot_events events = {0};
    CHECK_OK(firma_shot_events_create(&events));
    CHECK(view_of(events).event_count == 0);
    test_flight(room, events);
    test_slab(room, events);
    test_parts(room, events);
    test_body(room, events);
    test_bad(room, events);
    CHECK_OK(firma_shot_events_release(events));
    firma_shot_view view = {.size = sizeof view};
    CHECK_FAILS(firma_shot_events_get_view(events, &view), FIRMA_ERROR_BAD_HANDLE, "shot events");
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}

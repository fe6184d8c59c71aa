// SPDX-License-Identifier: MIT
// Bodies, a lift, players and projectiles in a level that is cut, through the C API; prints hashes of all that came
// back: the same from every machine. same_games.mjs does the very same through the JavaScript API; change both or none.
//
//   same_games LEVEL.obj STEPS
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "firma/firma_c.h"

enum { kBodies = 60, kPlayers = 6, kShots = 8, kPortion = 100 };

static const double kTick = 1.0 / 60;

static void must(firma_code code) {
    if (code == FIRMA_OK) return;
    fprintf(stderr, "%d: %s\n", (int)code, firma_error_message());
    exit(1);
}

// ---- random numbers: 32 bits, one draw a statement ----

static uint32_t state = 18018;

static uint32_t below(uint32_t count) {
    state += 0x9E3779B9u;
    uint32_t z = state;
    z = (z ^ (z >> 16)) * 0x85EBCA6Bu;
    z = (z ^ (z >> 13)) * 0xC2B2AE35u;
    return (z ^ (z >> 16)) % count;
}
// -most to most, a rounded quotient
static double within(double most) {
    const double whole = below(2001);
    return (whole - 1000) * most / 1000;
}

// ---- the hash of what came back ----

static uint32_t hash_a = 1, hash_b = 2;

static void mix(uint32_t word) {
    hash_a = (hash_a ^ word) * 0x9E3779B1u;
    hash_a ^= hash_a >> 15;
    hash_b = (hash_b + word) * 0x85EBCA6Bu;
    hash_b ^= hash_b >> 13;
}
static void mix_long(uint64_t value) {
    mix((uint32_t)value);
    mix((uint32_t)(value >> 32));
}
static void mix_double(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    mix_long(bits);
}
static void mix_three(const double* values) {
    for (int axis = 0; axis < 3; ++axis) mix_double(values[axis]);
}

// ---- what there is ----

static double low[3], high[3];

static firma_world read_level(const char* path) {
    FILE* file = fopen(path, "rb");
    if (!file) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(1);
    }
    char* bytes = NULL;
    size_t length = 0, room = 0, got = 0;
    do {
        if (length == room && !(bytes = realloc(bytes, room = 2 * room + 65536))) exit(1);
        got = fread(bytes + length, 1, room - length, file);
        length += got;
    } while (got);
    fclose(file);
    firma_world world = {0};
    must(firma_world_from_obj(bytes, length, "level", NULL, &world));
    free(bytes);
    return world;
}

// A place in the air, half a metre from all there is, on the steps of 1/64 m.
static void find_air(firma_world world, double place[3]) {
    for (;;) {
        for (int axis = 0; axis < 3; ++axis) {
            const int cells = (int)((high[axis] - low[axis]) * 64);
            place[axis] = low[axis] + below((uint32_t)cells + 1) / 64.0;
        }
        uint32_t where = 0, found = 0;
        firma_near near;
        must(firma_world_locate(world, place, &where, NULL));
        if (where != FIRMA_AIR) continue;
        must(firma_closest(world, place, 1, NULL, &near, &found));
        if (!found) return;
    }
}

// Balls, crates of eight spheres, planks of five.
static firma_body_shape make_shape(int kind) {
    double spheres[4 * 8];
    size_t count = 0;
    firma_mass mass;
    if (kind == 0) {
        const double ball[4] = {0, 0, 0, 0.25};
        memcpy(spheres, ball, sizeof ball);
        count = 1;
        must(firma_mass_of_ball(0.25, 800, &mass));
    } else if (kind == 1) {
        const double half[3] = {0.25, 0.25, 0.25};
        for (; count < 8; ++count) {
            for (int axis = 0; axis < 3; ++axis) spheres[4 * count + axis] = count >> axis & 1 ? 0.125 : -0.125;
            spheres[4 * count + 3] = 0.125;
        }
        must(firma_mass_of_box(half, 500, &mass));
    } else {
        const double half[3] = {0.625, 0.125, 0.125};
        for (; count < 5; ++count) {
            const double plank[4] = {0.25 * ((double)count - 2), 0, 0, 0.125};
            memcpy(spheres + 4 * count, plank, sizeof plank);
        }
        must(firma_mass_of_box(half, 700, &mass));
    }
    firma_body_shape shape = {0};
    must(firma_body_shape_spheres(spheres, count, &mass, &shape));
    return shape;
}

static firma_bodies make_bodies(firma_world world) {
    firma_bodies bodies = {0};
    must(firma_bodies_create(&bodies));
    for (int k = 0; k < kBodies; ++k) {
        const firma_body_shape shape = make_shape(k % 3);
        firma_pose pose = {.rotation = {0, 0, 0, 1}, .scale = 1};
        find_air(world, pose.position);
        for (int part = 0; part < 3; ++part) pose.rotation[part] = within(1);
        firma_body_id id;
        must(firma_bodies_add(bodies, shape, &pose, &id));
        firma_body body = {.size = sizeof body};
        must(firma_bodies_get(bodies, id, &body));
        for (int axis = 0; axis < 3; ++axis) body.velocity[axis] = within(k % 5 ? 8 : 200);
        for (int axis = 0; axis < 3; ++axis) body.spin[axis] = within(20);
        must(firma_bodies_set(bodies, id, &body));
        must(firma_body_shape_release(shape));
    }
    return bodies;
}

// A slab that goes up and down and turns, at a place in the air.
static firma_part make_lift(firma_world world) {
    const double positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -1, -1, .25, 1, -1, .25, 1, 1, .25, -1, 1, .25};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8, .corners = corners};
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_part part;
    firma_part_defaults(&part);
    must(firma_world_from_mesh(&mesh, "lift", NULL, &part.world));
    find_air(world, part.motion.position);
    return part;
}

// ---- a step ----

static firma_world cut(firma_world world) {
    firma_cutter cutter = {0};
    const uint32_t shape = below(5);
    const uint32_t seed = below(1000);
    must(firma_cutter_crater(shape, seed, &cutter));
    firma_pose pose = {.rotation = {0, 0, 0, 1}};
    find_air(world, pose.position);
    firma_near near;
    uint32_t found = 0;
    must(firma_closest(world, pose.position, 1e3, NULL, &near, &found));
    memcpy(pose.position, near.point, sizeof near.point);
    pose.scale = (10 + below(11)) / 8.0;
    firma_world after = {0};
    firma_carve_report report = {.size = sizeof report};
    must(firma_carve(world, cutter, &pose, NULL, &after, &report));
    mix(report.status);
    must(firma_cutter_release(cutter));
    must(firma_world_release(world));
    return after;
}

static void shoot(firma_world world, firma_bodies bodies, firma_projectile* shots, firma_shot_events events, int step) {
    if (step % 30 == 0)
        for (int k = 0; k < kShots; ++k) {
            firma_projectile_defaults(&shots[k]);
            find_air(world, shots[k].position);
            for (int axis = 0; axis < 3; ++axis) shots[k].velocity[axis] = within(400);
        }
    firma_fly_options options;
    firma_fly_options_defaults(&options);
    options.other.resistance = 1500;
    firma_fly_report report = {.size = sizeof report};
    must(firma_fly(shots, kShots, world, bodies, kTick, &options, events, &report));
    mix((uint32_t)report.impacts);
    firma_shot_view view = {.size = sizeof view};
    must(firma_shot_events_get_view(events, &view));
    for (size_t k = 0; k < view.event_count; ++k) {
        const firma_shot_event* event = &view.events[k];
        mix(event->kind);
        mix(event->projectile);
        mix(event->face);
        mix_double(event->time);
        mix_three(event->point);
        mix_three(event->velocity);
        mix_double(event->thickness);
    }
    uint64_t hash = 0;
    must(firma_projectiles_hash(shots, kShots, &hash));
    mix_long(hash);
}

static void walk(const firma_scene* scene, const firma_player_shape* shapes, firma_player_move* moves,
                 firma_player_wish* wishes, int step) {
    for (int k = 0; k < kPlayers; ++k) {
        if (step % 40 == 0) {
            for (int axis = 0; axis < 3; ++axis) wishes[k].velocity[axis] = within(7);
            wishes[k].crouch = below(4) == 0;
        }
        wishes[k].jump = below(20) == 0;
        must(firma_move_player(scene, shapes[k % 2], &moves[k].player, &wishes[k], kTick, NULL, &moves[k]));
        const firma_player_move* move = &moves[k];
        mix_three(move->player.position);
        mix_three(move->player.velocity);
        mix(move->player.on_ground + 2 * move->player.crouched + 4 * move->player.stuck + 8 * move->jumped);
        mix(move->contact_count);
        for (uint32_t c = 0; c < move->contact_count; ++c) {
            mix(move->contacts[c].kind);
            mix(move->contacts[c].face);
            mix_three(move->contacts[c].point);
        }
    }
}

int main(int count, char** words) {
    if (count != 3) return fputs("usage: same_games LEVEL STEPS\n", stderr), 2;
    const int steps = atoi(words[2]);
    firma_world world = read_level(words[1]);
    firma_world_facts facts = {.size = sizeof facts};
    must(firma_world_get_facts(world, &facts));
    memcpy(low, facts.low, sizeof low);
    memcpy(high, facts.high, sizeof high);

    const firma_bodies bodies = make_bodies(world);
    firma_part lift = make_lift(world);
    const double base = lift.motion.position[2];
    firma_scene scene;
    firma_scene_defaults(&scene);
    must(firma_parts_create(&scene.parts));
    must(firma_parts_add(scene.parts, &lift, NULL));
    firma_player_shape shapes[2] = {{0}, {0}};
    must(firma_player_shape_capsule(NULL, &shapes[0]));
    must(firma_player_shape_box(NULL, &shapes[1]));
    firma_player_move moves[kPlayers];
    firma_player_wish wishes[kPlayers];
    for (int k = 0; k < kPlayers; ++k) {
        moves[k] = (firma_player_move){.size = sizeof moves[k]};
        wishes[k] = (firma_player_wish){.size = sizeof wishes[k]};
        firma_player_defaults(&moves[k].player);
        find_air(world, moves[k].player.position);
    }
    firma_projectile shots[kShots];
    firma_shot_events events = {0};
    must(firma_shot_events_create(&events));

    for (int step = 0; step < steps; ++step) {
        if (step % 50 == 49) world = cut(world);
        scene.world = world;
        lift.motion.position[2] = base + (step / 30 % 2 ? 30 - step % 30 : step % 30) / 64.0;
        lift.motion.path[2] = step / 30 % 2 ? -1 / 64.0 : 1 / 64.0;
        lift.motion.turn[2] = 1 / 32.0;
        must(firma_parts_set_motions(scene.parts, &lift.motion, 1));
        firma_step_report report = {.size = sizeof report};
        must(firma_bodies_step_scene(bodies, &scene, kTick, NULL, &report));
        mix((uint32_t)report.contacts);
        mix((uint32_t)report.bounces);
        mix((uint32_t)report.awake);
        walk(&scene, shapes, moves, wishes, step);
        shoot(world, bodies, shots, events, step);
        uint64_t hash = 0;
        must(firma_bodies_hash(bodies, &hash));
        mix_long(hash);
        if ((step + 1) % kPortion == 0 || step + 1 == steps)
            printf("steps=%d awake=%d bodies=%016llx games=%08x%08x\n", step + 1, (int)report.awake,
                   (unsigned long long)hash, hash_a, hash_b);
    }
    must(firma_shot_events_release(events));
    for (int k = 0; k < 2; ++k) must(firma_player_shape_release(shapes[k]));
    must(firma_parts_release(scene.parts));
    must(firma_world_release(lift.world));
    must(firma_bodies_release(bodies));
    must(firma_world_release(world));
    return firma_live_handles() != 0;
}

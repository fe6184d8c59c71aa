/* SPDX-License-Identifier: MIT */
/* Fractures, debris that breaks, blasts, rubble that becomes ground, what a path goes through; bad arguments. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

static const firma_pose kHere = {{0, 0, 0}, {0, 0, 0, 1}, 1};

/* A column that hangs from the ceiling, cut through: what was below, and the world without it. */
typedef struct column {
    firma_world world;
    firma_chunks chunks;
} column;

static column fallen_column(firma_world room) {
    const firma_cutter hung = make_box(3, 3, 1, 4, 4, 5), cut = make_box(2.5, 2.5, 2.25, 4.5, 4.5, 2.75);
    firma_carve_options options = {.size = sizeof options, .fill = 1};
    firma_carve_report report = {.size = sizeof report};
    firma_world filled = {0};
    column made = {{0}, {0}};
    CHECK_OK(firma_carve(room, hung, &kHere, &options, &filled, &report));
    options = (firma_carve_options){.size = sizeof options, .chunks = 1, .density = 2000};
    CHECK_OK(firma_carve(filled, cut, &kHere, &options, &made.world, &report));
    made.chunks = report.loose;
    CHECK_OK(firma_world_release(filled));
    CHECK_OK(firma_cutter_release(hung));
    CHECK_OK(firma_cutter_release(cut));
    return made;
}

static void release_column(column it) {
    CHECK_OK(firma_chunks_release(it.chunks));
    CHECK_OK(firma_world_release(it.world));
}

static size_t named(firma_debris debris, uint32_t list) {
    size_t count = 77;
    CHECK_OK(firma_debris_named(debris, list, NULL, 0, &count));
    return count;
}

static double mass_of_all(firma_bodies bodies) {
    firma_body_id ids[64];
    size_t count = 0;
    double mass = 0;
    CHECK_OK(firma_bodies_list(bodies, ids, 64, &count));
    CHECK(count <= 64);
    for (size_t k = 0; k < count; ++k) {
        firma_body body = {.size = sizeof body};
        CHECK_OK(firma_bodies_get(bodies, ids[k], &body));
        mass += body.mass;
    }
    return mass;
}

static firma_fracture_pattern lumps(double size) {
    const firma_fracture_pattern pattern = {sizeof pattern, FIRMA_CRACK_LUMPS, {size, size, size}, 1, 0.5, 0, 0,
                                            {0, 0, 0, 1},   {0, 0, 0}};
    return pattern;
}

static void test_fracture(firma_world room) {
    firma_fracture_pattern pattern = {.size = sizeof pattern};
    CHECK_OK(firma_fracture_pattern_of(room, 0, &pattern));
    CHECK(pattern.style == FIRMA_CRACK_LUMPS && pattern.size_of_piece[0] > 0 && !pattern.has_axes);
    CHECK_FAILS(firma_fracture_pattern_of(room, 99, &pattern), FIRMA_ERROR_INVALID, "no such matter");
    CHECK_FAILS(firma_fracture_pattern_of(room, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");

    const column fallen = fallen_column(room);
    firma_world solid = {0};
    CHECK_OK(firma_chunks_world(fallen.chunks, 0, &solid));
    firma_chunks pieces = {0};
    firma_fracture_options options = {.size = sizeof options, .max_pieces = 8, .density = 1000, .has_impact = 1};
    pattern = lumps(0.3);
    CHECK_OK(firma_world_fracture(solid, &pattern, &options, &pieces));
    size_t count = 0;
    double volume = 0, mass = 0;
    CHECK_OK(firma_chunks_get_count(pieces, &count));
    CHECK(count == 8);
    for (size_t k = 0; k < count; ++k) {
        firma_chunk piece = {.size = sizeof piece};
        CHECK_OK(firma_chunks_get(pieces, k, &piece));
        volume += piece.mass.volume;
        mass += piece.mass.mass;
        CHECK(piece.origin[0] == 0 && piece.face_count >= 4);
    }
    CHECK(fabs(volume - 1.25) < 1e-12 && fabs(mass - 1250) < 1e-9);
    CHECK_OK(firma_chunks_release(pieces));

    CHECK_FAILS(firma_world_fracture(room, &pattern, NULL, &pieces), FIRMA_ERROR_INVALID, "rock");
    CHECK_FAILS(firma_world_fracture(solid, NULL, NULL, &pieces), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_fracture(solid, &pattern, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_fracture((firma_world){0}, &pattern, NULL, &pieces), FIRMA_ERROR_BAD_HANDLE, "world");
    options.max_pieces = 5000;
    CHECK_FAILS(firma_world_fracture(solid, &pattern, &options, &pieces), FIRMA_ERROR_INVALID, "pieces");
    options.has_impact = 2;
    CHECK_FAILS(firma_world_fracture(solid, &pattern, &options, &pieces), FIRMA_ERROR_INVALID, "has_impact");
    options.size = 4;
    CHECK_FAILS(firma_world_fracture(solid, &pattern, &options, &pieces), FIRMA_ERROR_BAD_CALL, "size");
    pattern.style = 3;
    CHECK_FAILS(firma_world_fracture(solid, &pattern, NULL, &pieces), FIRMA_ERROR_INVALID, "style");
    pattern = lumps(0);
    CHECK_FAILS(firma_world_fracture(solid, &pattern, NULL, &pieces), FIRMA_ERROR_INVALID, "");
    pattern = lumps(0.3);
    pattern.has_axes = 1;
    pattern.axes[3] = 0;
    CHECK_FAILS(firma_world_fracture(solid, &pattern, NULL, &pieces), FIRMA_ERROR_INVALID, "axes");
    CHECK_OK(firma_world_release(solid));
    release_column(fallen);
}

static void test_shatter(firma_world room) {
    const column fallen = fallen_column(room);
    firma_bodies bodies = {0}, other_bodies = {0};
    firma_debris debris = {0}, copy = {0};
    firma_body_id id = {9, 9};
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_debris_create(&debris));
    CHECK_OK(firma_debris_add_chunk(debris, bodies, fallen.chunks, 0, NULL, &id));
    firma_debris_piece piece = {.size = sizeof piece};
    CHECK_OK(firma_debris_get(debris, bodies, id, &piece));
    CHECK(piece.face_count >= 6 && piece.broken == 0 && !piece.of_part && fabs(piece.origin[2] - 1.625) < 1e-3);
    firma_world solid = {0};
    CHECK_OK(firma_debris_world(debris, bodies, id, &solid));
    firma_mass mass;
    CHECK_OK(firma_world_mass(solid, 2000, &mass));
    CHECK(fabs(mass.mass - 2500) < 1e-9);
    CHECK_OK(firma_world_release(solid));

    /* A snapshot is a copy of both: it shatters into the same. */
    CHECK_OK(firma_bodies_copy(bodies, &other_bodies));
    CHECK_OK(firma_debris_copy(debris, &copy));
    firma_fracture_options fracture = {.size = sizeof fracture, .max_pieces = 6, .seed = 5};
    firma_shatter_options options = {.size = sizeof options, .max_spheres = 8, .world = fallen.world};
    firma_shattered report = {.size = sizeof report};
    const firma_fracture_pattern pattern = lumps(0.4);
    const double push[3] = {2500, 0, 0}, at[3] = {3.5, 3.5, 1.625};
    CHECK_OK(firma_bodies_push(bodies, id, push, at));
    CHECK_OK(firma_bodies_push(other_bodies, id, push, at));
    CHECK_OK(firma_shatter(debris, bodies, id, &pattern, &fracture, &options, &report));
    CHECK(report.pieces + report.dust == 6 && report.pieces >= 4 && report.cracks >= 5);
    CHECK(named(debris, FIRMA_DEBRIS_PIECES) == report.pieces && named(debris, FIRMA_DEBRIS_LOOSE) == 0);
    CHECK(fabs(mass_of_all(bodies) + report.dust_mass - 2500) < 1e-6);
    CHECK_OK(firma_shatter(copy, other_bodies, id, &pattern, &fracture, &options, NULL));
    uint64_t one = 0, two = 1;
    CHECK_OK(firma_debris_hash(debris, &one));
    CHECK_OK(firma_debris_hash(copy, &two));
    CHECK(one == two);
    CHECK_OK(firma_bodies_hash(bodies, &one));
    CHECK_OK(firma_bodies_hash(other_bodies, &two));
    CHECK(one == two);

    firma_body_id ids[6];
    size_t count = 0;
    ids[1].slot = 77;
    CHECK_OK(firma_debris_named(debris, FIRMA_DEBRIS_PIECES, ids, 1, &count));
    CHECK(count == report.pieces && ids[1].slot == 77);
    CHECK_OK(firma_debris_get(debris, bodies, ids[0], &piece));
    CHECK(piece.broken == 1);
    firma_body body = {.size = sizeof body};
    CHECK_OK(firma_bodies_get(bodies, ids[0], &body));
    CHECK(fabs(body.velocity[0] - 1) < 1e-9);
    CHECK_OK(firma_debris_remove(debris, bodies, ids[0]));
    CHECK_FAILS(firma_debris_get(debris, bodies, ids[0], &piece), FIRMA_ERROR_INVALID, "no such body");

    /* What is no debris, and what is no list. */
    firma_body_shape shape = {0};
    const double sphere[4] = {0, 0, 0, 0.25};
    CHECK_OK(firma_mass_of_ball(0.25, 1000, &mass));
    CHECK_OK(firma_body_shape_spheres(sphere, 1, &mass, &shape));
    const firma_pose pose = {{1, 1, 1}, {0, 0, 0, 1}, 1};
    CHECK_OK(firma_bodies_add(bodies, shape, &pose, &id));
    CHECK_OK(firma_body_shape_release(shape));
    CHECK_FAILS(firma_debris_get(debris, bodies, id, &piece), FIRMA_ERROR_INVALID, "no debris");
    CHECK_FAILS(firma_shatter(debris, bodies, id, &pattern, NULL, NULL, NULL), FIRMA_ERROR_INVALID, "no debris");
    CHECK_FAILS(firma_debris_world(debris, bodies, id, &solid), FIRMA_ERROR_INVALID, "no debris");
    CHECK_FAILS(firma_debris_remove(debris, bodies, id), FIRMA_ERROR_INVALID, "no debris");
    CHECK_FAILS(firma_debris_named(debris, 4, ids, 1, &count), FIRMA_ERROR_INVALID, "list");
    CHECK_FAILS(firma_debris_named(debris, 0, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_debris_add_chunk(debris, bodies, fallen.chunks, 1, NULL, &id), FIRMA_ERROR_OUT_OF_RANGE, "chunk");
    CHECK_FAILS(firma_debris_add_chunk((firma_debris){0}, bodies, fallen.chunks, 0, NULL, &id), FIRMA_ERROR_BAD_HANDLE,
                "debris");
    CHECK_FAILS(firma_debris_add_chunk(debris, (firma_bodies){0}, fallen.chunks, 0, NULL, &id), FIRMA_ERROR_BAD_HANDLE,
                "bodies");
    options.max_spheres = 5000;
    CHECK_OK(firma_debris_named(copy, FIRMA_DEBRIS_PIECES, ids, 6, &count));
    CHECK_OK(firma_debris_hash(copy, &one));
    CHECK_FAILS(firma_shatter(copy, other_bodies, ids[0], &pattern, NULL, &options, NULL), FIRMA_ERROR_INVALID,
                "max_spheres");
    CHECK_OK(firma_debris_hash(copy, &two));
    CHECK(one == two && named(copy, FIRMA_DEBRIS_PIECES) == count);
    CHECK_OK(firma_debris_release(debris));
    CHECK_OK(firma_debris_release(copy));
    CHECK_FAILS(firma_debris_hash(copy, &one), FIRMA_ERROR_BAD_HANDLE, "debris");
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_bodies_release(other_bodies));
    release_column(fallen);
}

/* What falls sleeps, and becomes ground; a log can make the same edit again. */
static void test_ground(firma_world room) {
    const column fallen = fallen_column(room);
    firma_bodies bodies = {0};
    firma_debris debris = {0};
    firma_body_id id;
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_debris_create(&debris));
    CHECK_OK(firma_debris_add_chunk(debris, bodies, fallen.chunks, 0, NULL, &id));
    firma_debris_rules rules;
    firma_debris_rules_defaults(&rules);
    CHECK(rules.max_bodies == 256 && rules.max_spheres == 4096 && rules.max_asleep == 20 && !rules.to_ground);
    rules.to_ground = 1;
    rules.max_asleep = 0.25;
    firma_world now = {0}, after = {0};
    firma_debris_report report = {.size = sizeof report};
    CHECK_OK(firma_world_copy(fallen.world, &now));
    int frame = 0;
    for (; frame < 600 && report.to_ground == 0; ++frame) {
        CHECK_OK(firma_bodies_step(bodies, now, 1.0 / 60, NULL, NULL));
        CHECK_OK(firma_debris_tend(debris, bodies, now, 1.0 / 60, &rules, &after, &report));
        CHECK_OK(firma_world_release(now));
        now = after;
    }
    CHECK(report.to_ground == 1 && report.removed == 0 && named(debris, FIRMA_DEBRIS_TO_GROUND) == 1);
    CHECK(hash_of(now) != hash_of(fallen.world));
    size_t count = 9;
    CHECK_OK(firma_bodies_get_count(bodies, &count));
    CHECK(count == 0);
    firma_cutter cutter = {0};
    firma_pose pose;
    const char* material = NULL;
    CHECK_OK(firma_debris_fill(debris, 0, &cutter, &pose, &material));
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1, .material = material};
    CHECK_OK(firma_carve(fallen.world, cutter, &pose, &fill, &after, NULL));
    CHECK(hash_of(after) == hash_of(now));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_cutter_release(cutter));
    CHECK_FAILS(firma_debris_fill(debris, 1, &cutter, &pose, &material), FIRMA_ERROR_OUT_OF_RANGE, "no such fill");

    after.id = 77;
    CHECK_FAILS(firma_debris_tend(debris, bodies, now, NAN, &rules, &after, NULL), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    rules.max_age = NAN;
    CHECK_FAILS(firma_debris_tend(debris, bodies, now, 1, &rules, &after, NULL), FIRMA_ERROR_OUT_OF_RANGE, "rule");
    rules.max_age = 1;
    rules.keep_clear_count = 1;
    CHECK_FAILS(firma_debris_tend(debris, bodies, now, 1, &rules, &after, NULL), FIRMA_ERROR_BAD_CALL, "count");
    const double bad[4] = {0, 0, 0, -1};
    rules.keep_clear = bad;
    CHECK_FAILS(firma_debris_tend(debris, bodies, now, 1, &rules, &after, NULL), FIRMA_ERROR_OUT_OF_RANGE, "sphere");
    rules.to_ground = 2;
    CHECK_FAILS(firma_debris_tend(debris, bodies, now, 1, &rules, &after, NULL), FIRMA_ERROR_INVALID, "to_ground");
    CHECK_FAILS(firma_debris_tend(debris, bodies, (firma_world){0}, 1, NULL, &after, NULL), FIRMA_ERROR_BAD_HANDLE,
                "world");
    CHECK(after.id == 77);
    CHECK_OK(firma_world_release(now));
    CHECK_OK(firma_debris_release(debris));
    CHECK_OK(firma_bodies_release(bodies));
    release_column(fallen);
}

/* A block of 2 m that moves away upward covers the first sphere, and what lies there, as it begins. */
static void test_cover_by_a_part(firma_world room, const double from[3], const double* spheres) {
    const double positions[] = {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8, .corners = corners};
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_part block;
    firma_part_defaults(&block);
    CHECK_OK(firma_world_from_mesh(&mesh, "block", NULL, &block.world));
    const firma_motion up = {.position = {4, 4, 2}, .rotation = {0, 0, 0, 1}, .path = {0, 0, 100}};
    block.motion = up;
    firma_scene scene;
    firma_scene_defaults(&scene);
    scene.world = room;
    CHECK_OK(firma_parts_create(&scene.parts));
    CHECK_OK(firma_parts_add(scene.parts, &block, NULL));
    firma_bodies bodies = {0};
    firma_debris debris = {0};
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_debris_create(&debris));
    const firma_mass mass = {.volume = 0.5, .mass = 500, .inertia = {50, 0, 0, 0, 50, 0, 0, 0, 50}};
    firma_body_shape ball = {0};
    CHECK_OK(firma_body_shape_spheres((const double[4]){0, 0, 0, 0.5}, 1, &mass, &ball));
    const firma_pose there = {{2, 4, 2}, {0, 0, 0, 1}, 1};
    firma_body_id id;
    CHECK_OK(firma_bodies_add(bodies, ball, &there, &id));
    firma_blast blast;
    firma_blast_defaults(&blast);
    memcpy(blast.at, from, sizeof blast.at);
    for (int gone = 0; gone < 2; ++gone) {
        scene.from = gone;
        double seen = 9;
        CHECK_OK(firma_exposure_scene(&scene, from, spheres, 1, UINT32_MAX, &seen));
        CHECK(seen == gone);
        firma_push_report pushed = {.size = sizeof pushed};
        CHECK_OK(firma_blast_push_scene(&scene, bodies, &blast, NULL, &pushed));
        CHECK(pushed.reached == 1 && pushed.pushed == (uint64_t)gone);
        firma_explosion report = {.size = sizeof report};
        firma_world after = {0};
        CHECK_OK(firma_explode_scene(&scene, debris, bodies, &blast, (firma_cutter){0}, &there, NULL, &after, &report));
        CHECK(report.reached == 1 && report.pushed == (uint64_t)gone && hash_of(after) == hash_of(room));
        CHECK_OK(firma_world_release(after));
    }
    double seen = 9;
    CHECK_FAILS(firma_exposure_scene(NULL, from, spheres, 1, UINT32_MAX, &seen), FIRMA_ERROR_BAD_CALL, "null");
    scene.from = 2;
    CHECK_OK(firma_exposure_scene(&scene, from, spheres, 1, UINT32_MAX, &seen));
    CHECK(seen == 0);
    CHECK_OK(firma_body_shape_release(ball));
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_debris_release(debris));
    CHECK_OK(firma_parts_release(scene.parts));
    CHECK_OK(firma_world_release(block.world));
}

static void test_blasts(firma_world room) {
    firma_blast blast;
    firma_blast_defaults(&blast);
    CHECK(blast.radius == 6 && blast.impulse == 3000 && blast.at[0] == 0);
    double share = 9, push[3], seen = 9;
    CHECK_OK(firma_blast_share(&blast, 3, &share));
    CHECK(share == 0.25);
    const double at[3] = {0, 0, 3};
    CHECK_OK(firma_blast_impulse(&blast, at, 2, 0.5, push));
    CHECK(push[0] == 0 && push[1] == 0 && push[2] == 750);
    const double spheres[8] = {2, 4, 2, 0.5, 20, 4, 2, 0.5};
    const double from[3] = {6, 4, 2};
    CHECK_OK(firma_exposure(room, from, spheres, 1, UINT32_MAX, &seen));
    CHECK(seen == 1);
    CHECK_OK(firma_exposure(room, from, spheres, 2, UINT32_MAX, &seen));
    CHECK(seen == 0.5); /* the second lies behind the wall */
    CHECK_OK(firma_exposure(room, from, NULL, 0, UINT32_MAX, &seen));
    CHECK(seen == 0);
    test_cover_by_a_part(room, from, spheres);
    CHECK_FAILS(firma_blast_share(&blast, NAN, &share), FIRMA_ERROR_OUT_OF_RANGE, "distance");
    CHECK_FAILS(firma_blast_share(&blast, 1, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_blast_impulse(&blast, at, -1, 1, push), FIRMA_ERROR_OUT_OF_RANGE, "area");
    CHECK_FAILS(firma_exposure(room, from, NULL, 1, 1, &seen), FIRMA_ERROR_BAD_CALL, "null");
    blast.radius = 0;
    CHECK_FAILS(firma_blast_share(&blast, 1, &share), FIRMA_ERROR_OUT_OF_RANGE, "blast");
    blast.size = 3;
    CHECK_FAILS(firma_blast_share(&blast, 1, &share), FIRMA_ERROR_BAD_CALL, "size");
}

/* The column is shot off the ceiling: it comes loose, breaks, and flies. */
static void test_explosion(firma_world room) {
    const firma_cutter hung = make_box(3, 3, 1, 4, 4, 5);
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    firma_world filled = {0}, held = {0}, after = {0};
    CHECK_OK(firma_carve(room, hung, &kHere, &fill, &filled, NULL));
    /* It hangs by the ceiling's rock. */
    CHECK_OK(firma_world_with_anchors(filled, NULL, &held));
    firma_bodies bodies = {0};
    firma_debris debris = {0};
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_debris_create(&debris));
    firma_cutter crater = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, 1, &crater));
    firma_blast blast;
    firma_blast_defaults(&blast);
    const double at[3] = {3.5, 2.9, 3.25};
    memcpy(blast.at, at, sizeof at);
    const firma_pose pose = {{3.5, 3.5, 3.25}, {0, 0, 0, 1}, 1};
    firma_explode_options options;
    firma_explode_options_defaults(&options);
    CHECK(options.break_radius == 3 && options.max_pieces == 12 && options.push.max_speed == 30);
    firma_explosion report = {.size = sizeof report, .carve = {.size = sizeof report.carve}};
    CHECK_OK(firma_explode(held, debris, bodies, &blast, crater, &pose, &options, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.loose > 2 && report.broken == 1 && report.pushed > 0);
    CHECK(report.carve.status == FIRMA_CARVE_DONE && report.carve.chunks == 1 && report.carve.loose.id == 0);
    CHECK(named(debris, FIRMA_DEBRIS_LOOSE) == report.loose && named(debris, FIRMA_DEBRIS_PIECES) == 0);
    CHECK(hash_of(after) != hash_of(held));
    CHECK_OK(firma_bodies_step(bodies, after, 1.0 / 60, NULL, NULL));

    /* Another without a crater breaks what lies there; the world is the same. */
    firma_world again = {0};
    const double low[3] = {3.5, 3.5, 0.5};
    memcpy(blast.at, low, sizeof low);
    options.break_radius = 8;
    options.min_volume = 0.0001;
    CHECK_OK(firma_explode(after, debris, bodies, &blast, (firma_cutter){0}, &pose, &options, &again, &report));
    CHECK(report.status == FIRMA_CARVE_NOTHING && report.loose == 0 && report.pieces > 0 && report.broken > 0);
    CHECK(hash_of(after) == hash_of(again));
    firma_push_report pushed = {.size = sizeof pushed};
    CHECK_OK(firma_blast_push(again, bodies, &blast, NULL, &pushed));
    CHECK(pushed.reached >= pushed.pushed && pushed.pushed > 0);

    uint64_t before = 0, unchanged = 1;
    CHECK_OK(firma_bodies_hash(bodies, &before));
    firma_world none = {77};
    options.max_pieces = 0;
    CHECK_FAILS(firma_explode(after, debris, bodies, &blast, crater, &pose, &options, &none, NULL),
                FIRMA_ERROR_OUT_OF_RANGE, "option");
    options.max_pieces = 12;
    options.carve = &fill;
    CHECK_FAILS(firma_explode(after, debris, bodies, &blast, crater, &pose, &options, &none, NULL), FIRMA_ERROR_INVALID,
                "fill");
    options.carve = NULL;
    options.push.max_speed = NAN;
    CHECK_FAILS(firma_explode(after, debris, bodies, &blast, crater, &pose, &options, &none, NULL),
                FIRMA_ERROR_OUT_OF_RANGE, "max_speed");
    CHECK_FAILS(firma_explode(after, debris, bodies, NULL, crater, &pose, NULL, &none, NULL), FIRMA_ERROR_BAD_CALL,
                "null");
    CHECK_FAILS(firma_explode(after, debris, bodies, &blast, (firma_cutter){after.id}, &pose, NULL, &none, NULL),
                FIRMA_ERROR_BAD_HANDLE, "cutter");
    CHECK_FAILS(firma_blast_push(again, (firma_bodies){0}, &blast, NULL, NULL), FIRMA_ERROR_BAD_HANDLE, "bodies");
    CHECK(none.id == 77);
    CHECK_OK(firma_bodies_hash(bodies, &unchanged));
    CHECK(before == unchanged);

    /* A crater that is refused: the push happens all the same. */
    firma_pose far = pose;
    far.position[0] = 1e9;
    report.carve.size = 0;
    CHECK_OK(firma_explode(after, debris, bodies, &blast, crater, &far, NULL, &none, &report));
    CHECK(report.status == FIRMA_CARVE_REFUSED && firma_error_message()[0] != 0 && report.pushed > 0);
    CHECK_OK(firma_world_release(none));

    CHECK_OK(firma_cutter_release(crater));
    CHECK_OK(firma_cutter_release(hung));
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_debris_release(debris));
    CHECK_OK(firma_world_release(again));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(held));
    CHECK_OK(firma_world_release(filled));
}

static void test_pierce(firma_world room) {
    const firma_cutter slab = make_box(4, -1, -1, 4.5, 9, 5);
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    firma_world walled = {0};
    CHECK_OK(firma_carve(room, slab, &kHere, &fill, &walled, NULL));
    firma_piercing piercing = {0};
    CHECK_OK(firma_piercing_create(&piercing));
    firma_piercing_view view = {.size = sizeof view};
    CHECK_OK(firma_piercing_get_view(piercing, &view));
    CHECK(view.span_count == 0);
    const double start[3] = {2, 4, 2}, path[3] = {5, 0, 0}, up[3] = {0, 0, 1}, bad[3] = {NAN, 0, 0};
    uint32_t status = 9;
    CHECK_OK(firma_pierce(walled, start, path, NULL, piercing, &status));
    CHECK_OK(firma_piercing_get_view(piercing, &view));
    CHECK(status == FIRMA_HIT && view.span_count == 1 && fabs(view.thickness - 0.5) < 1e-9 && view.length_count == 1);
    CHECK(fabs(view.spans[0].in.fraction - 0.4) < 1e-9 && view.spans[0].in.normal[0] == -1 && !view.spans[0].pane);
    CHECK(fabs(view.spans[0].out.point[0] - 4.5) < 1e-9 && view.spans[0].portal == FIRMA_NO_PORTAL);
    CHECK(view.spans[0].length_count == 1 && fabs(view.lengths[0].from - 0.4) < 1e-9);
    firma_pierce_options options;
    firma_pierce_options_defaults(&options);
    CHECK(options.mask == UINT32_MAX && !options.no_panes);
    options.no_matters = 1;
    CHECK_OK(firma_pierce(walled, start, up, &options, piercing, &status));
    CHECK_OK(firma_piercing_get_view(piercing, &view));
    CHECK(status == FIRMA_MISS && view.span_count == 0 && view.thickness == 0);
    CHECK_FAILS(firma_pierce(walled, bad, path, &options, piercing, &status), FIRMA_ERROR_OUT_OF_RANGE, "number");
    options.both_sides = 2;
    CHECK_FAILS(firma_pierce(walled, start, path, &options, piercing, &status), FIRMA_ERROR_INVALID, "flag");
    CHECK_FAILS(firma_pierce(walled, start, path, NULL, (firma_piercing){0}, &status), FIRMA_ERROR_BAD_HANDLE,
                "piercing");
    CHECK_OK(firma_piercing_release(piercing));
    CHECK_OK(firma_world_release(walled));
    CHECK_OK(firma_cutter_release(slab));
}

void test_debris(void) {
    const size_t before = firma_live_handles();
    const firma_world room = make_room();
    test_fracture(room);
    test_shatter(room);
    test_ground(room);
    test_blasts(room);
    test_explosion(room);
    test_pierce(room);
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}

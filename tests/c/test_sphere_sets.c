/* SPDX-License-Identifier: MIT */
/* Sets of spheres: against a world, against each other, fitted into a solid; bad arguments. */
#include <math.h>

#include "tests/c/check.h"

/* Two spheres, 2 m apart along x. */
static const double kBar[8] = {-1, 0, 0, 0.25, 1, 0, 0, 0.25};

static firma_motion go(double x, double y, double z, double path_x, double turn_z) {
    return (firma_motion){{x, y, z}, {0, 0, 0, 1}, {path_x, 0, 0}, {0, 0, turn_z}};
}

static void test_against_a_world(firma_world room) {
    firma_set_hit hit;
    firma_motion motion = go(4, 4, 2, 6, 0);
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, NULL, &hit));
    /* The one in front has 2.75 m to go. */
    CHECK(hit.sphere == 1 && hit.hit.status == FIRMA_HIT && fabs(hit.hit.fraction - 2.75 / 6) < 1e-12);
    CHECK(hit.hit.centre[0] == 7.75 && hit.hit.normal[0] == -1);
    /* To the bit that of its own cast. */
    const firma_cast_input alone = {{5, 4, 2}, 0.25, {6, 0, 0}};
    firma_hit single;
    CHECK_OK(firma_cast(room, &alone, NULL, &single, NULL));
    CHECK(memcmp(&single, &hit.hit, sizeof single) == 0);

    /* A quarter turn beside a wall: the far sphere comes to it where cos(a) = 0.75 / 1. */
    motion = go(7, 4, 2, 0, -1.5);
    const double end[4] = {0, 1, 0, 0.25};
    CHECK_OK(firma_cast_set(room, end, 1, &motion, NULL, &hit));
    CHECK(hit.sphere == 0 && hit.hit.status == FIRMA_HIT);
    CHECK(fabs(sin(1.5 * hit.hit.fraction) - 0.75) < 2e-4 && hit.hit.point[0] == 8);

    motion = go(4, 4, 2, 0.5, 0);
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_MISS && hit.hit.fraction == 1 && hit.sphere == FIRMA_NO_SPHERE);
    CHECK_OK(firma_cast_set(room, NULL, 0, &motion, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_MISS);
    motion = go(4, 4, 2, 6, 0);
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.mask = 0;
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, &options, &hit));
    CHECK(hit.hit.status == FIRMA_MISS);
}

static void test_bad_sets(firma_world room) {
    firma_set_hit hit;
    firma_motion motion = go(4, 4, 2, 0.5, 0);
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.room = 7; /* is not there; and nothing is near */
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, &options, &hit));
    CHECK(hit.hit.status == FIRMA_INVALID && hit.hit.fraction == 0 && hit.hit.safe_fraction == 0);
    const double negative[4] = {0, 0, 0, -1};
    CHECK_OK(firma_cast_set(room, negative, 1, &motion, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_INVALID);
    motion.path[1] = NAN;
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_INVALID);
    motion = go(4, 4, 2, 0.5, 0);
    motion.rotation[3] = 0;
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, NULL, &hit));
    CHECK(hit.hit.status == FIRMA_INVALID);
    motion.rotation[3] = 1;
    firma_scene scene;
    firma_scene_defaults(&scene);
    scene.world = room;
    firma_set_part_hit of_scene;
    motion = go(4, 4, 2, 6, 0);
    CHECK_OK(firma_cast_set(room, kBar, 2, &motion, NULL, &hit));
    CHECK_OK(firma_cast_set_scene(&scene, kBar, 2, &motion, NULL, &of_scene));
    CHECK(hit.hit.status == FIRMA_HIT && of_scene.hit.hit.status == FIRMA_HIT && of_scene.hit.part == FIRMA_NO_PART);
    CHECK(of_scene.hit.hit.fraction == hit.hit.fraction && of_scene.sphere == hit.sphere);
    CHECK(of_scene.hit.hit.face == hit.hit.face);
    scene.to = 2;
    CHECK_OK(firma_cast_set_scene(&scene, kBar, 2, &motion, NULL, &of_scene));
    CHECK(of_scene.hit.hit.status == FIRMA_INVALID && of_scene.sphere == FIRMA_NO_SPHERE);
    CHECK_FAILS(firma_cast_set_scene(NULL, kBar, 2, &motion, NULL, &of_scene), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set_scene(&scene, kBar, 2, &motion, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set(room, kBar, 4097, &motion, NULL, &hit), FIRMA_ERROR_TOO_LARGE, "4096");
    CHECK_FAILS(firma_cast_set(room, NULL, 1, &motion, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set(room, kBar, 2, NULL, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set(room, kBar, 2, &motion, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set((firma_world){0}, kBar, 2, &motion, NULL, &hit), FIRMA_ERROR_BAD_HANDLE, "world");
}

static void test_pairs(void) {
    const double ball[4] = {0, 0, 0, 0.5};
    firma_motion bar = go(0, 0, 0, 3, 0), against = go(5, 0, 0, -3, 0);
    firma_set_pair_hit hit;
    CHECK_OK(firma_cast_set_pair(kBar, 2, &bar, ball, 1, &against, &hit));
    /* 3.25 m between them, 6 m in all. */
    CHECK(hit.status == FIRMA_HIT && fabs(hit.fraction - 3.25 / 6) < 1e-12 && hit.sphere_a == 1 && hit.sphere_b == 0);
    CHECK(fabs(hit.normal[0] + 1) < 1e-12 && fabs(hit.point[0] - (1.25 + 3 * hit.fraction)) < 1e-12);
    bar.path[0] = -3;
    CHECK_OK(firma_cast_set_pair(kBar, 2, &bar, ball, 1, &against, &hit));
    CHECK(hit.status == FIRMA_MISS && hit.fraction == 1 && hit.sphere_a == FIRMA_NO_SPHERE);
    CHECK(hit.sphere_b == FIRMA_NO_SPHERE);
    CHECK_OK(firma_cast_set_pair(kBar, 2, &bar, NULL, 0, &against, &hit));
    CHECK(hit.status == FIRMA_MISS);
    against.turn[2] = INFINITY;
    CHECK_OK(firma_cast_set_pair(kBar, 2, &bar, ball, 1, &against, &hit));
    CHECK(hit.status == FIRMA_INVALID && hit.fraction == 0);
    CHECK_FAILS(firma_cast_set_pair(kBar, 2, &bar, ball, 1, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set_pair(kBar, 2, &bar, ball, 1, &bar, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_set_pair(kBar, 5000, &bar, ball, 1, &bar, &hit), FIRMA_ERROR_TOO_LARGE, "4096");
}

/* A solid block of 2 x 1 x 1 m around the origin: its faces look outward. */
static firma_world make_block(void) {
    const double positions[] = {-1, -0.5, -0.5, 1, -0.5, -0.5, 1, 0.5, -0.5, -1, 0.5, -0.5,
                                -1, -0.5, 0.5,  1, -0.5, 0.5,  1, 0.5, 0.5,  -1, 0.5, 0.5};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8, .corners = corners};
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_world world = {0};
    CHECK_OK(firma_world_from_mesh(&mesh, "block", NULL, &world));
    return world;
}

static void test_fits(firma_world room) {
    const firma_world block = make_block();
    const firma_fit_options fit = {sizeof fit, 12, 0.01, 0};
    double spheres[4 * 12], error = 0;
    size_t count = 0;
    CHECK_OK(firma_world_fit_spheres(block, &fit, spheres, 12, &count, &error));
    CHECK(count == 12 && error > 0.01 && error < 0.4 && fabs(spheres[3] - 0.5) < 1e-3);
    for (size_t k = 0; k < count; ++k) {
        const double* s = &spheres[4 * k];
        CHECK(fabs(s[0]) + s[3] <= 1 + 1e-9 && fabs(s[1]) + s[3] <= 0.5 + 1e-9 && fabs(s[2]) + s[3] <= 0.5 + 1e-9);
        if (k > 0) CHECK(s[3] <= s[-1]);
    }
    /* As many as there is room for; and only counted. */
    double first[4] = {9, 9, 9, 9};
    size_t counted = 0;
    CHECK_OK(firma_world_fit_spheres(block, &fit, first, 1, &counted, NULL));
    CHECK(counted == 12 && memcmp(first, spheres, sizeof first) == 0);

    /* With the world's mass it is a body, which comes to rest on the floor. */
    firma_mass mass;
    firma_body_shape shape = {0};
    firma_bodies bodies = {0};
    firma_body_id id;
    const firma_pose pose = {{4, 4, 1}, {0, 0, 0, 1}, 1};
    CHECK_OK(firma_world_mass(block, 500, &mass));
    CHECK(fabs(mass.mass - 1000) < 1e-9);
    CHECK_OK(firma_body_shape_spheres(spheres, count, &mass, &shape));
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_bodies_add(bodies, shape, &pose, &id));
    for (int k = 0; k < 128; ++k) CHECK_OK(firma_bodies_step(bodies, room, 1.0 / 64, NULL, NULL));
    firma_body body = {.size = sizeof body};
    CHECK_OK(firma_bodies_get(bodies, id, &body));
    CHECK(fabs(body.position[2] - 0.5) < 0.01);
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_body_shape_release(shape));

    CHECK_FAILS(firma_world_fit_spheres(room, &fit, spheres, 12, &count, &error), FIRMA_ERROR_INVALID, "");
    const firma_fit_options too_many = {sizeof fit, 5000, 0, 0}, nan = {sizeof fit, 0, NAN, 0};
    CHECK_FAILS(firma_world_fit_spheres(block, &too_many, spheres, 12, &count, &error), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_world_fit_spheres(block, &nan, spheres, 12, &count, &error), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_world_fit_spheres(block, NULL, NULL, 1, &count, &error), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_fit_spheres(block, NULL, spheres, 12, NULL, &error), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_release(block));
    CHECK_FAILS(firma_world_fit_spheres(block, NULL, spheres, 12, &count, &error), FIRMA_ERROR_BAD_HANDLE, "world");
}

/* The nearest point of a level with a lift, as it goes. */
static void test_closest(firma_world room) {
    firma_part lift;
    firma_part_defaults(&lift);
    lift.world = make_block();
    lift.motion.position[0] = 4, lift.motion.position[1] = 4, lift.motion.position[2] = 1;
    lift.motion.path[2] = 2;
    firma_scene scene = {.size = sizeof scene, .world = room, .to = 1};
    CHECK_OK(firma_parts_create(&scene.parts));
    CHECK_OK(firma_parts_add(scene.parts, &lift, NULL));
    const double point[3] = {4, 4, 1.75}, corner[3] = {7.75, 4, 1.75};
    firma_part_near near;
    uint32_t found = 9;
    CHECK_OK(firma_closest_scene(&scene, point, INFINITY, 0, NULL, &near, &found));
    CHECK(found == 1 && near.part == 0 && fabs(near.near.distance - 0.25) < 1e-12 && near.near.point[2] == 1.5);
    CHECK(near.surface_velocity[2] == 2 && near.near.portal == FIRMA_NO_PORTAL);
    /* An eighth on it is there; at the end, up at the ceiling, its underside is 0.75 m above. */
    CHECK_OK(firma_closest_scene(&scene, point, INFINITY, 0.125, NULL, &near, &found));
    CHECK(found == 1 && near.part == 0 && fabs(near.near.distance) < 1e-12);
    CHECK_OK(firma_closest_scene(&scene, point, INFINITY, 1, NULL, &near, &found));
    CHECK(found == 1 && near.part == 0 && fabs(near.near.distance - 0.75) < 1e-12 && near.near.point[2] == 2.5);
    /* Near a wall it is the level's, as without parts. */
    CHECK_OK(firma_closest_scene(&scene, corner, INFINITY, 0, NULL, &near, &found));
    firma_near alone;
    CHECK_OK(firma_closest(room, corner, INFINITY, NULL, &alone, &found));
    CHECK(near.part == FIRMA_NO_PART && memcmp(&alone, &near.near, sizeof alone) == 0 && near.surface_velocity[2] == 0);
    found = 9;
    CHECK_OK(firma_closest_scene(&scene, point, 0.125, 0, NULL, &near, &found));
    CHECK(found == 0);

    CHECK_FAILS(firma_closest_scene(&scene, point, -1, 0, NULL, &near, &found), FIRMA_ERROR_OUT_OF_RANGE, "reach");
    CHECK_FAILS(firma_closest_scene(&scene, point, NAN, 0, NULL, &near, &found), FIRMA_ERROR_OUT_OF_RANGE, "reach");
    CHECK_FAILS(firma_closest_scene(&scene, point, 1, 1.5, NULL, &near, &found), FIRMA_ERROR_OUT_OF_RANGE, "fraction");
    CHECK_FAILS(firma_closest_scene(NULL, point, 1, 0, NULL, &near, &found), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_closest_scene(&scene, point, 1, 0, NULL, NULL, &found), FIRMA_ERROR_BAD_CALL, "null");
    firma_near_options elsewhere;
    firma_near_options_defaults(&elsewhere);
    elsewhere.room = 7;
    CHECK_FAILS(firma_closest_scene(&scene, point, 1, 0, &elsewhere, &near, &found), FIRMA_ERROR_INVALID, "room 7");
    scene.from = 2;
    CHECK_FAILS(firma_closest_scene(&scene, point, 1, 0, NULL, &near, &found), FIRMA_ERROR_OUT_OF_RANGE, "stretch");
    CHECK_OK(firma_parts_release(scene.parts));
    CHECK_FAILS(firma_closest_scene(&scene, point, 1, 0, NULL, &near, &found), FIRMA_ERROR_BAD_HANDLE, "parts");
    CHECK_OK(firma_world_release(lift.world));
}

void test_sphere_sets(void) {
    const size_t before = firma_live_handles();
    const firma_world room = make_room();
    test_against_a_world(room);
    test_bad_sets(room);
    test_pairs();
    test_fits(room);
    test_closest(room);
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}

/* SPDX-License-Identifier: MIT */
/* Casts at bodies: rays, spheres and sets at balls that stand or go on; an index outlives its bodies; bad arguments. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

static int is_near(double a, double b) {
    return fabs(a - b) < 1e-9;
}

static firma_body_id add_ball(firma_bodies bodies, double x, double y, double z) {
    const double sphere[4] = {0, 0, 0, 0.5};
    const firma_pose pose = {{x, y, z}, {0, 0, 0, 1}, 1};
    firma_mass mass;
    firma_body_shape shape = {0};
    firma_body_id id = {0, 0};
    CHECK_OK(firma_mass_of_ball(0.5, 1000, &mass));
    CHECK_OK(firma_body_shape_spheres(sphere, 1, &mass, &shape));
    CHECK_OK(firma_bodies_add(bodies, shape, &pose, &id));
    CHECK_OK(firma_body_shape_release(shape));
    return id;
}

/* A ball at x = 4 that rises at 3 m/s and spins at 2 rad/s, one behind it. */
struct two_balls {
    firma_bodies bodies;
    firma_body_id first, second;
};

static struct two_balls make_balls(void) {
    struct two_balls made = {{0}, {0, 0}, {0, 0}};
    CHECK_OK(firma_bodies_create(&made.bodies));
    made.first = add_ball(made.bodies, 4, 0, 0);
    made.second = add_ball(made.bodies, 6, 0, 0);
    firma_body body = {.size = sizeof body};
    CHECK_OK(firma_bodies_get(made.bodies, made.first, &body));
    body.velocity[2] = 3;
    body.spin[2] = 2;
    CHECK_OK(firma_bodies_set(made.bodies, made.first, &body));
    return made;
}

static void test_standing(const struct two_balls* balls) {
    firma_body_index index = {0};
    CHECK_OK(firma_body_index_create(balls->bodies, 0, &index));
    const firma_cast_input ray = {{0, 0, 0}, 0, {7, 0, 0}};
    firma_body_hit hit;
    CHECK_OK(firma_body_index_cast(index, &ray, NULL, &hit));
    CHECK(hit.status == FIRMA_HIT && is_near(hit.fraction, 0.5) && is_near(hit.normal[0], -1));
    CHECK(hit.body.slot == balls->first.slot && hit.body.use == balls->first.use);
    CHECK(hit.body_sphere == 0 && hit.sphere == 0 && is_near(hit.point[0], 3.5) && is_near(hit.centre[0], 3.5));
    CHECK(is_near(hit.safe_fraction, 0.5 - 0.001 / 7));
    /* Of the spin, half a metre from the axis, and of the velocity. */
    CHECK(is_near(hit.surface_velocity[1], -1) && is_near(hit.surface_velocity[2], 3));
    const firma_cast_input sphere = {{0, 0, 0}, 0.25, {6.5, 0, 0}};
    CHECK_OK(firma_body_index_cast(index, &sphere, NULL, &hit));
    CHECK(is_near(hit.fraction, 0.5) && is_near(hit.centre[0], 3.25) && is_near(hit.point[0], 3.5));

    /* Without the one in front, the one behind it. */
    firma_body_cast_options options;
    firma_body_cast_options_defaults(&options);
    CHECK(options.mask == UINT32_MAX && options.except.slot == FIRMA_NO_BODY && options.contact_offset == 0.001);
    options.contact_offset = 0.7;
    CHECK_OK(firma_body_index_cast(index, &ray, &options, &hit));
    CHECK(is_near(hit.fraction, 0.5) && is_near(hit.safe_fraction, 0.4));
    options.except = balls->first;
    CHECK_OK(firma_body_index_cast(index, &ray, &options, &hit));
    CHECK(hit.body.slot == balls->second.slot && is_near(hit.point[0], 5.5));
    const firma_body_cast_options masked = {.size = offsetof(firma_body_cast_options, except), .mask = 0};
    CHECK_OK(firma_body_index_cast(index, &ray, &masked, &hit));
    CHECK(hit.status == FIRMA_MISS && hit.fraction == 1 && hit.safe_fraction == 1 && hit.body.slot == FIRMA_NO_BODY);
    CHECK(hit.sphere == FIRMA_NO_SPHERE && hit.body_sphere == FIRMA_NO_SPHERE);

    /* A sphere beside it, and a far one that a half turn of the set brings to the ball's side. */
    const double set[8] = {0, 2, 0, 0.25, 0, 0.75, 0, 0.25};
    const firma_motion straight = {{0, 0, 0}, {0, 0, 0, 1}, {8, 0, 0}, {0, 0, 0}};
    CHECK_OK(firma_body_index_cast_set(index, set, 2, &straight, NULL, &hit));
    CHECK(hit.status == FIRMA_HIT && hit.sphere == 1 && is_near(hit.fraction, 0.5) && is_near(hit.normal[1], 1));
    const firma_motion turning = {{4, -1.5, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 3}};
    CHECK_OK(firma_body_index_cast_set(index, set, 1, &turning, NULL, &hit));
    CHECK(hit.status == FIRMA_INITIAL_OVERLAP && hit.fraction == 0);
    CHECK_OK(firma_body_index_cast_set(index, set, 0, &straight, NULL, &hit));
    CHECK(hit.status == FIRMA_MISS);
    CHECK_OK(firma_body_index_release(index));
}

/* The ball rises by 3 m in a second: a ray at that height meets it as it comes. */
static void test_moving(const struct two_balls* balls) {
    firma_body_index index = {0};
    CHECK_OK(firma_body_index_create(balls->bodies, 1, &index));
    const firma_cast_input waits = {{4, 0, 2}, 0, {0, 0, 0}};
    firma_body_hit hit;
    CHECK_OK(firma_body_index_cast(index, &waits, NULL, &hit));
    CHECK(hit.status == FIRMA_HIT && fabs(hit.fraction - 0.5) < 1e-4 && fabs(hit.normal[2] - 1) < 1e-4);

    /* It holds what it needs: bodies may go. */
    CHECK_OK(firma_bodies_remove(balls->bodies, balls->first));
    firma_body_hit again;
    CHECK_OK(firma_body_index_cast(index, &waits, NULL, &again));
    CHECK(memcmp(&hit, &again, sizeof hit) == 0);
    CHECK_OK(firma_bodies_release(balls->bodies));
    CHECK_OK(firma_body_index_cast(index, &waits, NULL, &again));
    CHECK(memcmp(&hit, &again, sizeof hit) == 0);
    CHECK_OK(firma_body_index_release(index));
    CHECK_FAILS(firma_body_index_cast(index, &waits, NULL, &again), FIRMA_ERROR_BAD_HANDLE, "body index");
    CHECK_FAILS(firma_body_index_create(balls->bodies, 0, &index), FIRMA_ERROR_BAD_HANDLE, "bodies");
}

static void test_bad_casts(const struct two_balls* balls) {
    firma_body_index index = {0};
    CHECK_FAILS(firma_body_index_create(balls->bodies, -1, &index), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    CHECK_FAILS(firma_body_index_create(balls->bodies, NAN, &index), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    CHECK_FAILS(firma_body_index_create(balls->bodies, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_body_index_create(balls->bodies, 0, &index));
    firma_body_hit hit;
    const firma_cast_input bad[3] = {
        {{NAN, 0, 0}, 0, {7, 0, 0}}, {{0, 0, 0}, -1, {7, 0, 0}}, {{0, 0, 0}, 0, {INFINITY, 0, 0}}};
    for (int k = 0; k < 3; ++k) {
        CHECK_OK(firma_body_index_cast(index, &bad[k], NULL, &hit));
        CHECK(hit.status == FIRMA_INVALID && hit.fraction == 0);
    }
    const double sphere[4] = {0, 0, 0, 0.25};
    firma_motion motion = {{0, 0, 0}, {0, 0, 0, 0}, {7, 0, 0}, {0, 0, 0}};
    CHECK_OK(firma_body_index_cast_set(index, sphere, 1, &motion, NULL, &hit));
    CHECK(hit.status == FIRMA_INVALID);
    motion.rotation[3] = 1;
    motion.turn[0] = 2e6;
    CHECK_OK(firma_body_index_cast_set(index, sphere, 1, &motion, NULL, &hit));
    CHECK(hit.status == FIRMA_INVALID);
    CHECK_FAILS(firma_body_index_cast(index, NULL, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_body_index_cast(index, &bad[0], NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_body_index_cast_set(index, NULL, 1, &motion, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_body_index_cast_set(index, sphere, 1, NULL, NULL, &hit), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_body_index_cast_set(index, sphere, 4097, &motion, NULL, &hit), FIRMA_ERROR_TOO_LARGE, "4096");
    const firma_body_cast_options unsized = {0};
    CHECK_FAILS(firma_body_index_cast(index, &bad[0], &unsized, &hit), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_OK(firma_body_index_release(index));
    CHECK_OK(firma_body_index_release((firma_body_index){0}));
}

void test_body_casts(void) {
    const size_t before = firma_live_handles();
    const struct two_balls balls = make_balls();
    test_standing(&balls);
    test_bad_casts(&balls);
    test_moving(&balls);
    CHECK(firma_live_handles() == before);
}

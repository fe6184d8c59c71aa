/* SPDX-License-Identifier: MIT */
/* Bodies: balls that fall, roll and come to rest, chunks that fall, snapshots; bad arguments and names that are gone.
 */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

static const double kTick = 1.0 / 64;

static firma_body_shape make_ball(double radius) {
    const double sphere[4] = {0, 0, 0, radius};
    firma_mass mass;
    firma_body_shape shape = {0};
    CHECK_OK(firma_mass_of_ball(radius, 1000, &mass));
    CHECK_OK(firma_body_shape_spheres(sphere, 1, &mass, &shape));
    return shape;
}

static firma_pose at(double x, double y, double z) {
    return (firma_pose){{x, y, z}, {0, 0, 0, 1}, 1};
}

static firma_body get(firma_bodies bodies, firma_body_id id) {
    firma_body body = {.size = sizeof body};
    CHECK_OK(firma_bodies_get(bodies, id, &body));
    return body;
}

static uint64_t hash_of_bodies(firma_bodies bodies) {
    uint64_t hash = 0;
    CHECK_OK(firma_bodies_hash(bodies, &hash));
    return hash;
}

static void step(firma_bodies bodies, firma_world room, int ticks) {
    for (int k = 0; k < ticks; ++k) CHECK_OK(firma_bodies_step(bodies, room, kTick, NULL, NULL));
}

static void test_masses(void) {
    firma_mass mass;
    const double half[3] = {1, 0.5, 0.25}, flat[3] = {1, 0, 1};
    CHECK_OK(firma_mass_of_box(half, 1000, &mass));
    CHECK(mass.volume == 1 && mass.mass == 1000 && fabs(mass.inertia[0] - 1000 * (0.25 + 0.0625) / 3) < 1e-9);
    CHECK(mass.inertia[1] == 0 && mass.centre[0] == 0);
    CHECK_OK(firma_mass_of_ball(0.5, 600, &mass));
    CHECK(fabs(mass.mass - 314.159265358979) < 1e-9 && fabs(mass.inertia[4] - mass.mass * 0.1) < 1e-9);
    CHECK_FAILS(firma_mass_of_ball(0, 1000, &mass), FIRMA_ERROR_OUT_OF_RANGE, "radius");
    CHECK_FAILS(firma_mass_of_ball(1, NAN, &mass), FIRMA_ERROR_OUT_OF_RANGE, "density");
    CHECK_FAILS(firma_mass_of_box(flat, 1000, &mass), FIRMA_ERROR_OUT_OF_RANGE, "side");
    CHECK_FAILS(firma_mass_of_box(NULL, 1000, &mass), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_mass_of_ball(1, 1, NULL), FIRMA_ERROR_BAD_CALL, "null");

    firma_body_shape shape = {0};
    const double spheres[8] = {0, 0, 0, 0.5, 1, 0, 0, -1};
    CHECK_FAILS(firma_body_shape_spheres(spheres, 2, &mass, &shape), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_body_shape_spheres(spheres, 0, &mass, &shape), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_body_shape_spheres(NULL, 1, &mass, &shape), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_body_shape_spheres(spheres, 1, NULL, &shape), FIRMA_ERROR_BAD_CALL, "null");
    mass.mass = NAN;
    CHECK_FAILS(firma_body_shape_spheres(spheres, 1, &mass, &shape), FIRMA_ERROR_INVALID, "");
    CHECK(shape.id == 0);
    CHECK_FAILS(firma_body_shape_release((firma_body_shape){12345}), FIRMA_ERROR_BAD_HANDLE, "body shape");
}

static void test_fall(firma_world room) {
    firma_bodies bodies = {0};
    CHECK_OK(firma_bodies_create(&bodies));
    const firma_body_shape ball = make_ball(0.5);
    firma_body_id first, second;
    const firma_pose high = at(4, 4, 3), low = at(2, 2, 0.5);
    CHECK_OK(firma_bodies_add(bodies, ball, &high, &first));
    CHECK_OK(firma_bodies_add(bodies, ball, &low, &second));
    CHECK_OK(firma_body_shape_release(ball));
    size_t count = 0;
    CHECK_OK(firma_bodies_get_count(bodies, &count));
    CHECK(count == 2 && first.slot != second.slot);
    firma_body body = get(bodies, first);
    CHECK(body.mask == UINT32_MAX && body.position[2] == 3 && body.rotation[3] == 1 && body.friction == 0.6);
    CHECK(body.restitution == 0.1 && body.rolling == 0.02 && fabs(body.mass - 523.598775598) < 1e-6 && !body.asleep);

    firma_step_report report = {.size = sizeof report};
    CHECK_OK(firma_bodies_step(bodies, room, kTick, NULL, &report));
    CHECK(report.awake == 2 && report.stuck == 0);
    body = get(bodies, first);
    CHECK(fabs(body.velocity[2] + 9.81 * kTick) < 1e-9 && body.position[2] < 3);

    /* A snapshot goes the same way. */
    firma_bodies copy = {0};
    CHECK_OK(firma_bodies_copy(bodies, &copy));
    CHECK(hash_of_bodies(copy) == hash_of_bodies(bodies));
    step(bodies, room, 100);
    CHECK(hash_of_bodies(copy) != hash_of_bodies(bodies));
    step(copy, room, 100);
    CHECK(hash_of_bodies(copy) == hash_of_bodies(bodies));
    body = get(bodies, first);
    CHECK(fabs(body.position[2] - 0.5) < 0.002);
    firma_body_contact contacts[4];
    CHECK_OK(firma_bodies_contacts(bodies, contacts, 4, &count));
    CHECK(count == 2 && contacts[0].body.slot == 0 && contacts[0].other.slot == FIRMA_NO_BODY);
    CHECK(contacts[0].normal[2] == 1 && contacts[0].face == 0 && contacts[0].portal == FIRMA_NO_PORTAL);
    CHECK(fabs(contacts[1].force / (body.mass * 9.81) - 1) < 0.05);
    CHECK_OK(firma_bodies_contacts(bodies, NULL, 0, &count));
    CHECK(count == 2);

    step(bodies, room, 64);
    CHECK(get(bodies, first).asleep == 1);
    CHECK_OK(firma_bodies_step(bodies, room, kTick, NULL, &report));
    CHECK(report.awake == 0);
    CHECK_OK(firma_bodies_wake(bodies, first));
    CHECK(get(bodies, first).asleep == 0);
    step(bodies, room, 128);

    /* A push wakes it, so does setting it; what a shorter struct lacks stays. */
    const double push[3] = {523.598775598, 0, 0};
    body = get(bodies, first);
    CHECK(body.asleep == 1);
    CHECK_OK(firma_bodies_push(bodies, first, push, body.position));
    body = get(bodies, first);
    CHECK(!body.asleep && fabs(body.velocity[0] - 1) < 1e-9);
    firma_body moved = {.size = offsetof(firma_body, velocity), .mask = 1, .position = {4, 4, 2}};
    moved.rotation[2] = 1;
    CHECK_OK(firma_bodies_set(bodies, first, &moved));
    body = get(bodies, first);
    CHECK(body.mask == 1 && body.position[2] == 2 && body.rotation[2] == 1 && fabs(body.velocity[0] - 1) < 1e-9);
    CHECK(body.friction == 0.6);
    firma_pose pose;
    CHECK_OK(firma_bodies_get_pose(bodies, first, &pose));
    CHECK(pose.position[2] == 2 && pose.scale == 1 && pose.rotation[2] == 1);

    /* Names: a slot that is used again has another one. */
    firma_body_id third = {0, 0}, ids[3];
    CHECK_OK(firma_bodies_remove(bodies, first));
    CHECK_FAILS(firma_bodies_remove(bodies, first), FIRMA_ERROR_INVALID, "no such body");
    CHECK_OK(firma_bodies_get_count(bodies, &count));
    CHECK(count == 1);
    firma_chunks nothing = {0};
    CHECK_FAILS(firma_bodies_add_chunk(bodies, nothing, 0, NULL, &third), FIRMA_ERROR_BAD_HANDLE, "chunks");
    const firma_body_shape small = make_ball(0.25);
    CHECK_OK(firma_bodies_add(bodies, small, &high, &third));
    CHECK_OK(firma_body_shape_release(small));
    CHECK(third.slot == first.slot && third.use != first.use);
    ids[2].slot = 77;
    CHECK_OK(firma_bodies_list(bodies, ids, 3, &count));
    CHECK(count == 2 && ids[0].slot == 0 && ids[0].use == third.use && ids[1].slot == second.slot && ids[2].slot == 77);
    body.size = sizeof body;
    const double zero[3] = {0, 0, 0};
    CHECK_FAILS(firma_bodies_get(bodies, first, &body), FIRMA_ERROR_INVALID, "no such body");
    CHECK_FAILS(firma_bodies_set(bodies, first, &body), FIRMA_ERROR_INVALID, "no such body");
    CHECK_FAILS(firma_bodies_wake(bodies, first), FIRMA_ERROR_INVALID, "no such body");
    CHECK_FAILS(firma_bodies_push(bodies, first, zero, zero), FIRMA_ERROR_INVALID, "no such body");
    CHECK_FAILS(firma_bodies_get_pose(bodies, first, &pose), FIRMA_ERROR_INVALID, "no such body");
    CHECK_FAILS(firma_bodies_wake(bodies, (firma_body_id){FIRMA_NO_BODY, 0}), FIRMA_ERROR_INVALID, "no such body");
    CHECK_FAILS(firma_bodies_wake(bodies, (firma_body_id){99, 1}), FIRMA_ERROR_INVALID, "no such body");
    CHECK_OK(firma_bodies_release(copy));
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_FAILS(firma_bodies_get_count(bodies, &count), FIRMA_ERROR_BAD_HANDLE, "list of bodies");
}

/* A column that hangs from the ceiling is cut through: what was below falls as a body. */
static void test_chunk(void) {
    const firma_world room = make_room();
    const firma_cutter column = make_box(3, 3, 1, 4, 4, 5), cut = make_box(2.5, 2.5, 2.25, 4.5, 4.5, 2.75);
    const firma_pose here = at(0, 0, 0);
    firma_carve_options options = {.size = sizeof options, .fill = 1};
    firma_carve_report report = {.size = sizeof report};
    firma_world hung = {0}, after = {0};
    CHECK_OK(firma_carve(room, column, &here, &options, &hung, &report));
    options = (firma_carve_options){.size = sizeof options, .chunks = 1, .density = 2000};
    CHECK_OK(firma_carve(hung, cut, &here, &options, &after, &report));
    size_t count = 0;
    CHECK_OK(firma_chunks_get_count(report.loose, &count));
    CHECK(count == 1);
    firma_bodies bodies = {0};
    CHECK_OK(firma_bodies_create(&bodies));
    firma_body_id id = {9, 9};
    firma_fit_options fit = {.size = sizeof fit, .max_spheres = 20};
    CHECK_OK(firma_bodies_add_chunk(bodies, report.loose, 0, &fit, &id));
    firma_body body = get(bodies, id);
    CHECK(fabs(body.mass - 2500) < 1e-6 && fabs(body.position[2] - 1.625) < 1e-9 && body.position[0] == 3.5);
    step(bodies, after, 64);
    body = get(bodies, id);
    CHECK(fabs(body.position[2] - 0.625) < 0.1);

    CHECK_FAILS(firma_bodies_add_chunk(bodies, report.loose, 1, &fit, &id), FIRMA_ERROR_OUT_OF_RANGE, "no such chunk");
    CHECK_FAILS(firma_bodies_add_chunk(bodies, report.loose, 0, &fit, NULL), FIRMA_ERROR_BAD_CALL, "null");
    fit.max_error = NAN;
    CHECK_FAILS(firma_bodies_add_chunk(bodies, report.loose, 0, &fit, &id), FIRMA_ERROR_INVALID, "");
    fit.size = 4;
    CHECK_FAILS(firma_bodies_add_chunk(bodies, report.loose, 0, &fit, &id), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_bodies_add_chunk((firma_bodies){0}, report.loose, 0, NULL, &id), FIRMA_ERROR_BAD_HANDLE,
                "bodies");
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_chunks_release(report.loose));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(hung));
    CHECK_OK(firma_world_release(room));
    CHECK_OK(firma_cutter_release(cut));
    CHECK_OK(firma_cutter_release(column));
}

static void test_bad(firma_world room) {
    firma_bodies bodies = {0};
    CHECK_OK(firma_bodies_create(&bodies));
    const firma_body_shape ball = make_ball(0.5);
    firma_body_id id = {7, 7};
    firma_pose pose = at(4, NAN, 3);
    CHECK_FAILS(firma_bodies_add(bodies, ball, &pose, &id), FIRMA_ERROR_OUT_OF_RANGE, "pose");
    pose = at(4, 4, 3);
    pose.rotation[3] = 0;
    CHECK_FAILS(firma_bodies_add(bodies, ball, &pose, &id), FIRMA_ERROR_OUT_OF_RANGE, "rotation");
    pose.rotation[3] = 1;
    CHECK_FAILS(firma_bodies_add(bodies, (firma_body_shape){bodies.id}, &pose, &id), FIRMA_ERROR_BAD_HANDLE, "shape");
    CHECK_FAILS(firma_bodies_add((firma_bodies){ball.id}, ball, &pose, &id), FIRMA_ERROR_BAD_HANDLE, "bodies");
    CHECK_FAILS(firma_bodies_add(bodies, ball, NULL, &id), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_add(bodies, ball, &pose, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(id.slot == 7 && id.use == 7);
    CHECK_OK(firma_bodies_add(bodies, ball, &pose, &id));
    const uint64_t before = hash_of_bodies(bodies);

    firma_body body = get(bodies, id);
    const firma_body good = body;
    double* const numbers[] = {&body.position[0], &body.velocity[1], &body.spin[2],     &body.force[0], &body.torque[1],
                               &body.rotation[0], &body.friction,    &body.restitution, &body.rolling};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k) {
        body = good;
        *numbers[k] = NAN;
        CHECK_FAILS(firma_bodies_set(bodies, id, &body), FIRMA_ERROR_OUT_OF_RANGE, "body");
    }
    body = good;
    body.restitution = 1.5;
    CHECK_FAILS(firma_bodies_set(bodies, id, &body), FIRMA_ERROR_OUT_OF_RANGE, "body");
    body.size = 5;
    CHECK_FAILS(firma_bodies_set(bodies, id, &body), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_bodies_get(bodies, id, &body), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_bodies_get(bodies, id, NULL), FIRMA_ERROR_BAD_CALL, "null");
    const double bad[3] = {0, INFINITY, 0}, zero[3] = {0, 0, 0};
    CHECK_FAILS(firma_bodies_push(bodies, id, bad, zero), FIRMA_ERROR_OUT_OF_RANGE, "impulse");
    CHECK_FAILS(firma_bodies_push(bodies, id, zero, bad), FIRMA_ERROR_OUT_OF_RANGE, "point");
    CHECK_FAILS(firma_bodies_push(bodies, id, NULL, zero), FIRMA_ERROR_BAD_CALL, "null");

    const double seconds[] = {0, -1, NAN, INFINITY};
    for (int k = 0; k < 4; ++k)
        CHECK_FAILS(firma_bodies_step(bodies, room, seconds[k], NULL, NULL), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    firma_step_options usual, options;
    firma_step_options_defaults(&usual);
    CHECK(usual.substeps_a_second == 240 && usual.max_bounces == 4 && usual.gravity[2] == -9.81);
    CHECK(usual.contact_friction == 0.6 && usual.sleep_speed == 0.05 && usual.sleep_after == 0.5);
    double* const rules[] = {&options.gravity[1], &options.contact_friction, &options.contact_offset,
                             &options.sleep_speed, &options.sleep_after};
    for (int k = 0; k < 5; ++k) {
        options = usual;
        *rules[k] = NAN;
        CHECK_FAILS(firma_bodies_step(bodies, room, kTick, &options, NULL), FIRMA_ERROR_OUT_OF_RANGE, "option");
    }
    options = usual;
    options.substeps_a_second = 0;
    CHECK_FAILS(firma_bodies_step(bodies, room, kTick, &options, NULL), FIRMA_ERROR_OUT_OF_RANGE, "option");
    options.substeps_a_second = UINT32_MAX;
    CHECK_FAILS(firma_bodies_step(bodies, room, kTick, &options, NULL), FIRMA_ERROR_OUT_OF_RANGE, "option");
    options.reserved = 1;
    CHECK_FAILS(firma_bodies_step(bodies, room, kTick, &options, NULL), FIRMA_ERROR_INVALID, "reserved");
    options.size = 4;
    CHECK_FAILS(firma_bodies_step(bodies, room, kTick, &options, NULL), FIRMA_ERROR_BAD_CALL, "size");
    firma_step_report report = {.size = 4};
    CHECK_FAILS(firma_bodies_step(bodies, room, kTick, NULL, &report), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_bodies_step(bodies, (firma_world){0}, kTick, NULL, NULL), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK_FAILS(firma_bodies_step((firma_bodies){0}, room, kTick, NULL, NULL), FIRMA_ERROR_BAD_HANDLE, "bodies");
    CHECK(hash_of_bodies(bodies) == before); /* nothing of it changed anything */

    /* Without gravity it stays. */
    options = usual;
    options.gravity[2] = 0;
    CHECK_OK(firma_bodies_step(bodies, room, kTick, &options, NULL));
    CHECK(get(bodies, id).position[2] == 3);

    size_t count = 0;
    CHECK_FAILS(firma_bodies_list(bodies, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_contacts(bodies, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_get_count(bodies, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_hash(bodies, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_copy(bodies, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_create(NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_body_shape_release(ball));
    CHECK_OK(firma_bodies_release(bodies));
}

/* A ball on a lift: carried up, with the part named in its contact; crushed under one that comes down on it. */
static void test_on_parts(firma_world room) {
    const double positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
    static const uint32_t corners[] = {3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3};
    static const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh = {.size = sizeof mesh, .positions = positions, .vertex_count = 8, .corners = corners};
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_part lift;
    firma_part_defaults(&lift);
    CHECK_OK(firma_world_from_mesh(&mesh, "lift", NULL, &lift.world));
    lift.motion.position[0] = lift.motion.position[1] = 4;
    firma_scene scene;
    firma_scene_defaults(&scene);
    scene.world = room;
    CHECK_OK(firma_parts_create(&scene.parts));
    CHECK_OK(firma_parts_add(scene.parts, &lift, NULL));

    firma_bodies bodies = {0};
    const firma_body_shape ball = make_ball(0.5);
    const firma_pose above = at(4, 4, 1.5);
    firma_body_id id;
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_bodies_add(bodies, ball, &above, &id));
    firma_step_report report = {.size = sizeof report};
    for (int k = 0; k < 64; ++k) {
        lift.motion.position[2] = k * kTick;
        lift.motion.path[2] = kTick;
        CHECK_OK(firma_parts_set_motions(scene.parts, &lift.motion, 1));
        CHECK_OK(firma_bodies_step_scene(bodies, &scene, kTick, NULL, &report));
        CHECK(report.crushed == 0);
    }
    CHECK(fabs(get(bodies, id).position[2] - 2.5) < 0.01 && get(bodies, id).crushed == 0);
    firma_body_contact contact;
    size_t count = 0;
    CHECK_OK(firma_bodies_contacts(bodies, &contact, 1, &count));
    CHECK(count == 1 && contact.part == 0 && contact.other.slot == FIRMA_NO_BODY && contact.normal[2] > 0.99);

    /* It comes down from above, and there is the floor. */
    firma_body low = get(bodies, id);
    low.position[2] = 0.5;
    CHECK_OK(firma_bodies_set(bodies, id, &low));
    uint64_t crushed = 0;
    for (int k = 0; k < 64; ++k) {
        lift.motion.position[2] = 1.25 - k * kTick;
        lift.motion.path[2] = -kTick;
        CHECK_OK(firma_parts_set_motions(scene.parts, &lift.motion, 1));
        CHECK_OK(firma_bodies_step_scene(bodies, &scene, kTick, NULL, &report));
        crushed += report.crushed;
        CHECK(report.crushed == get(bodies, id).crushed && get(bodies, id).position[2] > 0.498);
    }
    CHECK(crushed > 0);

    /* Without parts it is the other call, to the bit. */
    firma_bodies copy = {0};
    const firma_scene level = {.size = sizeof level, .world = room, .to = 1};
    CHECK_OK(firma_bodies_copy(bodies, &copy));
    step(bodies, room, 8);
    for (int k = 0; k < 8; ++k) CHECK_OK(firma_bodies_step_scene(copy, &level, kTick, NULL, NULL));
    CHECK(hash_of_bodies(bodies) == hash_of_bodies(copy));

    scene.to = 2;
    CHECK_FAILS(firma_bodies_step_scene(bodies, &scene, kTick, NULL, NULL), FIRMA_ERROR_OUT_OF_RANGE, "stretch");
    CHECK_FAILS(firma_bodies_step_scene(bodies, NULL, kTick, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_bodies_step_scene(bodies, &level, 0, NULL, NULL), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    CHECK_OK(firma_parts_release(scene.parts));
    CHECK_FAILS(firma_bodies_step_scene(bodies, &scene, kTick, NULL, NULL), FIRMA_ERROR_BAD_HANDLE, "parts");
    CHECK_OK(firma_bodies_release(copy));
    CHECK_OK(firma_body_shape_release(ball));
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_world_release(lift.world));
}

void test_bodies(void) {
    const size_t before = firma_live_handles();
    const firma_world room = make_room();
    test_masses();
    test_fall(room);
    test_chunk();
    test_on_parts(room);
    test_bad(room);
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}

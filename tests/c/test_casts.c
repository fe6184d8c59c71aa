/* SPDX-License-Identifier: MIT */
/* Casts one by one, in batches, over threads; and questions about points. */
#include <math.h>
#include <pthread.h>
#include <stdlib.h>

#include "tests/c/check.h"

enum { kThreads = 3, kCasts = 2000 };

struct share {
    size_t begin, count;
    void (*work)(void*, size_t);
    void* context;
};

static void* run_share(void* given) {
    const struct share* share = given;
    for (size_t k = share->begin; k < share->count; k += kThreads) share->work(share->context, k);
    return NULL;
}

static void run_on_threads(size_t count, void (*work)(void*, size_t), void* context, void* user) {
    ++*(int*)user;
    pthread_t threads[kThreads];
    struct share shares[kThreads];
    for (size_t t = 0; t < kThreads; ++t) {
        shares[t] = (struct share){t, count, work, context};
        pthread_create(&threads[t], NULL, run_share, &shares[t]);
    }
    for (size_t t = 0; t < kThreads; ++t) pthread_join(threads[t], NULL);
}

static void run_nothing(size_t count, void (*work)(void*, size_t), void* context, void* user) {
    (void)count, (void)work, (void)context, (void)user;
}

/* Each but the last, twice, and some that there are not. */
static void run_too_little(size_t count, void (*work)(void*, size_t), void* context, void* user) {
    (void)user;
    for (size_t k = 0; k + 1 < count; ++k) work(context, k), work(context, k);
    work(context, count);
    work(context, SIZE_MAX);
}

/* Each, and more. */
static void run_too_much(size_t count, void (*work)(void*, size_t), void* context, void* user) {
    run_too_little(count, work, context, user);
    work(context, count - 1);
}

static double between(uint32_t* seed, double low, double high) {
    *seed = *seed * 1664525u + 1013904223u;
    return low + (high - low) * (*seed >> 8) / 16777216.0;
}

static void test_one(firma_world room) {
    const firma_cast_input down = {{4, 4, 2}, 0.5, {0, 0, -4}};
    firma_hit hit;
    firma_cast_counts counts = {0};
    CHECK_OK(firma_cast(room, &down, NULL, &hit, &counts));
    CHECK(hit.status == FIRMA_HIT && hit.fraction == 0.375 && hit.face == 0 && hit.feature == FIRMA_FACE);
    CHECK(hit.normal[2] == 1 && hit.point[2] == 0 && hit.centre[2] == 0.5);
    CHECK(hit.safe_fraction < hit.fraction && hit.safe_fraction > 0.374);
    CHECK(hit.portal == FIRMA_NO_PORTAL);
    firma_hit_info info = {.size = sizeof info};
    CHECK_OK(firma_world_hit_info(room, &hit, &info));
    CHECK(info.room == 0 && info.source == 0 && info.source_edit == 0 && info.flags == FIRMA_FACE_SOLID);
    CHECK(info.mask == UINT32_MAX && info.other_face == FIRMA_NO_FACE);
    firma_hit stale = hit;
    stale.face = 1000;
    CHECK_FAILS(firma_world_hit_info(room, &stale, &info), FIRMA_ERROR_INVALID, "no such face");
    stale = hit;
    stale.corner[1] += 1;
    CHECK_FAILS(firma_world_hit_info(room, &stale, &info), FIRMA_ERROR_INVALID, "no such face");
    stale.portal = 0;
    CHECK_FAILS(firma_world_hit_info(room, &stale, &info), FIRMA_ERROR_INVALID, "no such portal");
    info.size = 4;
    CHECK_FAILS(firma_world_hit_info(room, &hit, &info), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_world_hit_info(room, NULL, &info), FIRMA_ERROR_BAD_CALL, "null");
    info.size = sizeof info;
    CHECK(counts.nodes > 0 && counts.faces > 0);
    uint32_t status = 9;
    CHECK_OK(firma_cast_any(room, &down, NULL, &status));
    CHECK(status == FIRMA_HIT);

    const firma_cast_input bad = {{NAN, 0, 0}, 0.5, {0, 0, -4}};
    CHECK_OK(firma_cast(room, &bad, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_INVALID && hit.face == FIRMA_NO_FACE && hit.fraction == 0 && hit.safe_fraction == 0);
    const firma_cast_input short_one = {{4, 4, 2}, 0.5, {0, 0, -1}};
    CHECK_OK(firma_cast(room, &short_one, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_MISS && hit.fraction == 1 && hit.safe_fraction == 1 && hit.centre[2] == 1);
    CHECK_FAILS(firma_world_hit_info(room, &hit, &info), FIRMA_ERROR_INVALID, "a miss");

    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.contact_offset = 0.5;
    CHECK_OK(firma_cast(room, &down, &options, &hit, NULL));
    CHECK(hit.safe_fraction == 0.25);
    options.mask = 0;
    CHECK_OK(firma_cast(room, &down, &options, &hit, NULL));
    CHECK(hit.status == FIRMA_MISS);
    options.sides = 7;
    CHECK_FAILS(firma_cast(room, &down, &options, &hit, NULL), FIRMA_ERROR_INVALID, "sides");
    firma_cast_options_defaults(&options);
    options.contact_offset = NAN;
    CHECK_FAILS(firma_cast(room, &down, &options, &hit, NULL), FIRMA_ERROR_INVALID, "contact offset");
    options.size = 0;
    CHECK_FAILS(firma_cast(room, &down, &options, &hit, NULL), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_cast(room, NULL, NULL, &hit, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast(room, &down, NULL, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

static void test_all(firma_world room) {
    const firma_cast_input through = {{4, 4, 2}, 0, {0, 0, -4}};
    firma_cast_options both;
    firma_cast_options_defaults(&both);
    both.sides = 1;
    const firma_cast_input long_one = {{4, 4, -1}, 0, {0, 0, 6}};
    firma_hit hits[4];
    size_t count = 0;
    CHECK_OK(firma_cast_all(room, &through, NULL, hits, 4, &count));
    CHECK(count == 1 && hits[0].face == 0);
    CHECK_OK(firma_cast_all(room, &long_one, &both, hits, 4, &count));
    CHECK(count == 2 && hits[0].face == 0 && hits[1].face == 1 && hits[0].fraction < hits[1].fraction);
    hits[1].face = 1234;
    CHECK_OK(firma_cast_all(room, &long_one, &both, hits, 1, &count));
    CHECK(count == 2 && hits[1].face == 1234);
    CHECK_OK(firma_cast_all(room, &long_one, &both, NULL, 0, &count));
    CHECK(count == 2);
    const firma_cast_input bad = {{0, 0, 0}, -1, {0, 0, 6}};
    CHECK_FAILS(firma_cast_all(room, &bad, NULL, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "radius");
    CHECK_FAILS(firma_cast_all(room, &through, NULL, NULL, 3, &count), FIRMA_ERROR_BAD_CALL, "null");
}

/* Open ground of 2 * kSquares^2 triangles. */
enum { kSquares = 80 };

static uint64_t hash_of_ground(firma_code* code) {
    double* positions = calloc((kSquares + 1) * (kSquares + 1) * 3, sizeof *positions);
    uint32_t* corners = calloc(kSquares * kSquares * 6, sizeof *corners);
    uint32_t seed = 7, *corner = corners;
    for (uint32_t k = 0; k < (kSquares + 1) * (kSquares + 1); ++k) {
        positions[3 * k] = k % (kSquares + 1);
        positions[3 * k + 1] = k / (kSquares + 1);
        positions[3 * k + 2] = between(&seed, 0, 1);
    }
    for (uint32_t k = 0; k < kSquares * kSquares; ++k) {
        const uint32_t at = k / kSquares * (kSquares + 1) + k % kSquares;
        const uint32_t of_square[6] = {at, at + 1, at + kSquares + 2, at, at + kSquares + 2, at + kSquares + 1};
        memcpy(corner, of_square, sizeof of_square);
        corner += 6;
    }
    firma_mesh mesh = {0};
    mesh.size = sizeof mesh;
    mesh.positions = positions;
    mesh.vertex_count = (kSquares + 1) * (kSquares + 1);
    mesh.corners = corners;
    mesh.face_count = 2 * kSquares * kSquares;
    firma_world ground = {0};
    uint64_t hash = 0;
    *code = firma_world_from_mesh(&mesh, "ground", NULL, &ground);
    if (*code == FIRMA_OK) {
        CHECK_OK(firma_world_hash(ground, &hash));
        CHECK_OK(firma_world_release(ground));
    }
    free(positions);
    free(corners);
    return hash;
}

static void test_worlds_on_threads(void) {
    firma_code code = FIRMA_OK;
    const uint64_t alone = hash_of_ground(&code);
    CHECK(code == FIRMA_OK && alone != 0);
    int runs = 0;
    const firma_tasks tasks = {sizeof tasks, run_on_threads, &runs}, lazy = {sizeof lazy, run_nothing, NULL};
    CHECK_OK(firma_set_tasks(&tasks));
    CHECK(hash_of_ground(&code) == alone && code == FIRMA_OK && runs > 2);
    CHECK_OK(firma_set_tasks(&lazy));
    hash_of_ground(&code);
    CHECK(code == FIRMA_ERROR_INVALID && strstr(firma_error_message(), "Tasks::run"));
    CHECK_OK(firma_set_tasks(NULL));
}

static void test_batch(firma_world room) {
    firma_cast_input* inputs = calloc(kCasts, sizeof *inputs);
    firma_hit* hits = calloc(kCasts, sizeof *hits);
    uint32_t seed = 1;
    for (int k = 0; k < kCasts; ++k) {
        for (int axis = 0; axis < 3; ++axis) inputs[k].centre[axis] = between(&seed, 1, 3);
        inputs[k].radius = k % 2 ? between(&seed, 0.1, 0.5) : 0;
        for (int axis = 0; axis < 3; ++axis) inputs[k].path[axis] = between(&seed, -9, 9);
    }
    firma_cast_counts alone = {0}, batched = {0}, threaded = {0};
    CHECK_OK(firma_cast_batch(room, inputs, kCasts, NULL, hits, &batched));
    for (int k = 0; k < kCasts; ++k) {
        firma_hit hit;
        memset(&hit, 0, sizeof hit);
        CHECK_OK(firma_cast(room, &inputs[k], NULL, &hit, &alone));
        CHECK(memcmp(&hit, &hits[k], sizeof hit) == 0);
    }
    CHECK(alone.nodes == batched.nodes && alone.boxes == batched.boxes && alone.faces == batched.faces);

    int runs = 0;
    const firma_tasks tasks = {sizeof tasks, run_on_threads, &runs};
    CHECK_OK(firma_set_tasks(&tasks));
    firma_hit* again = calloc(kCasts, sizeof *again);
    CHECK_OK(firma_cast_batch(room, inputs, kCasts, NULL, again, &threaded));
    CHECK(runs == 1 && memcmp(again, hits, kCasts * sizeof *hits) == 0 && threaded.nodes == batched.nodes);
    /* Finding 12 (F12): a callback that runs nothing gave OK with hits unwritten. */
    const firma_tasks lazy[] = {{sizeof tasks, run_nothing, NULL}, {sizeof tasks, run_too_little, NULL}};
    for (int t = 0; t < 2; ++t) {
        CHECK_OK(firma_set_tasks(&lazy[t]));
        memset(again, 0x55, kCasts * sizeof *again);
        CHECK_FAILS(firma_cast_batch(room, inputs, kCasts, NULL, again, &threaded), FIRMA_ERROR_BAD_CALL, "run");
        int written = 0;
        for (int k = 0; k < kCasts; ++k) written += again[k].status == FIRMA_INVALID && again[k].fraction == 0;
        CHECK(written == kCasts && threaded.nodes == batched.nodes);
    }
    const firma_tasks eager = {sizeof eager, run_too_much, NULL};
    CHECK_OK(firma_set_tasks(&eager));
    CHECK_OK(firma_cast_batch(room, inputs, kCasts, NULL, again, NULL));
    CHECK(memcmp(again, hits, kCasts * sizeof *hits) == 0);
    CHECK_OK(firma_set_tasks(NULL));
    CHECK_OK(firma_cast_batch(room, NULL, 0, NULL, NULL, NULL));
    CHECK_FAILS(firma_cast_batch(room, inputs, kCasts, NULL, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    free(inputs);
    free(hits);
    free(again);
}

static void test_points(firma_world room) {
    const double middle[3] = {4, 4, 2}, rock[3] = {4, 4, -1}, on_floor[3] = {4, 4, 0}, near_corner[3] = {0.1, 0.1, 0.1};
    const double bad[3] = {0, INFINITY, 0};
    uint32_t where = 9, found = 9;
    uint32_t in = 9;
    CHECK_OK(firma_world_locate(room, middle, &where, &in));
    CHECK(where == FIRMA_AIR && in == 0);
    CHECK_OK(firma_world_locate(room, rock, &where, &in));
    CHECK(where == FIRMA_SOLID && in == FIRMA_NO_ROOM);
    CHECK_OK(firma_world_locate(room, on_floor, &where, NULL));
    CHECK(where == FIRMA_SURFACE);
    CHECK_FAILS(firma_world_locate(room, bad, &where, NULL), FIRMA_ERROR_OUT_OF_RANGE, "finite");
    firma_near near[6];
    CHECK_OK(firma_closest(room, middle, INFINITY, NULL, near, &found));
    CHECK(found == 1 && near[0].distance == 2 && near[0].face == 0);
    CHECK_OK(firma_closest(room, middle, 1, NULL, near, &found));
    CHECK(found == 0);
    CHECK_FAILS(firma_closest(room, middle, -1, NULL, near, &found), FIRMA_ERROR_OUT_OF_RANGE, "reach");
    const double far_off[3] = {1e200, 0, 0}; /* no number to compute with: not the same as nothing found */
    CHECK_FAILS(firma_closest(room, far_off, INFINITY, NULL, near, &found), FIRMA_ERROR_OUT_OF_RANGE, "too large");
    CHECK_FAILS(firma_world_locate(room, far_off, &where, NULL), FIRMA_ERROR_OUT_OF_RANGE, "too large");
    size_t count = 0;
    CHECK_OK(firma_overlap(room, near_corner, 0.2, NULL, near, 6, &count));
    CHECK(count == 3 && near[0].face < near[1].face && near[1].face < near[2].face);
    for (int k = 0; k < 3; ++k) {
        CHECK(near[k].depth == 0.2 - 0.1 && near[k].distance == 0.1);
        CHECK(near[k].direction[0] + near[k].direction[1] + near[k].direction[2] == 1);
    }
    firma_near_options some;
    firma_near_options_defaults(&some);
    some.mask = 0;
    CHECK_OK(firma_overlap(room, near_corner, 0.2, &some, near, 6, &count));
    CHECK(count == 0);
    some.mask = UINT32_MAX;
    some.room = 0;
    CHECK_OK(firma_overlap(room, near_corner, 0.2, &some, NULL, 0, &count));
    CHECK(count == 3);
    some.room = 7;
    CHECK_FAILS(firma_overlap(room, near_corner, 0.2, &some, near, 6, &count), FIRMA_ERROR_INVALID, "no room 7");
    CHECK_FAILS(firma_closest(room, middle, 1, &some, near, &found), FIRMA_ERROR_INVALID, "no room 7");
    some.room = FIRMA_LOCATE_ROOM; /* for casts alone */
    CHECK_FAILS(firma_closest(room, middle, 1, &some, near, &found), FIRMA_ERROR_INVALID, "no room");
    some.size = 4;
    CHECK_FAILS(firma_closest(room, middle, 1, &some, near, &found), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_overlap(room, bad, 0.2, NULL, near, 6, &count), FIRMA_ERROR_OUT_OF_RANGE, "finite");
}

void test_casts(void) {
    const firma_world room = make_room();
    test_one(room);
    test_all(room);
    test_batch(room);
    test_worlds_on_threads();
    test_points(room);
    CHECK_OK(firma_world_release(room));
}

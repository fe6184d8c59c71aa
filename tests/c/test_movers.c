/* SPDX-License-Identifier: MIT */
/* Capsules, boxes and hulls: made, cast, overlapped; where they touch; and many casts at once. */
#include <math.h>
#include <pthread.h>
#include <stddef.h>
#include <stdlib.h>

#include "tests/c/check.h"

enum { kMany = 3000, kWorkers = 3 };

static double some(uint32_t* seed, double low, double high) {
    *seed = *seed * 1664525u + 1013904223u;
    return low + (high - low) * (*seed >> 8) / 16777216.0;
}

static firma_hull unit_box(void) {
    const double half[3] = {0.5, 0.5, 0.5};
    firma_hull box = {0};
    CHECK_OK(firma_hull_box(half, NULL, &box));
    return box;
}

static firma_mover hull_at(firma_hull hull, double x, double y, double z) {
    return (firma_mover){.size = sizeof(firma_mover), .kind = FIRMA_MOVER_HULL, .at = {x, y, z}, .hull = hull};
}

static firma_mover capsule_at(double x, double y, double low, double high, double radius) {
    return (firma_mover){.size = sizeof(firma_mover),
                         .kind = FIRMA_MOVER_CAPSULE,
                         .at = {x, y, low},
                         .to = {x, y, high},
                         .radius = radius};
}

static void test_hulls(void) {
    const size_t before = firma_live_handles();
    const firma_hull box = unit_box();
    double corners[64 * 3];
    size_t count = 0;
    CHECK_OK(firma_hull_corners(box, corners, 64, &count));
    CHECK(count == 8);
    for (size_t k = 0; k < 24; ++k) CHECK(fabs(corners[k]) == 0.5);
    corners[3] = 7;
    CHECK_OK(firma_hull_corners(box, corners, 1, &count));
    CHECK(count == 8 && corners[3] == 7);
    CHECK_OK(firma_hull_corners(box, NULL, 0, &count));
    CHECK_FAILS(firma_hull_corners(box, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");

    /* A pyramid, with a point within that it does not need. */
    double points[65 * 3] = {0, 0, 1, 1, 1, -1, -1, 1, -1, -1, -1, -1, 1, -1, -1, 0, 0, 0};
    firma_hull pyramid = {0};
    CHECK_OK(firma_hull_from_points(points, 6, &pyramid));
    CHECK_OK(firma_hull_corners(pyramid, corners, 64, &count));
    CHECK(count == 5);

    firma_hull none = {0};
    const double turned[9] = {0, 1, 0, -1, 0, 0, 0, 0, 1}, half[3] = {1, 2, 3};
    firma_hull other = {0};
    CHECK_OK(firma_hull_box(half, turned, &other));
    CHECK_OK(firma_hull_corners(other, corners, 64, &count));
    CHECK(fabs(corners[0]) == 2 && fabs(corners[1]) == 1 && fabs(corners[2]) == 3);
    CHECK_FAILS(firma_hull_from_points(points, 3, &none), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_hull_from_points(points, 65, &none), FIRMA_ERROR_TOO_LARGE, "64");
    CHECK_FAILS(firma_hull_from_points(NULL, 4, &none), FIRMA_ERROR_BAD_CALL, "null");
    points[4] = NAN;
    CHECK_FAILS(firma_hull_from_points(points, 6, &none), FIRMA_ERROR_OUT_OF_RANGE, "1");
    const double flat[3] = {1, 1, 0};
    CHECK_FAILS(firma_hull_box(flat, NULL, &none), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_hull_box(NULL, NULL, &none), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(none.id == 0);

    CHECK_OK(firma_hull_release(other));
    CHECK_OK(firma_hull_release(pyramid));
    CHECK_OK(firma_hull_release(box));
    CHECK_OK(firma_hull_release(none));
    CHECK_FAILS(firma_hull_release(box), FIRMA_ERROR_BAD_HANDLE, "hull");
    CHECK_FAILS(firma_hull_corners(box, NULL, 0, &count), FIRMA_ERROR_BAD_HANDLE, "hull");
    CHECK(firma_live_handles() == before);
}

static void test_one(firma_world room) {
    const firma_hull box = unit_box();
    const double down[3] = {0, 0, -4};
    const firma_mover crate = hull_at(box, 4, 4, 2), pill = capsule_at(4, 4, 2, 3, 0.5);
    firma_hit hit;
    firma_cast_counts counts = {0};
    CHECK_OK(firma_cast_mover(room, &crate, down, NULL, &hit, &counts));
    CHECK(hit.status == FIRMA_HIT && hit.fraction == 0.375 && hit.face == 0 && hit.feature == FIRMA_FACE);
    CHECK(hit.normal[2] == 1 && hit.point[2] == 0 && hit.centre[2] == 0.5 && counts.faces > 0);

    double points[12];
    uint32_t touching = 9;
    CHECK_OK(firma_contact_points(room, box, &hit, points, &touching));
    CHECK(touching == 4);
    for (uint32_t k = 0; k < touching; ++k) {
        CHECK(points[3 * k + 2] == 0);
        for (int axis = 0; axis < 2; ++axis) CHECK(fabs(points[3 * k + axis] - 4) == 0.5);
    }
    firma_hit stale = hit;
    stale.face = 1000;
    CHECK_FAILS(firma_contact_points(room, box, &stale, points, &touching), FIRMA_ERROR_INVALID, "no such face");
    stale.portal = 3;
    CHECK_FAILS(firma_contact_points(room, box, &stale, points, &touching), FIRMA_ERROR_INVALID, "no such portal");
    const firma_hull none = {0};
    CHECK_FAILS(firma_contact_points(room, none, &hit, points, &touching), FIRMA_ERROR_BAD_HANDLE, "hull");
    CHECK_FAILS(firma_contact_points(room, box, NULL, points, &touching), FIRMA_ERROR_BAD_CALL, "null");

    CHECK_OK(firma_cast_mover(room, &pill, down, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_HIT && hit.fraction == 0.375 && hit.centre[2] == 1 && hit.point[2] == 0);
    const double away[3] = {0, 0, 0.25};
    CHECK_OK(firma_cast_mover(room, &pill, away, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_MISS && hit.fraction == 1 && hit.centre[2] == 2.75);
    CHECK_OK(firma_contact_points(room, box, &hit, points, &touching));
    CHECK(touching == 0);
    uint32_t status = 9;
    CHECK_OK(firma_cast_mover_any(room, &pill, down, NULL, &status));
    CHECK(status == FIRMA_HIT);
    CHECK_OK(firma_cast_mover_any(room, &crate, away, NULL, &status));
    CHECK(status == FIRMA_MISS);

    /* A sphere is the same by either function. */
    const firma_cast_input ball = {{4.1, 3.7, 2}, 0.5, {0.3, -0.2, -4}};
    const firma_mover same = {.size = sizeof same, .at = {4.1, 3.7, 2}, .radius = 0.5};
    firma_hit by_input, by_mover;
    memset(&by_input, 0, sizeof by_input);
    memset(&by_mover, 0, sizeof by_mover);
    CHECK_OK(firma_cast(room, &ball, NULL, &by_input, NULL));
    CHECK_OK(firma_cast_mover(room, &same, ball.path, NULL, &by_mover, NULL));
    CHECK(memcmp(&by_input, &by_mover, sizeof by_input) == 0 && by_input.status == FIRMA_HIT);

    uint32_t passed = 9, rooms[1] = {9};
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.passed = rooms;
    options.passed_capacity = 1;
    options.passed_count = &passed;
    CHECK_OK(firma_cast_mover(room, &crate, down, &options, &hit, NULL));
    CHECK(passed == 1 && rooms[0] == 0);
    CHECK_OK(firma_hull_release(box));
}

static void test_bad(firma_world room) {
    const firma_hull box = unit_box();
    const double down[3] = {0, 0, -4}, nowhere[3] = {0, NAN, 0};
    const firma_mover crate = hull_at(box, 4, 4, 2);
    firma_hit hit;
    size_t count = 0;
    uint32_t status = 9;
    CHECK_OK(firma_cast_mover(room, &crate, nowhere, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_INVALID && hit.fraction == 0 && hit.face == FIRMA_NO_FACE);
    CHECK_OK(firma_cast_mover_any(room, &crate, nowhere, NULL, &status));
    CHECK(status == FIRMA_INVALID);
    CHECK_FAILS(firma_cast_mover_all(room, &crate, nowhere, NULL, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "finite");
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.room = 7;
    CHECK_FAILS(firma_cast_mover_all(room, &crate, down, &options, NULL, 0, &count), FIRMA_ERROR_INVALID, "no room 7");
    options.sides = 2;
    CHECK_FAILS(firma_cast_mover(room, &crate, down, &options, &hit, NULL), FIRMA_ERROR_INVALID, "sides");

    firma_mover bad = capsule_at(4, 4, 2, 3, -1);
    CHECK_OK(firma_cast_mover(room, &bad, down, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_INVALID);
    CHECK_FAILS(firma_overlap_mover(room, &bad, NULL, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "radius");
    bad.kind = 3;
    CHECK_FAILS(firma_cast_mover(room, &bad, down, NULL, &hit, NULL), FIRMA_ERROR_INVALID, "kind 3");
    bad.size = 4;
    CHECK_FAILS(firma_cast_mover(room, &bad, down, NULL, &hit, NULL), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_cast_mover(room, NULL, down, NULL, &hit, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_mover(room, &crate, NULL, NULL, &hit, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_mover(room, &crate, down, NULL, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_mover_all(room, &crate, down, NULL, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");

    /* A shorter one, of a header that had spheres alone, has no radius: a particle. */
    firma_mover short_one = {.size = offsetof(firma_mover, radius), .at = {4, 4, 2}, .radius = 1};
    CHECK_OK(firma_cast_mover(room, &short_one, down, NULL, &hit, NULL));
    CHECK(hit.fraction == 0.5);

    CHECK_OK(firma_hull_release(box));
    CHECK_FAILS(firma_cast_mover(room, &crate, down, NULL, &hit, NULL), FIRMA_ERROR_BAD_HANDLE, "hull");
    CHECK_FAILS(firma_overlap_mover(room, &crate, NULL, NULL, 0, &count), FIRMA_ERROR_BAD_HANDLE, "hull");
}

struct seen_hits {
    size_t count;
    firma_world world; /* released by the visitor, where it is not 0 */
    firma_hull hull;
};

static double see_hit(const firma_hit* hit, void* user) {
    struct seen_hits* seen = user;
    CHECK(hit->status == FIRMA_HIT);
    ++seen->count;
    CHECK_OK(firma_world_release(seen->world));
    CHECK_OK(firma_hull_release(seen->hull));
    seen->world.id = seen->hull.id = 0;
    return 1;
}

static uint32_t see_overlap(const firma_near* found, void* user) {
    CHECK(found->depth > 0);
    return ++*(size_t*)user < 2;
}

static void test_lists(firma_world room) {
    const firma_hull box = unit_box();
    const double through[3] = {0, 0, -8};
    const firma_mover crate = hull_at(box, 4, 4, 6), pill = capsule_at(4, 4, 6, 7, 0.5);
    firma_cast_options both;
    firma_cast_options_defaults(&both);
    both.sides = 1;
    firma_hit hits[4];
    size_t count = 0;
    for (int k = 0; k < 2; ++k) {
        CHECK_OK(firma_cast_mover_all(room, k ? &crate : &pill, through, &both, hits, 4, &count));
        CHECK(count == 2 && hits[0].face == 1 && hits[1].face == 0 && hits[0].fraction == 1.5 / 8);
        CHECK_OK(firma_cast_mover_all(room, k ? &crate : &pill, through, NULL, hits, 4, &count));
        CHECK(count == 1 && hits[0].face == 0);
    }
    struct seen_hits seen = {0, {0}, unit_box()};
    CHECK_OK(firma_world_copy(room, &seen.world));
    const firma_mover dropped = hull_at(seen.hull, 4, 4, 6);
    uint32_t status = 9;
    CHECK_OK(firma_cast_mover_each(seen.world, &dropped, through, &both, see_hit, &seen, &status));
    CHECK(status == FIRMA_HIT && seen.count == 2);

    /* A crate that stands 1/4 m deep in the floor, in a corner 1/8 m deep in two walls. */
    const firma_mover sunk = hull_at(box, 0.375, 0.375, 0.25), lain = capsule_at(0.375, 0.375, 0.25, 1.25, 0.5);
    firma_near near[4];
    for (int k = 0; k < 2; ++k) {
        CHECK_OK(firma_overlap_mover(room, k ? &sunk : &lain, NULL, near, 4, &count));
        CHECK(count == 3 && near[0].face == 0 && fabs(near[0].depth - 0.25) < 1e-12 && near[0].direction[2] == 1);
        CHECK(fabs(near[1].depth - 0.125) < 1e-12 && fabs(near[2].depth - 0.125) < 1e-12);
        size_t shown = 0;
        uint32_t found = 9;
        CHECK_OK(firma_overlap_mover_each(room, k ? &sunk : &lain, NULL, see_overlap, &shown, &found));
        CHECK(shown == 2 && found == 1);
    }
    firma_near_options elsewhere;
    firma_near_options_defaults(&elsewhere);
    elsewhere.room = 9;
    CHECK_FAILS(firma_overlap_mover(room, &sunk, &elsewhere, near, 4, &count), FIRMA_ERROR_INVALID, "no room 9");
    CHECK_OK(firma_hull_release(box));
}

/* ---- many ------------------------------------------------------------------------------------------------------- */

struct row {
    double at[3], to[3], radius, path[3];
};

struct answers {
    firma_hit hits[kMany];
    uint32_t status[kMany], face[kMany], portal[kMany], material[kMany];
    double fraction[kMany], safe[kMany], nx[kMany], ny[kMany], nz[kMany];
};

static struct row rows[kMany];
static uint32_t hull_of[kMany];
static struct answers one_by_one, together;

static firma_casts casts_of_rows(uint32_t kind, const firma_hull* hulls, size_t hull_count) {
    return (firma_casts){.size = sizeof(firma_casts),
                         .kind = kind,
                         .count = kMany,
                         .stride = sizeof(struct row),
                         .x = &rows[0].at[0],
                         .y = &rows[0].at[1],
                         .z = &rows[0].at[2],
                         .path_x = &rows[0].path[0],
                         .path_y = &rows[0].path[1],
                         .path_z = &rows[0].path[2],
                         .to_x = &rows[0].to[0],
                         .to_y = &rows[0].to[1],
                         .to_z = &rows[0].to[2],
                         .radius = &rows[0].radius,
                         .hulls = hulls,
                         .hull_count = hull_count,
                         .hull_of = hull_of};
}

static firma_answers all_of(struct answers* to) {
    return (firma_answers){.size = sizeof(firma_answers),
                           .hits = to->hits,
                           .status = to->status,
                           .fraction = to->fraction,
                           .safe_fraction = to->safe,
                           .normal_x = to->nx,
                           .normal_y = to->ny,
                           .normal_z = to->nz,
                           .face = to->face,
                           .portal = to->portal,
                           .material = to->material};
}

struct part {
    size_t begin, count;
    void (*work)(void*, size_t);
    void* context;
};

static void* run_part(void* given) {
    const struct part* part = given;
    for (size_t k = part->begin; k < part->count; k += kWorkers) part->work(part->context, k);
    return NULL;
}

static void on_threads(size_t count, void (*work)(void*, size_t), void* context, void* user) {
    (void)user;
    pthread_t threads[kWorkers];
    struct part parts[kWorkers];
    for (size_t t = 0; t < kWorkers; ++t) {
        parts[t] = (struct part){t, count, work, context};
        pthread_create(&threads[t], NULL, run_part, &parts[t]);
    }
    for (size_t t = 0; t < kWorkers; ++t) pthread_join(threads[t], NULL);
}

static void on_none(size_t count, void (*work)(void*, size_t), void* context, void* user) {
    (void)count, (void)work, (void)context, (void)user;
}

struct told {
    size_t calls, last, stop_at;
    firma_world world; /* released at the first call */
};

static uint32_t note(size_t done, size_t count, void* user) {
    struct told* told = user;
    CHECK(count == kMany && done > told->last && done <= count);
    ++told->calls;
    told->last = done;
    CHECK_OK(firma_world_release(told->world));
    told->world.id = 0;
    return done < told->stop_at;
}

static void fill_rows(void) {
    uint32_t seed = 5;
    for (int k = 0; k < kMany; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            rows[k].at[axis] = some(&seed, 1, 3);
            rows[k].to[axis] = rows[k].at[axis] + some(&seed, -0.5, 0.5);
            rows[k].path[axis] = some(&seed, -9, 9);
        }
        rows[k].radius = some(&seed, 0, 0.5);
        hull_of[k] = (uint32_t)k % 2;
    }
    rows[kMany - 1].path[1] = NAN;
}

static firma_mover mover_of(uint32_t kind, const firma_hull* hulls, int k) {
    firma_mover mover = {.size = sizeof mover, .kind = kind, .radius = rows[k].radius};
    memcpy(mover.at, rows[k].at, sizeof mover.at);
    memcpy(mover.to, rows[k].to, sizeof mover.to);
    if (kind == FIRMA_MOVER_HULL) mover.hull = hulls[hull_of[k]];
    return mover;
}

static void check_columns(void) {
    for (int k = 0; k < kMany; ++k) {
        const firma_hit* hit = &together.hits[k];
        CHECK(memcmp(&one_by_one.hits[k], hit, sizeof *hit) == 0);
        CHECK(together.status[k] == hit->status && together.fraction[k] == hit->fraction);
        CHECK(together.safe[k] == hit->safe_fraction && together.face[k] == hit->face);
        CHECK(together.nx[k] == hit->normal[0] && together.ny[k] == hit->normal[1] && together.nz[k] == hit->normal[2]);
        CHECK(together.portal[k] == hit->portal && together.material[k] == hit->material);
    }
}

static void test_many(firma_world room) {
    fill_rows();
    const double half[3] = {0.25, 0.5, 0.125};
    firma_hull hulls[2] = {unit_box(), {0}};
    CHECK_OK(firma_hull_box(half, NULL, &hulls[1]));
    const firma_answers wanted = all_of(&together);
    for (uint32_t kind = 0; kind < 3; ++kind) {
        const firma_casts casts = casts_of_rows(kind, hulls, 2);
        firma_cast_counts alone = {0}, batched = {0};
        int touched = 0;
        for (int k = 0; k < kMany; ++k) {
            const firma_mover mover = mover_of(kind, hulls, k);
            CHECK_OK(firma_cast_mover(room, &mover, rows[k].path, NULL, &one_by_one.hits[k], &alone));
            CHECK_OK(firma_cast_mover_any(room, &mover, rows[k].path, NULL, &one_by_one.status[k]));
            touched += one_by_one.status[k] == FIRMA_HIT;
        }
        CHECK(touched > kMany / 2 && one_by_one.hits[kMany - 1].status == FIRMA_INVALID);
        uint32_t cancelled = 9;
        memset(&together, 0xAA, sizeof together);
        CHECK_OK(firma_cast_many(room, &casts, NULL, NULL, &wanted, &batched, &cancelled));
        CHECK(cancelled == 0 && memcmp(&alone, &batched, sizeof alone) == 0);
        check_columns();

        /* On threads, told of; the world is held while it takes. */
        const firma_tasks tasks = {sizeof tasks, on_threads, NULL};
        CHECK_OK(firma_set_tasks(&tasks));
        struct told told = {.stop_at = SIZE_MAX};
        CHECK_OK(firma_world_copy(room, &told.world));
        firma_many_options many = {.size = sizeof many, .progress = note, .user = &told};
        memset(&together, 0xAA, sizeof together);
        CHECK_OK(firma_cast_many(told.world, &casts, NULL, &many, &wanted, NULL, NULL));
        CHECK(told.calls == (kMany + 255) / 256 && told.last == kMany);
        check_columns();

        /* Whether, alone. */
        many = (firma_many_options){.size = sizeof many, .any = 1};
        const firma_answers statuses = {.size = sizeof statuses, .status = together.status};
        CHECK_OK(firma_cast_many(room, &casts, NULL, &many, &statuses, NULL, NULL));
        CHECK(memcmp(together.status, one_by_one.status, sizeof together.status) == 0);
        CHECK_FAILS(firma_cast_many(room, &casts, NULL, &many, &wanted, NULL, NULL), FIRMA_ERROR_INVALID, "any");

        const firma_tasks idle = {sizeof idle, on_none, NULL};
        CHECK_OK(firma_set_tasks(&idle));
        CHECK_FAILS(firma_cast_many(room, &casts, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_BAD_CALL, "run");
        for (int k = 0; k < kMany; ++k) CHECK(together.status[k] == FIRMA_INVALID && together.fraction[k] == 0);
        CHECK_OK(firma_set_tasks(NULL));

        /* Stopped at the second piece of work. */
        struct told stopped = {.stop_at = 512};
        many = (firma_many_options){.size = sizeof many, .progress = note, .user = &stopped};
        CHECK_OK(firma_cast_many(room, &casts, NULL, &many, &wanted, NULL, &cancelled));
        CHECK(cancelled == 1 && stopped.calls == 2);
        for (int k = 0; k < kMany; ++k)
            CHECK(k < 512 ? memcmp(&one_by_one.hits[k], &together.hits[k], sizeof(firma_hit)) == 0
                          : together.status[k] == FIRMA_INVALID && together.face[k] == FIRMA_NO_FACE);
    }
    CHECK_OK(firma_hull_release(hulls[0]));
    CHECK_OK(firma_hull_release(hulls[1]));
}

static void test_many_columns(firma_world room) {
    /* Columns of their own, no radii: rays. */
    static double x[kMany], y[kMany], z[kMany], px[kMany], py[kMany], pz[kMany];
    static firma_cast_input inputs[kMany];
    for (int k = 0; k < kMany; ++k) {
        x[k] = rows[k].at[0], y[k] = rows[k].at[1], z[k] = rows[k].at[2];
        px[k] = rows[k].path[0], py[k] = rows[k].path[1], pz[k] = rows[k].path[2];
        memcpy(inputs[k].centre, rows[k].at, sizeof inputs[k].centre);
        memcpy(inputs[k].path, rows[k].path, sizeof inputs[k].path);
    }
    firma_casts casts = {.size = sizeof casts, .count = kMany, .x = x, .y = y, .z = z};
    casts.path_x = px, casts.path_y = py, casts.path_z = pz;
    const firma_answers wanted = all_of(&together);
    CHECK_OK(firma_cast_batch(room, inputs, kMany, NULL, one_by_one.hits, NULL));
    CHECK_OK(firma_cast_many(room, &casts, NULL, NULL, &wanted, NULL, NULL));
    check_columns();

    const firma_answers nothing = {.size = sizeof nothing};
    CHECK_OK(firma_cast_many(room, &casts, NULL, NULL, &nothing, NULL, NULL));
    firma_casts bad = {.size = sizeof bad};
    CHECK_OK(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL));
    bad = casts, bad.stride = 12;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_INVALID, "stride");
    bad = casts, bad.kind = 3;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_INVALID, "kind 3");
    bad = casts, bad.path_y = NULL;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    bad = casts, bad.kind = FIRMA_MOVER_CAPSULE;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    bad = casts, bad.kind = FIRMA_MOVER_HULL;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_INVALID,
                "cast 0 is of hull 0 of 0");
    const firma_hull box = unit_box(), none = {0};
    bad.hulls = &none, bad.hull_count = 1;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_BAD_HANDLE, "hull");
    bad.hulls = &box, bad.hull_of = hull_of;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_INVALID,
                "cast 1 is of hull 1 of 1");
    CHECK_OK(firma_hull_release(box));
    firma_many_options many = {.size = sizeof many, .any = 2};
    CHECK_FAILS(firma_cast_many(room, &casts, NULL, &many, &wanted, NULL, NULL), FIRMA_ERROR_INVALID, "any");
    many.size = 4;
    CHECK_FAILS(firma_cast_many(room, &casts, NULL, &many, &wanted, NULL, NULL), FIRMA_ERROR_BAD_CALL, "size");
    bad = casts, bad.size = 4;
    CHECK_FAILS(firma_cast_many(room, &bad, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_BAD_CALL, "size");
    const firma_answers wrong = {.size = 4};
    CHECK_FAILS(firma_cast_many(room, &casts, NULL, NULL, &wrong, NULL, NULL), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_cast_many(room, NULL, NULL, NULL, &wanted, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_many(room, &casts, NULL, NULL, NULL, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

void test_movers(void) {
    const firma_world room = make_room();
    test_hulls();
    test_one(room);
    test_bad(room);
    test_lists(room);
    test_many(room);
    test_many_columns(room);
    CHECK_OK(firma_world_release(room));
}

/* SPDX-License-Identifier: MIT */
/* Structs that grow: callers that were compiled with shorter ones, and with longer ones. */
#include <stddef.h>

#include "tests/c/check.h"

/* The members that firma_cast_options had in version 0.1, without what later ones added. */
typedef struct old_cast_options {
    uint32_t size, mask, sides, room;
    double contact_offset;
} old_cast_options;

static void test_shorter_options(void) {
    const firma_world room = make_room();
    const firma_cast_input down = {{4, 4, 2}, 0.5, {0, 0, -4}};
    const old_cast_options none = {sizeof none, 0, 0, FIRMA_ANY_ROOM, -1};
    /* What lies behind it is another's. */
    struct {
        old_cast_options options;
        unsigned char canary[32];
    } held = {none, {0}};
    memset(held.canary, 0xAA, sizeof held.canary);
    firma_hit hit;
    CHECK_OK(firma_cast(room, &down, (const firma_cast_options*)&held.options, &hit, NULL));
    CHECK(hit.status == FIRMA_MISS && hit.fraction == 1);
    held.options.mask = UINT32_MAX;
    CHECK_OK(firma_cast(room, &down, (const firma_cast_options*)&held.options, &hit, NULL));
    CHECK(hit.status == FIRMA_HIT);

    /* Only a mask: the other members are as by default. */
    uint32_t two[2] = {8, 0};
    CHECK_OK(firma_cast(room, &down, (const firma_cast_options*)two, &hit, NULL));
    CHECK(hit.status == FIRMA_MISS);
    two[1] = 1;
    CHECK_OK(firma_cast(room, &down, (const firma_cast_options*)two, &hit, NULL));
    CHECK(hit.status == FIRMA_HIT && hit.safe_fraction < hit.fraction);
    for (uint32_t wrong = 0; wrong < 8; ++wrong) {
        two[0] = wrong;
        CHECK_FAILS(firma_cast(room, &down, (const firma_cast_options*)two, &hit, NULL), FIRMA_ERROR_BAD_CALL, "size");
    }
    two[0] = 9;
    CHECK_FAILS(firma_cast(room, &down, (const firma_cast_options*)two, &hit, NULL), FIRMA_ERROR_BAD_CALL, "size");
    firma_cast_options longer;
    firma_cast_options_defaults(&longer);
    longer.size = sizeof longer + 8;
    CHECK_FAILS(firma_cast(room, &down, &longer, &hit, NULL), FIRMA_ERROR_BAD_CALL, "newer header");
    CHECK_OK(firma_world_release(room));
}

static void test_shorter_results(void) {
    const firma_world room = make_room();
    firma_world_facts facts;
    memset(&facts, 0xAA, sizeof facts);
    facts.size = offsetof(firma_world_facts, face_count);
    CHECK_OK(firma_world_get_facts(room, &facts));
    CHECK(facts.size == offsetof(firma_world_facts, face_count) && facts.edits == 0 && facts.version == 0);
    CHECK(facts.face_count == 0xAAAAAAAAAAAAAAAAu); /* not the caller's */
    facts.size = 0;
    CHECK_FAILS(firma_world_get_facts(room, &facts), FIRMA_ERROR_BAD_CALL, "`size` is not set");
    facts.size = 0xAAAAAAAA;
    CHECK_FAILS(firma_world_get_facts(room, &facts), FIRMA_ERROR_BAD_CALL, "size");
    CHECK(facts.edits == 0 && facts.version == 0);

    /* A report that cannot be right is told before anything is done. */
    firma_cutter box = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_BOX, 0, &box));
    const firma_pose pose = {{4.1, 4.2, -0.3}, {0, 0, 0, 1}, 0.7};
    firma_carve_report report = {.size = 4};
    firma_world after = {0};
    CHECK_FAILS(firma_carve(room, box, &pose, NULL, &after, &report), FIRMA_ERROR_BAD_CALL, "size");
    CHECK(after.id == 0);
    report.size = offsetof(firma_carve_report, retries);
    report.status = 9;
    report.scale = -7;
    CHECK_OK(firma_carve(room, box, &pose, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.scale == -7);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_cutter_release(box));
    CHECK_OK(firma_world_release(room));
}

/* A function of version 0.1; test_old_names.c has other names. */
static void test_in_solid(void) {
    const firma_world room = make_room();
    uint32_t where = 9;
    const double air[3] = {4, 4, 2}, rock[3] = {4, 4, -2}, wall[3] = {0, 4, 2}, bad[3] = {0, 0, 1e300 * 1e300};
    CHECK_OK(firma_in_solid(room, air, &where));
    CHECK(where == 0);
    CHECK_OK(firma_in_solid(room, rock, &where));
    CHECK(where == 1);
    CHECK_OK(firma_in_solid(room, wall, &where));
    CHECK(where == 2);
    CHECK_FAILS(firma_in_solid(room, bad, &where), FIRMA_ERROR_OUT_OF_RANGE, "finite");
    CHECK_FAILS(firma_in_solid(room, air, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(FIRMA_TOUCHING == FIRMA_INITIAL_OVERLAP && FIRMA_ROOM == FIRMA_AIR && FIRMA_UNSURE == FIRMA_UNKNOWN);
    CHECK_OK(firma_world_release(room));
}

void test_structs(void) {
    test_shorter_options();
    test_shorter_results();
    test_in_solid();
}

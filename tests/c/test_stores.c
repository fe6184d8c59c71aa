/* SPDX-License-Identifier: MIT */
/* Histories: publishing, undo, versions that are gone. */
#include "tests/c/check.h"

static uint64_t version_of(firma_world world) {
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(world, &facts));
    return facts.version;
}

static void cut_and_publish(firma_store store, firma_cutter cutter, double x) {
    firma_world now = {0}, after = {0};
    const firma_pose pose = {{x, 4, 0}, {0, 0, 0, 1}, 0.75};
    CHECK_OK(firma_store_current(store, &now));
    CHECK_OK(firma_carve(now, cutter, &pose, NULL, &after, NULL));
    CHECK_OK(firma_store_publish(store, now, after));
    CHECK_FAILS(firma_store_publish(store, now, after), FIRMA_ERROR_INVALID, "current");
    CHECK_OK(firma_world_release(now));
    CHECK_OK(firma_world_release(after));
}

void test_stores(void) {
    const firma_world room = make_room();
    firma_cutter cutter = {0};
    firma_store store = {0};
    firma_world world = {0};
    firma_store_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_cutter_crater(FIRMA_BOX, 1, &cutter));
    CHECK_OK(firma_store_open(room, 1u << 20, &store));
    CHECK_FAILS(firma_store_undo(store, &world), FIRMA_ERROR_INVALID, "before");
    CHECK_FAILS(firma_store_redo(store, &world), FIRMA_ERROR_INVALID, "undone");
    cut_and_publish(store, cutter, 2.01);
    cut_and_publish(store, cutter, 6.01);
    CHECK_OK(firma_store_get_facts(store, &facts));
    CHECK(facts.oldest == 0 && facts.current == 2 && facts.newest == 2 && facts.versions == 3 && facts.bytes > 0);
    CHECK_OK(firma_store_undo(store, &world));
    CHECK(version_of(world) == 1);
    CHECK_OK(firma_world_release(world));
    CHECK_OK(firma_store_redo(store, &world));
    CHECK(version_of(world) == 2);
    CHECK_OK(firma_world_release(world));
    CHECK_OK(firma_store_at(store, 0, &world));
    CHECK(version_of(world) == 0);
    CHECK_OK(firma_world_release(world));
    CHECK_FAILS(firma_store_at(store, 9, &world), FIRMA_ERROR_INVALID, "version 9");
    CHECK_OK(firma_store_current(store, &world));
    CHECK_OK(firma_store_release(store));
    CHECK_OK(firma_world_check(world)); /* outlives the store */
    CHECK_OK(firma_world_release(world));

    /* Without bytes for a history there is only the current version. */
    uint64_t waiting = 9;
    CHECK_OK(firma_store_open(room, 0, &store));
    cut_and_publish(store, cutter, 4.01);
    CHECK_OK(firma_store_collect(store, &waiting));
    CHECK_OK(firma_store_get_facts(store, &facts));
    CHECK(facts.versions == 1 && facts.bytes == 0 && facts.current == 1);
    CHECK_OK(firma_store_release(store));
    CHECK_OK(firma_cutter_release(cutter));
    CHECK_OK(firma_world_release(room));
}

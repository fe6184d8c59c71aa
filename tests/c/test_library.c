/* SPDX-License-Identifier: MIT */
/* Version, messages, and handles that are no good. */
#include "tests/c/check.h"

void test_library(void) {
    CHECK(firma_version() == (FIRMA_VERSION_MAJOR << 16 | FIRMA_VERSION_MINOR << 8 | FIRMA_VERSION_PATCH));
    CHECK(firma_live_handles() == 0);
    CHECK(firma_error_message() != NULL);
    firma_tasks tasks = {0};
    CHECK_FAILS(firma_set_tasks(&tasks), FIRMA_ERROR_BAD_CALL, "size");
    tasks.size = sizeof tasks;
    CHECK_FAILS(firma_set_tasks(&tasks), FIRMA_ERROR_BAD_CALL, "run");
    CHECK_OK(firma_set_tasks(NULL));
}

/* Every function with a handle of nothing, of another kind, and one that was released. */
void test_handles(void) {
    const firma_world none = {0};
    const firma_world invented = {0x123456789abcdefull};
    uint64_t hash = 77;
    CHECK_FAILS(firma_world_hash(none, &hash), FIRMA_ERROR_BAD_HANDLE, "no world");
    CHECK_FAILS(firma_world_hash(invented, &hash), FIRMA_ERROR_BAD_HANDLE, "not a world");
    CHECK(hash == 77);
    CHECK_OK(firma_world_release(none));
    CHECK_FAILS(firma_world_release(invented), FIRMA_ERROR_BAD_HANDLE, "released already");

    const firma_world room = make_room();
    const firma_cutter not_a_cutter = {room.id};
    const firma_pose pose = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    firma_world after = {0};
    CHECK_FAILS(firma_carve(room, not_a_cutter, &pose, NULL, &after, NULL), FIRMA_ERROR_BAD_HANDLE, "cutter");
    CHECK(after.id == 0);
    CHECK_OK(firma_world_release(room));
    CHECK_FAILS(firma_world_release(room), FIRMA_ERROR_BAD_HANDLE, "released already");
    CHECK_FAILS(firma_world_hash(room, &hash), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK_FAILS(firma_world_check(room), FIRMA_ERROR_BAD_HANDLE, "world");

    /* A slot that is used again has another number. */
    const firma_world other = make_room();
    CHECK(other.id != room.id);
    CHECK_FAILS(firma_world_hash(room, &hash), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK_OK(firma_world_hash(other, &hash));
    CHECK_OK(firma_world_release(other));

    const firma_job job = {5};
    const firma_edit edit = {5};
    const firma_store store = {5};
    const firma_diff diff = {5};
    const firma_faces faces = {5};
    const firma_bytes bytes = {5};
    uint32_t flag = 0;
    firma_diff_view diff_view = {.size = sizeof diff_view};
    firma_faces_view faces_view = {.size = sizeof faces_view};
    firma_store_facts facts = {.size = sizeof facts};
    const void* data = NULL;
    size_t length = 0;
    CHECK_FAILS(firma_job_run(job, 1, &flag), FIRMA_ERROR_BAD_HANDLE, "job");
    CHECK_FAILS(firma_edit_finish(edit, &after), FIRMA_ERROR_BAD_HANDLE, "edit");
    CHECK_FAILS(firma_store_current(store, &after), FIRMA_ERROR_BAD_HANDLE, "store");
    CHECK_FAILS(firma_store_get_facts(store, &facts), FIRMA_ERROR_BAD_HANDLE, "store");
    CHECK_FAILS(firma_diff_get_view(diff, &diff_view), FIRMA_ERROR_BAD_HANDLE, "diff");
    CHECK_FAILS(firma_faces_get_view(faces, &faces_view), FIRMA_ERROR_BAD_HANDLE, "faces");
    CHECK_FAILS(firma_bytes_get_view(bytes, &data, &length), FIRMA_ERROR_BAD_HANDLE, "bytes");
}

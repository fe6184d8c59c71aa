/* SPDX-License-Identifier: MIT */
/* Worlds as bytes and in files. */
#include <stdlib.h>

#include "tests/c/check.h"

void test_files(const char* folder) {
    const firma_world room = make_room();
    firma_world back = {0};
    firma_bytes bytes = {0};
    const void* data = NULL;
    size_t length = 0;
    CHECK_OK(firma_world_pack(room, 1, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    CHECK(length > 100);
    CHECK_OK(firma_world_unpack(data, length, "room.firma", &back));
    CHECK(hash_of(back) == hash_of(room));
    CHECK_OK(firma_world_release(back));
    CHECK_FAILS(firma_world_unpack(data, length - 1, "short.firma", &back), FIRMA_ERROR_MALFORMED, "short.firma");
    CHECK_FAILS(firma_world_unpack(NULL, 5, "x", &back), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_pack(room, 2, &bytes), FIRMA_ERROR_INVALID, "exact");
    CHECK_OK(firma_bytes_release(bytes));

    char path[1024];
    snprintf(path, sizeof path, "%s/test_c_api.firma", folder);
    CHECK_OK(firma_world_save(room, path, 1));
    CHECK_OK(firma_world_load(path, NULL, &back));
    CHECK(hash_of(back) == hash_of(room));
    CHECK_OK(firma_world_release(back));
    firma_world_options options;
    firma_world_options_defaults(&options);
    CHECK_FAILS(firma_world_load(path, &options, &back), FIRMA_ERROR_INVALID, "options");
    remove(path);
    CHECK_FAILS(firma_world_load(path, NULL, &back), FIRMA_ERROR_CANNOT_READ, "test_c_api.firma");
    CHECK_FAILS(firma_world_load("nothing.xyz", NULL, &back), FIRMA_ERROR_UNSUPPORTED, "nothing.xyz");
    CHECK_FAILS(firma_world_load(NULL, NULL, &back), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_save(room, "/no/such/folder/room.firma", 1), FIRMA_ERROR_CANNOT_WRITE, "/no/such/folder");
    CHECK_OK(firma_world_release(room));
}

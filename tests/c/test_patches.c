/* SPDX-License-Identifier: MIT */
/* Two peers of which one missed an edit: they find where they differ, and one mends the other. */
#include <stdlib.h>

#include "tests/c/check.h"

enum { kMost = 64 };

static firma_world shot(firma_world world, uint32_t number, double x) {
    const firma_pose pose = {{x, 4, 0}, {0, 0, 0, 1}, 0.7};
    const firma_carve_options options = {.size = sizeof options, .edit = number};
    firma_cutter crater = {0};
    firma_world after = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, number, &crater));
    CHECK_OK(firma_carve(world, crater, &pose, &options, &after, NULL));
    CHECK_OK(firma_cutter_release(crater));
    return after;
}

/* Where two worlds differ: three integers each. */
static size_t find_differing(firma_world a, firma_world b, int32_t regions[3 * kMost]) {
    static firma_region_hash one[kMost], two[kMost];
    size_t ones = 0, twos = 0, count = 0, again = 0;
    CHECK_OK(firma_world_hash_regions(a, one, kMost, &ones));
    CHECK_OK(firma_world_hash_regions(b, two, kMost, &twos));
    CHECK_OK(firma_differing_regions(one, ones, two, twos, regions, kMost, &count));
    CHECK_OK(firma_differing_regions(one, ones, two, twos, NULL, 0, &again));
    CHECK(count == again);
    CHECK_OK(firma_differing_regions(one, ones, one, ones, NULL, 0, &again));
    CHECK(again == 0);
    CHECK_FAILS(firma_differing_regions(NULL, 1, two, twos, NULL, 0, &count), FIRMA_ERROR_BAD_CALL, "null");
    return count;
}

static void test_apply(firma_world world, firma_bytes patch, firma_world goal) {
    const void* data = NULL;
    size_t length = 0;
    firma_world mended = {0};
    CHECK_OK(firma_bytes_get_view(patch, &data, &length));
    CHECK_OK(firma_world_apply_patch(world, data, length, "peer", &mended));
    CHECK(hash_of(mended) == hash_of(goal));
    CHECK_OK(firma_world_check(mended));
    CHECK_FAILS(firma_world_apply_patch(goal, data, length, "peer", &mended), FIRMA_ERROR_INVALID, "");
    unsigned char* const damaged = malloc(length);
    firma_world none = {0};
    for (size_t k = 0; k < length; k += 1 + length / 50) {
        memcpy(damaged, data, length);
        damaged[k] ^= 4;
        CHECK(firma_world_apply_patch(world, damaged, length, NULL, &none) != FIRMA_OK);
    }
    free(damaged);
    CHECK(none.id == 0);
    CHECK_OK(firma_world_release(mended));
}

void test_patches(void) {
    const firma_world room = make_room();
    const firma_world behind = shot(room, 1, 2), ahead = shot(behind, 2, 6);
    int32_t regions[3 * kMost];
    firma_bytes list = {0}, patch = {0};
    const void* data = NULL;
    size_t length = 0;
    const size_t count = find_differing(behind, ahead, regions);
    CHECK(count > 0);
    CHECK_OK(firma_world_list_faces(behind, regions, count, &list));
    CHECK_OK(firma_bytes_get_view(list, &data, &length));
    CHECK_OK(firma_world_make_patch(ahead, data, length, "list", &patch));
    test_apply(behind, patch, ahead);
    CHECK_FAILS(firma_world_make_patch(ahead, data, length - 1, "list", &patch), FIRMA_ERROR_MALFORMED, "list");
    CHECK_OK(firma_bytes_release(patch));
    CHECK_OK(firma_bytes_release(list));
    CHECK_OK(firma_world_patch_from(ahead, behind, &patch));
    test_apply(behind, patch, ahead);
    CHECK_OK(firma_bytes_release(patch));
    CHECK_FAILS(firma_world_list_faces(behind, NULL, 1, &list), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_patch_from(ahead, behind, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_release(ahead));
    CHECK_OK(firma_world_release(behind));
    CHECK_OK(firma_world_release(room));
}

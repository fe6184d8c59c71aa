/* SPDX-License-Identifier: MIT */
/* What faces hold, and what an edit takes of it. */
#include <math.h>

#include "tests/c/check.h"

void test_supports(void) {
    const size_t handles = firma_live_handles();
    const firma_world room = make_room();
    const firma_supported things[3] = {
        {11, FIRMA_SUPPORT_TOUCHES, {1, 1, 0}, {3, 2, 1}, 0, 0, 0},
        {12, FIRMA_SUPPORT_STANDS, {5, 5, 2}, {6, 6, 3}, 10, 0, 0},
        {13, FIRMA_SUPPORT_HANGS, {4, 4, 3}, {4.5, 4.5, 3.5}, 1, 0, 0},
    };
    firma_supports supports = {0};
    CHECK_OK(firma_supports_find(room, things, 3, &supports));
    size_t count = 0;
    CHECK_OK(firma_supports_get_count(supports, &count));
    CHECK(count == 3);
    firma_support support = {.size = sizeof support};
    const double areas[3] = {2, 1, 0.25};
    for (size_t k = 0; k < 3; ++k) {
        CHECK_OK(firma_supports_get(supports, k, &support));
        CHECK(support.entity == 11 + k && support.kind == k && fabs(support.area - areas[k]) < 1e-9);
        CHECK(support.lowered == (k == 1 ? 2 : 0));
    }
    uint32_t face = 99;
    double area = 0;
    CHECK_OK(firma_supports_faces(supports, 0, &face, &area, 1, &count));
    CHECK(count == 1 && face == 0 && fabs(area - 2) < 1e-9);
    CHECK_OK(firma_supports_faces(supports, 2, &face, NULL, 1, &count));
    CHECK(count == 1 && face == 1);

    /* Half of what the first stands on goes. */
    const firma_cutter box = make_box(2, 0, -1, 4, 4, 1);
    const firma_pose here = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    firma_world cut = {0};
    CHECK_OK(firma_carve(room, box, &here, NULL, &cut, NULL));
    firma_support_change changes[3];
    firma_supports after = {0}, without = {0};
    CHECK_OK(firma_supports_diff(supports, room, cut, changes, 3, &count, &after));
    CHECK(count >= 1 && changes[0].thing == 0 && changes[0].entity == 11 && changes[0].loss == FIRMA_SUPPORT_LESS);
    CHECK(fabs(changes[0].before - 2) < 1e-9 && fabs(changes[0].after - 1) < 1e-9 && changes[0].lost == 1);
    for (size_t k = 1; k < count; ++k) CHECK(changes[k].loss == FIRMA_SUPPORT_KEPT && changes[k].thing == 1);
    size_t all = 0;
    CHECK_OK(firma_supports_diff(supports, (firma_world){0}, cut, NULL, 0, &all, &without));
    CHECK(all == count);
    /* Back again. */
    CHECK_OK(firma_supports_diff(after, cut, room, changes, 3, &count, NULL));
    CHECK(changes[0].thing == 0 && changes[0].loss == FIRMA_SUPPORT_KEPT && fabs(changes[0].after - 2) < 1e-9);
    CHECK_OK(firma_supports_diff(supports, room, room, changes, 3, &count, NULL));
    CHECK(count == 0);

    CHECK_FAILS(firma_supports_diff(supports, cut, room, changes, 3, &count, NULL), FIRMA_ERROR_INVALID, "was");
    CHECK_FAILS(firma_supports_diff(supports, room, cut, NULL, 1, &count, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_supports_diff((firma_supports){0}, room, cut, changes, 3, &count, NULL), FIRMA_ERROR_BAD_HANDLE,
                "supports");
    CHECK_FAILS(firma_supports_get(supports, 3, &support), FIRMA_ERROR_OUT_OF_RANGE, "no such thing");
    CHECK_FAILS(firma_supports_faces(supports, 3, NULL, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "no such thing");
    firma_supported bad = things[0];
    firma_supports none = {77};
    bad.kind = 3;
    CHECK_FAILS(firma_supports_find(room, &bad, 1, &none), FIRMA_ERROR_INVALID, "thing 0");
    bad.kind = 0;
    bad.reach = NAN;
    CHECK_FAILS(firma_supports_find(room, &bad, 1, &none), FIRMA_ERROR_INVALID, "thing 0");
    CHECK_FAILS(firma_supports_find(room, NULL, 1, &none), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_supports_find((firma_world){0}, &bad, 1, &none), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK(none.id == 77);
    CHECK_OK(firma_supports_release(without));
    CHECK_OK(firma_supports_release(after));
    CHECK_OK(firma_supports_release(supports));
    CHECK_OK(firma_world_release(cut));
    CHECK_OK(firma_cutter_release(box));
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == handles);
}

/* SPDX-License-Identifier: MIT */
/* Hits, overlaps and faces one by one, and faces by filters. */
#include <math.h>
#include <stdlib.h>

#include "tests/c/check.h"

/* What a visitor saw, and what it answers. */
typedef struct seen {
    size_t count;
    size_t stop_after; /* 0: never */
    uint32_t ids[64];
    double nearest;
} seen;

static double take_hit(const firma_hit* hit, void* user) {
    seen* all = user;
    all->ids[all->count++] = hit->face;
    if (hit->fraction < all->nearest) all->nearest = hit->fraction;
    return all->stop_after == all->count ? 0 : 1;
}

static double shorten(const firma_hit* hit, void* user) {
    seen* all = user;
    ++all->count;
    if (hit->fraction < all->nearest) all->nearest = hit->fraction;
    return hit->fraction;
}

static uint32_t take_overlap(const firma_near* found, void* user) {
    seen* all = user;
    CHECK(found->depth > 0 && found->direction[0] * found->direction[0] <= 1);
    all->ids[all->count++] = found->face;
    return all->stop_after != all->count;
}

static uint32_t take_face(const firma_face* face, const double* corners, void* user) {
    seen* all = user;
    CHECK(face->corner_count == 4 && face->first_corner == 0);
    CHECK(corners[0] * 262144 == face->corner[0] && corners[2] * 262144 == face->corner[2]);
    all->ids[all->count++] = face->id;
    return all->stop_after != all->count;
}

static void test_each_hit(firma_world room) {
    /* From above the ceiling to below the floor: both are met, the ceiling from its back. */
    const firma_cast_input through = {{4, 4, 6}, 0.5, {0, 0, -8}};
    firma_cast_options both;
    firma_cast_options_defaults(&both);
    both.sides = 1;
    seen all = {.nearest = 1};
    uint32_t status = 9;
    CHECK_OK(firma_cast_each(room, &through, &both, take_hit, &all, &status));
    CHECK(status == FIRMA_HIT && all.count == 2 && all.nearest == 1.5 / 8);
    all = (seen){.nearest = 1, .stop_after = 1};
    CHECK_OK(firma_cast_each(room, &through, &both, take_hit, &all, NULL));
    CHECK(all.count == 1);
    all = (seen){.nearest = 1};
    CHECK_OK(firma_cast_each(room, &through, &both, shorten, &all, &status));
    CHECK(all.nearest == 1.5 / 8 && all.count >= 1);
    const firma_cast_input away = {{4, 4, 6}, 0.5, {0, 0, 8}};
    all = (seen){.nearest = 1};
    CHECK_OK(firma_cast_each(room, &away, NULL, take_hit, &all, &status));
    CHECK(status == FIRMA_MISS && all.count == 0);
    const firma_cast_input bad = {{4, 4, NAN}, 0.5, {0, 0, 8}};
    CHECK_OK(firma_cast_each(room, &bad, NULL, take_hit, &all, &status));
    CHECK(status == FIRMA_INVALID && all.count == 0);
    CHECK_FAILS(firma_cast_each(room, &away, NULL, NULL, &all, &status), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_cast_each(room, NULL, NULL, take_hit, &all, &status), FIRMA_ERROR_BAD_CALL, "null");
    const firma_world none = {0};
    CHECK_FAILS(firma_cast_each(none, &away, NULL, take_hit, &all, &status), FIRMA_ERROR_BAD_HANDLE, "world");
}

static void test_each_overlap(firma_world room) {
    const double corner[3] = {0.2, 0.2, 0.2}, middle[3] = {4, 4, 2}, bad[3] = {0, 0, INFINITY};
    seen all = {0};
    uint32_t found = 9;
    CHECK_OK(firma_overlap_each(room, corner, 0.5, NULL, take_overlap, &all, &found));
    CHECK(found == 1 && all.count == 3);
    all = (seen){.stop_after = 2};
    CHECK_OK(firma_overlap_each(room, corner, 0.5, NULL, take_overlap, &all, NULL));
    CHECK(all.count == 2);
    CHECK_OK(firma_overlap_each(room, middle, 0.5, NULL, take_overlap, &all, &found));
    CHECK(found == 0);
    CHECK_FAILS(firma_overlap_each(room, bad, 0.5, NULL, take_overlap, &all, &found), FIRMA_ERROR_OUT_OF_RANGE,
                "finite");
    firma_near_options elsewhere;
    firma_near_options_defaults(&elsewhere);
    elsewhere.room = 5;
    CHECK_FAILS(firma_overlap_each(room, middle, 0.5, &elsewhere, take_overlap, &all, &found), FIRMA_ERROR_INVALID,
                "no room 5");
    CHECK_FAILS(firma_overlap_each(room, middle, 0.5, NULL, NULL, &all, &found), FIRMA_ERROR_BAD_CALL, "null");
}

static size_t count_faces(firma_world room, const firma_face_filter* filter) {
    seen all = {0};
    uint32_t completed = 9;
    CHECK_OK(firma_world_each_face(room, filter, take_face, &all, &completed));
    CHECK(completed == 1);
    firma_faces faces = {0};
    firma_faces_view view = {.size = sizeof view};
    CHECK_OK(firma_world_faces_in(room, filter, &faces));
    CHECK_OK(firma_faces_get_view(faces, &view));
    CHECK(view.face_count == all.count && view.corner_count == 4 * all.count);
    for (size_t k = 0; k < view.face_count; ++k) CHECK(view.faces[k].id == all.ids[k]);
    CHECK_OK(firma_faces_release(faces));
    return all.count;
}

static void test_each_face(firma_world room) {
    CHECK(count_faces(room, NULL) == 6);
    firma_face_filter filter;
    firma_face_filter_defaults(&filter);
    CHECK(count_faces(room, &filter) == 6);
    filter.room = 0;
    CHECK(count_faces(room, &filter) == 6);
    filter.room = 5;
    CHECK_FAILS(firma_world_each_face(room, &filter, take_face, NULL, NULL), FIRMA_ERROR_INVALID, "no room 5");
    filter.room = FIRMA_ANY_ROOM;
    const double floor_box[6] = {1, 1, -1, 2, 2, 1}, empty[6] = {2, 2, 2, 1, 1, 1}, bad[6] = {0, 0, 0, 0, 0, NAN};
    filter.box = floor_box;
    CHECK(count_faces(room, &filter) == 1);
    filter.box = empty;
    CHECK(count_faces(room, &filter) == 0);
    filter.box = bad;
    CHECK_FAILS(firma_world_each_face(room, &filter, take_face, NULL, NULL), FIRMA_ERROR_OUT_OF_RANGE, "box");
    const int32_t here[3] = {0, 0, 0}, there[3] = {1, 0, 0};
    filter.region = here;
    CHECK_FAILS(firma_world_each_face(room, &filter, take_face, NULL, NULL), FIRMA_ERROR_INVALID, "at most one");
    filter.box = NULL;
    CHECK(count_faces(room, &filter) == 6);
    filter.region = there;
    CHECK(count_faces(room, &filter) == 0);
    filter.size = 7;
    CHECK_FAILS(firma_world_each_face(room, &filter, take_face, NULL, NULL), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_world_each_face(room, NULL, NULL, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    seen all = {.stop_after = 2};
    uint32_t completed = 9;
    CHECK_OK(firma_world_each_face(room, NULL, take_face, &all, &completed));
    CHECK(completed == 0 && all.count == 2);
}

/* A hit's face by its id and corner, and what is not there. */
static void test_face_of_a_hit(firma_world room) {
    const firma_cast_input down = {{4, 4, 2}, 0.5, {0, 0, -4}};
    firma_hit hit;
    CHECK_OK(firma_cast(room, &down, NULL, &hit, NULL));
    firma_faces faces = {0};
    firma_faces_view view = {.size = sizeof view};
    CHECK_OK(firma_world_face(room, hit.face, hit.corner, &faces));
    CHECK_OK(firma_faces_get_view(faces, &view));
    CHECK(view.face_count == 1 && view.faces[0].id == hit.face && view.faces[0].normal[2] == 1);
    CHECK(memcmp(view.faces[0].corner, hit.corner, sizeof hit.corner) == 0);
    CHECK_OK(firma_faces_release(faces));
    const int32_t elsewhere[3] = {1, 2, 3};
    CHECK_FAILS(firma_world_face(room, hit.face, elsewhere, &faces), FIRMA_ERROR_INVALID, "no such face");
    CHECK_FAILS(firma_world_face(room, FIRMA_NO_FACE, hit.corner, &faces), FIRMA_ERROR_INVALID, "no such face");
    CHECK_OK(firma_world_find_face(room, 1234, &faces)); /* a search: nothing found is no failure */
    CHECK_OK(firma_faces_get_view(faces, &view));
    CHECK(view.face_count == 0);
    CHECK_OK(firma_faces_release(faces));
}

static void test_hashes(firma_world room) {
    uint64_t world_hash = 0, solid_hash = 0, again = 0;
    CHECK_OK(firma_world_hash(room, &world_hash));
    CHECK_OK(firma_world_hash_solid(room, &solid_hash));
    CHECK(world_hash != solid_hash && solid_hash != 0);
    const firma_world other = make_room();
    CHECK_OK(firma_world_hash_solid(other, &again));
    CHECK(again == solid_hash);
    uint32_t same = 9;
    CHECK_OK(firma_world_same_solid(room, other, &same));
    CHECK(same == 1);
    CHECK_FAILS(firma_world_same_solid(room, other, NULL), FIRMA_ERROR_BAD_CALL, "null");
    const firma_world none = {0};
    CHECK_FAILS(firma_world_same_solid(room, none, &same), FIRMA_ERROR_BAD_HANDLE, "no world");
    CHECK_FAILS(firma_world_same_solid(none, room, &same), FIRMA_ERROR_BAD_HANDLE, "no world");
    CHECK(same == 1);
    firma_region_hash regions[4];
    size_t count = 9;
    CHECK_OK(firma_world_hash_regions(room, regions, 4, &count));
    CHECK(count == 1 && regions[0].region[0] == 0 && regions[0].faces != 0 && regions[0].points != 0);
    CHECK_OK(firma_world_hash_regions(room, NULL, 0, &count));
    CHECK(count == 1);
    CHECK_FAILS(firma_world_hash_regions(room, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_release(other));
}

/* Whoever shows a hit holds on to the world: the visitor may release it. */
typedef struct released {
    firma_world world;
    int calls;
} released;

static double release_once(const firma_hit* hit, void* user) {
    released* held = user;
    if (held->calls++ == 0) CHECK_OK(firma_world_release(held->world));
    return hit->fraction;
}

static uint32_t release_at_overlap(const firma_near* found, void* user) {
    released* held = user;
    CHECK(found->depth >= 0);
    if (held->calls++ == 0) CHECK_OK(firma_world_release(held->world));
    return 1;
}

static uint32_t release_at_face(const firma_face* face, const double* corners, void* user) {
    released* held = user;
    CHECK(face->corner_count == 4 && corners != NULL);
    if (held->calls++ == 0) CHECK_OK(firma_world_release(held->world));
    return 1;
}

static void test_released_meanwhile(void) {
    const firma_cast_input through = {{4, 4, 6}, 0.5, {0, 0, -8}};
    firma_cast_options both;
    firma_cast_options_defaults(&both);
    both.sides = 1;
    released held = {make_room(), 0};
    CHECK_OK(firma_cast_each(held.world, &through, &both, release_once, &held, NULL));
    CHECK(held.calls >= 1);
    held = (released){make_room(), 0};
    const double corner[3] = {0.2, 0.2, 0.2};
    CHECK_OK(firma_overlap_each(held.world, corner, 0.5, NULL, release_at_overlap, &held, NULL));
    CHECK(held.calls == 3);
    held = (released){make_room(), 0};
    CHECK_OK(firma_world_each_face(held.world, NULL, release_at_face, &held, NULL));
    CHECK(held.calls == 6);
}

void test_visitors(void) {
    test_released_meanwhile();
    const firma_world room = make_room();
    test_each_hit(room);
    test_each_overlap(room);
    test_each_face(room);
    test_face_of_a_hit(room);
    test_hashes(room);
    CHECK_OK(firma_world_release(room));
}

/* SPDX-License-Identifier: MIT */
/* Levels of brushes, their rooms and portals, doors, and casts by room. */
#include <math.h>
#include <stdlib.h>

#include "tests/c/check.h"

enum { kLongestText = 8192 };

static size_t end_of_text(const char* text) {
    return strlen(text);
}

/* A brush in units of the file: six sides, clockwise seen from outside; the one at x0 with a texture of its own. */
static void add_box(char* text, const int low[3], const int high[3], const char* texture, const char* low_x) {
    static const int sides[6][3][3] = {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 1}, {1, 1, 0}},
                                       {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}, {0, 1, 1}},
                                       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}};
    strcat(text, "{\n");
    for (int side = 0; side < 6; ++side) {
        for (int corner = 0; corner < 3; ++corner) {
            int p[3];
            for (int axis = 0; axis < 3; ++axis) p[axis] = sides[side][corner][axis] ? high[axis] : low[axis];
            sprintf(text + end_of_text(text), "( %d %d %d ) ", p[0], p[1], p[2]);
        }
        sprintf(text + end_of_text(text), "%s 0 0 0 1 1\n", side == 0 && low_x ? low_x : texture);
    }
    strcat(text, "}\n");
}

/* Two rooms of 4 m along x, walls of half a metre, and a portal, named gate, at x = 4. */
static const char* two_rooms(void) {
    static char text[kLongestText];
    static const int walls[6][2][3] = {{{-16, -16, -16}, {0, 144, 144}}, {{256, -16, -16}, {272, 144, 144}},
                                       {{0, -16, -16}, {256, 0, 144}},   {{0, 128, -16}, {256, 144, 144}},
                                       {{0, 0, -16}, {256, 128, 0}},     {{0, 0, 128}, {256, 128, 144}}};
    static const int gate[2][3] = {{128, -8, -8}, {130, 136, 136}};
    strcpy(text, "{\n\"classname\" \"worldspawn\"\n");
    for (int k = 0; k < 6; ++k) add_box(text, walls[k][0], walls[k][1], "wall", NULL);
    strcat(text, "}\n{\n\"classname\" \"func_areaportal\"\n\"targetname\" \"gate\"\n");
    add_box(text, gate[0], gate[1], "skip", "portal");
    strcat(text, "}\n{\n\"classname\" \"firma_room\"\n\"name\" \"west\"\n\"origin\" \"32 64 64\"\n}\n");
    return text;
}

static firma_world make_rooms(void) {
    firma_world world = {0};
    const char* text = two_rooms();
    CHECK_OK(firma_world_from_map(text, strlen(text), "two.map", NULL, &world));
    return world;
}

static uint32_t room_at(firma_world world, double x) {
    const double point[3] = {x, 2, 2};
    uint32_t where = 9, room = 9;
    CHECK_OK(firma_world_locate(world, point, &where, &room));
    CHECK(where == FIRMA_AIR);
    return room;
}

static void test_map(void) {
    const firma_world world = make_rooms();
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(world, &facts));
    CHECK(facts.room_count == 3 && facts.portal_count == 1 && facts.low[0] == -0.5 && facts.high[0] == 8.5);
    CHECK_OK(firma_world_check(world));
    double volume = 0;
    CHECK_OK(firma_world_measure(world, &volume, NULL));
    CHECK(fabs(volume - (9 * 5 * 5 - 8 * 4 * 4)) < 1e-9);

    firma_world_options options;
    firma_world_options_defaults(&options);
    options.scale = 1;
    firma_world large = {0}, none = {0};
    const char* text = two_rooms();
    CHECK_OK(firma_world_from_map(text, strlen(text), NULL, &options, &large));
    CHECK_OK(firma_world_get_facts(large, &facts));
    CHECK(facts.high[0] == 272);
    CHECK_OK(firma_world_release(large));
    CHECK_FAILS(firma_world_from_map("{\n{ ( 1 2", 10, "torn.map", NULL, &none), FIRMA_ERROR_MALFORMED, "torn.map:2");
    const char* nothing = "{\n\"classname\" \"worldspawn\"\n}\n";
    CHECK_FAILS(firma_world_from_map(nothing, strlen(nothing), "nothing.map", NULL, &none), FIRMA_ERROR_MALFORMED,
                "nothing.map: no face is left");
    const char* flat = "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
    CHECK_FAILS(firma_world_from_obj(flat, strlen(flat), "flat.obj", NULL, &none), FIRMA_ERROR_MALFORMED,
                "left out: faces without area: 1");
    CHECK_FAILS(firma_world_from_map("", 0, "empty.map", NULL, &none), FIRMA_ERROR_MALFORMED, "empty.map");
    CHECK_FAILS(firma_world_from_map(NULL, 4, "x", NULL, &none), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_from_map(text, 4, "x", NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    options.size = 3;
    CHECK_FAILS(firma_world_from_map(text, 4, "x", &options, &none), FIRMA_ERROR_BAD_CALL, "size");
    CHECK(none.id == 0);
    CHECK_OK(firma_world_release(world));
}

static void test_locate(firma_world world) {
    CHECK(room_at(world, 1) != room_at(world, 7) && room_at(world, 1) != room_at(world, 99));
    const double inside[3] = {-0.25, 2, 2}, on_a_face[3] = {2, 2, 0}, bad[3] = {0, NAN, 0};
    uint32_t where = 9, room = 9;
    CHECK_OK(firma_world_locate(world, inside, &where, &room));
    CHECK(where == FIRMA_SOLID && room == FIRMA_ANY_ROOM);
    CHECK_OK(firma_world_locate(world, on_a_face, &where, &room));
    CHECK(where == FIRMA_SURFACE && room == FIRMA_NO_ROOM);
    CHECK_FAILS(firma_world_locate(world, bad, &where, &room), FIRMA_ERROR_OUT_OF_RANGE, "coordinate");
    CHECK_FAILS(firma_world_locate(world, NULL, &where, &room), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_locate(world, inside, NULL, &room), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_locate(world, inside, &where, NULL));
    CHECK_FAILS(firma_world_locate((firma_world){0}, inside, &where, &room), FIRMA_ERROR_BAD_HANDLE, "world");
}

static void test_rooms_and_portals(firma_world world) {
    const uint32_t west = room_at(world, 1), east = room_at(world, 7), outside = room_at(world, 99);
    firma_room room = {.size = sizeof room};
    CHECK_OK(firma_world_room(world, west, &room));
    CHECK(strcmp(room.name, "west") == 0 && room.face_count == 5 && !room.exterior && room.merged_into == west);
    CHECK(room.portal_count == 1 && room.portals[0] == 0 && room.low[0] == 0 && room.high[0] == 4);
    CHECK_OK(firma_world_room(world, outside, &room));
    CHECK(room.exterior == 1 && room.portal_count == 0);
    CHECK_FAILS(firma_world_room(world, 3, &room), FIRMA_ERROR_INVALID, "no room 3");
    CHECK_FAILS(firma_world_room(world, west, NULL), FIRMA_ERROR_BAD_CALL, "null");

    firma_portal portal = {.size = sizeof portal};
    CHECK_OK(firma_world_portal(world, 0, &portal));
    CHECK(strcmp(portal.name, "gate") == 0 && portal.open == 1 && portal.polygon_count >= 1 && portal.mask != 0);
    CHECK(portal.rooms[0] + portal.rooms[1] == west + east && portal.low[0] == 4 && portal.high[2] == 4);
    CHECK_FAILS(firma_world_portal(world, 1, &portal), FIRMA_ERROR_INVALID, "no portal 1");
    CHECK_FAILS(firma_world_portal(world, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");

    firma_faces polygons = {0};
    firma_faces_view view = {.size = sizeof view};
    CHECK_OK(firma_world_portal_polygons(world, 0, &polygons));
    CHECK_OK(firma_faces_get_view(polygons, &view));
    CHECK(view.face_count == portal.polygon_count && view.corner_count >= 4);
    const double toward = portal.rooms[0] == west ? -1 : 1; /* counter-clockwise seen from rooms[0] */
    for (size_t k = 0; k < view.face_count; ++k)
        CHECK(view.faces[k].normal[0] == toward && view.faces[k].id == FIRMA_NO_FACE && view.faces[k].source == 0);
    for (size_t k = 0; k < view.corner_count; ++k) CHECK(view.corners[3 * k] == 4);
    CHECK_OK(firma_faces_release(polygons));
    CHECK_FAILS(firma_world_portal_polygons(world, 9, &polygons), FIRMA_ERROR_INVALID, "no portal 9");
    CHECK_FAILS(firma_world_portal_polygons(world, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

static void test_ways(firma_world world) {
    const uint32_t west = room_at(world, 1), east = room_at(world, 7), outside = room_at(world, 99);
    uint32_t ids[4] = {9, 9, 9, 9}, found = 9;
    size_t count = 9;
    CHECK_OK(firma_world_neighbours(world, west, ids, 4, &count));
    CHECK(count == 1 && ids[0] == east);
    CHECK_OK(firma_world_neighbours(world, outside, NULL, 0, &count));
    CHECK(count == 0);
    CHECK_FAILS(firma_world_neighbours(world, 7, ids, 4, &count), FIRMA_ERROR_INVALID, "no room 7");
    CHECK_FAILS(firma_world_neighbours(world, west, NULL, 4, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_neighbours(world, west, ids, 4, NULL), FIRMA_ERROR_BAD_CALL, "null");

    CHECK_OK(firma_world_path(world, west, east, 0, ids, 4, &count, &found));
    CHECK(found == 1 && count == 1 && ids[0] == 0);
    CHECK_OK(firma_world_path(world, west, west, 0, NULL, 0, &count, &found));
    CHECK(found == 1 && count == 0);
    CHECK_OK(firma_world_path(world, west, outside, 1, ids, 4, &count, &found));
    CHECK(found == 0 && count == 0);
    CHECK_FAILS(firma_world_path(world, west, 3, 0, ids, 4, &count, &found), FIRMA_ERROR_INVALID, "no room 3");
    CHECK_FAILS(firma_world_path(world, west, east, 2, ids, 4, &count, &found), FIRMA_ERROR_INVALID, "all_open");
    CHECK_FAILS(firma_world_path(world, west, east, 0, NULL, 4, &count, &found), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_path(world, west, east, 0, ids, 4, &count, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

static void test_door(firma_world open) {
    const uint32_t west = room_at(open, 1), east = room_at(open, 7);
    firma_world closed = {0}, again = {0};
    CHECK_OK(firma_world_set_portal_open(open, 0, 0, &closed));
    firma_portal portal = {.size = sizeof portal};
    CHECK_OK(firma_world_portal(closed, 0, &portal));
    CHECK(portal.open == 0);
    uint32_t found = 9;
    size_t count = 9;
    CHECK_OK(firma_world_path(closed, west, east, 0, NULL, 0, &count, &found));
    CHECK(found == 0);
    CHECK_OK(firma_world_path(closed, west, east, 1, NULL, 0, &count, &found));
    CHECK(found == 1 && count == 1);

    const firma_cast_input east_way = {{1, 2, 2}, 0.5, {6, 0, 0}};
    firma_hit hit;
    CHECK_OK(firma_cast(closed, &east_way, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_HIT && hit.portal == 0 && hit.face == FIRMA_NO_FACE && hit.fraction == 2.5 / 6);
    firma_near near;
    const double point[3] = {3.5, 2, 2};
    CHECK_OK(firma_closest(closed, point, 1, NULL, &near, &found));
    CHECK(found == 1 && near.portal == 0 && near.face == FIRMA_NO_FACE && near.distance == 0.5);

    CHECK_OK(firma_world_set_portal_open(closed, 0, 1, &again));
    CHECK_OK(firma_closest(again, point, 1, NULL, &near, &found));
    CHECK(found == 0);
    CHECK_FAILS(firma_world_set_portal_open(open, 0, 2, &again), FIRMA_ERROR_INVALID, "open");
    CHECK_FAILS(firma_world_set_portal_open(open, 1, 0, &again), FIRMA_ERROR_INVALID, "no portal 1");
    CHECK_FAILS(firma_world_set_portal_open(open, 0, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_release(again));
    CHECK_OK(firma_world_release(closed));
}

static void test_casts_by_room(firma_world world) {
    const uint32_t west = room_at(world, 1), east = room_at(world, 7);
    const firma_cast_input through = {{1, 2, 2}, 0.5, {10, 0, 0}};
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    CHECK(options.room == FIRMA_ANY_ROOM && options.passed_capacity == 0);
    firma_hit any, hit;
    CHECK_OK(firma_cast(world, &through, NULL, &any, NULL));
    CHECK(any.status == FIRMA_HIT && any.portal == FIRMA_NO_PORTAL);
    firma_hit_info info = {.size = sizeof info};
    CHECK_OK(firma_world_hit_info(world, &any, &info));
    CHECK(info.room == east);
    uint32_t passed[2] = {9, 9}, passed_count = 9;
    options.passed_count = &passed_count;
    CHECK_OK(firma_cast(world, &through, &options, &hit, NULL));
    CHECK(passed_count == 0);
    options.passed = passed;
    options.passed_capacity = 2;
    for (int k = 0; k < 2; ++k) {
        options.room = k == 0 ? west : FIRMA_LOCATE_ROOM;
        CHECK_OK(firma_cast(world, &through, &options, &hit, NULL));
        CHECK(hit.fraction == any.fraction && hit.face == any.face && passed_count == 2);
        CHECK(passed[0] == west && passed[1] == east);
        passed[0] = passed[1] = 9;
    }
    options.room = 17;
    CHECK_OK(firma_cast(world, &through, &options, &hit, NULL));
    CHECK(hit.status == FIRMA_INVALID);
    size_t count = 0;
    CHECK_FAILS(firma_cast_all(world, &through, &options, NULL, 0, &count), FIRMA_ERROR_INVALID, "no room 17");
    options.passed = NULL;
    CHECK_FAILS(firma_cast(world, &through, &options, &hit, NULL), FIRMA_ERROR_BAD_CALL, "array");

    uint32_t rooms[4] = {9, 9, 9, 9}, portals[4] = {9, 9, 9, 9};
    passed_count = 0;
    firma_cast_options_defaults(&options);
    options.room = FIRMA_LOCATE_ROOM;
    options.passed = rooms;
    options.passed_portals = portals;
    options.passed_capacity = 4;
    options.passed_count = &passed_count;
    CHECK_OK(firma_cast(world, &through, &options, &hit, NULL));
    CHECK(passed_count == 2 && portals[0] == FIRMA_NO_PORTAL && portals[1] == 0 && portals[2] == 9);
    options.passed = NULL;
    options.passed_capacity = 0;
    CHECK_FAILS(firma_cast(world, &through, &options, &hit, NULL), FIRMA_ERROR_BAD_CALL, "array");

    uint32_t found = 7;
    CHECK_OK(firma_world_find_room(world, "nowhere", &found));
    CHECK(found == FIRMA_NO_ROOM);
    CHECK_OK(firma_world_find_room(world, "", &found));
    CHECK(found == FIRMA_NO_ROOM);
    CHECK_OK(firma_world_find_portal(world, "nowhere", &found));
    CHECK(found == FIRMA_NO_PORTAL);
    CHECK_FAILS(firma_world_find_room(world, NULL, &found), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_find_portal(world, "a", NULL), FIRMA_ERROR_BAD_CALL, "null");
}

static void test_level(void) {
    static const char text[] =
        "{ \"classname\" \"worldspawn\" \"message\" \"a\" { brushDef9 { } } { brushDef9 { } } }\n"
        "{ \"classname\" \"light\" \"origin\" \"32 0 -64\" }\n"
        "{ \"origin\" \"1 2\" }\n";
    firma_level level = {0};
    firma_level_view view = {.size = sizeof view};
    CHECK_OK(firma_level_from_map(text, sizeof text - 1, "a.map", 0, &level));
    CHECK_OK(firma_level_get_view(level, &view));
    CHECK(view.entity_count == 3 && view.metres_a_unit == 1.0 / 32);
    CHECK(strcmp(view.entities[0].classname, "worldspawn") == 0 && view.entities[0].key_count == 2);
    CHECK(strcmp(view.entities[0].keys[1], "message") == 0 && strcmp(view.entities[0].values[1], "a") == 0);
    CHECK(view.entities[1].has_origin && view.entities[1].origin[0] == 1 && view.entities[1].origin[2] == -2);
    CHECK(view.entities[1].line == 2 && !view.entities[0].has_origin);
    CHECK(!view.entities[2].has_origin && strcmp(view.entities[2].classname, "") == 0);
    CHECK(view.omission_count == 1 && view.omissions[0].count == 2 &&
          strncmp(view.omissions[0].first, "a.map:1", 7) == 0);
    CHECK(strstr(view.omissions[0].what, "brushDef9") != NULL);
    firma_world world = {0};
    CHECK_FAILS(firma_world_from_level(level, NULL, &world), FIRMA_ERROR_MALFORMED, "a.map");
    CHECK_FAILS(firma_world_from_level(level, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_level_get_view(level, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_level_release(level));
    CHECK_FAILS(firma_level_get_view(level, &view), FIRMA_ERROR_BAD_HANDLE, "level");
    CHECK_FAILS(firma_world_from_level(level, NULL, &world), FIRMA_ERROR_BAD_HANDLE, "level");
    CHECK_FAILS(firma_level_from_map("{", 1, "b.map", 0, &level), FIRMA_ERROR_MALFORMED, "b.map");
    CHECK_FAILS(firma_level_from_map("{", 1, "b.map", -1, &level), FIRMA_ERROR_INVALID, "scale");
    CHECK_FAILS(firma_level_from_map(NULL, 1, "b.map", 0, &level), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_level_from_bsp("{", 1, "b.bsp", 0, &level), FIRMA_ERROR_MALFORMED, "b.bsp");
    CHECK_FAILS(firma_level_from_map("{", 1, NULL, 0, &level), FIRMA_ERROR_MALFORMED, "map:1");
    CHECK_FAILS(firma_level_load("nowhere.map", 0, &level), FIRMA_ERROR_CANNOT_READ, "nowhere.map");
    CHECK_FAILS(firma_level_load("nowhere.obj", 0, &level), FIRMA_ERROR_UNSUPPORTED, "brushes");
    CHECK_FAILS(firma_level_load(NULL, 0, &level), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_world_load("nowhere.glb", NULL, &world), FIRMA_ERROR_UNSUPPORTED, "read_gltf");
}

/* kaos2 of OpenArena, where FIRMA_OPENARENA names the folder that it is in. */
static void test_bsp(void) {
    const char* const folder = getenv("FIRMA_OPENARENA");
    char path[1000];
    if (!folder || (size_t)snprintf(path, sizeof path, "%s/kaos2.bsp", folder) >= sizeof path) return;
    FILE* const file = fopen(path, "rb");
    if (!file) return;
    static char bytes[8 << 20];
    const size_t length = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    firma_world brushes = {0}, surfaces = {0}, loaded = {0};
    firma_world_facts facts = {.size = sizeof facts};
    uint64_t hash = 0, hash_loaded = 0;
    CHECK_OK(firma_world_from_bsp(bytes, length, "kaos2.bsp", NULL, &brushes));
    CHECK_OK(firma_world_get_facts(brushes, &facts));
    CHECK(facts.room_count > 30 && facts.portal_count > 30);
    CHECK_OK(firma_world_load(path, NULL, &loaded));
    CHECK_OK(firma_world_hash(brushes, &hash));
    CHECK_OK(firma_world_hash(loaded, &hash_loaded));
    CHECK(hash == hash_loaded);
    CHECK_OK(firma_world_from_bsp_surfaces(bytes, length, "kaos2.bsp", NULL, &surfaces));
    CHECK_OK(firma_world_get_facts(surfaces, &facts));
    CHECK(facts.room_count == 1 && facts.portal_count == 0);
    CHECK_OK(firma_world_release(brushes));
    CHECK_OK(firma_world_release(surfaces));
    CHECK_OK(firma_world_release(loaded));
}

static void test_rooms_in_files(const char* folder) {
    char path[1024];
    snprintf(path, sizeof path, "%s/test_c_api.map", folder);
    FILE* file = fopen(path, "wb");
    CHECK(file && fputs(two_rooms(), file) >= 0 && fclose(file) == 0);
    firma_world world = {0};
    CHECK_OK(firma_world_load(path, NULL, &world));
    CHECK(room_at(world, 1) != room_at(world, 7));
    CHECK_OK(firma_world_release(world));
    remove(path);
    CHECK_FAILS(firma_world_load(path, NULL, &world), FIRMA_ERROR_CANNOT_READ, "test_c_api.map");
}

/* A hole under the gate is a portal of its own; the pocket is the room's that the shot came from. */
static void test_hole(firma_world world) {
    firma_cutter cutter = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_BOX, 1, &cutter));
    const firma_pose pose = {{4, 2, 0}, {0, 0, 0, 1}, 0.4};
    for (int room = 0; room < 2; ++room) {
        const firma_carve_options options = {.size = sizeof options, .has_from = 1, .from = {room == 0 ? 1 : 7, 2, 1}};
        firma_carve_report report = {.size = sizeof report};
        firma_world after = {0};
        CHECK_OK(firma_carve(world, cutter, &pose, &options, &after, &report));
        CHECK(report.status == FIRMA_CARVE_DONE && report.portals == 1 && report.rooms == 0);
        const double inside[3] = {4, 2, -0.2};
        uint32_t where = 0, pocket = 0;
        CHECK_OK(firma_world_locate(after, inside, &where, &pocket));
        CHECK(where == FIRMA_AIR && pocket == room_at(world, room == 0 ? 1 : 7));
        firma_portal gate = {.size = sizeof gate}, hole = {.size = sizeof hole};
        CHECK_OK(firma_world_portal(after, 0, &gate));
        CHECK_OK(firma_world_portal(after, 1, &hole));
        CHECK(strcmp(gate.name, "gate") == 0 && gate.polygon_count > 0);
        CHECK(hole.polygon_count > 0 && hole.open);
        CHECK_OK(firma_world_release(after));
    }
    CHECK_OK(firma_cutter_release(cutter));
}

void test_rooms(const char* folder) {
    test_map();
    test_bsp();
    const firma_world world = make_rooms();
    test_locate(world);
    test_rooms_and_portals(world);
    test_ways(world);
    test_door(world);
    test_casts_by_room(world);
    test_hole(world);
    test_level();
    CHECK_OK(firma_world_release(world));
    test_rooms_in_files(folder);
}

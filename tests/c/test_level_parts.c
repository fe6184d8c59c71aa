/* SPDX-License-Identifier: MIT */
/* Parts of levels: their paths, what they bear, how they break and are cut; bad arguments. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

/* A box brush of a .map, sides from low to high. */
static size_t put_box(char* text, size_t room, const int low[3], const int high[3], const char* texture) {
    return (size_t)snprintf(
        text, room,
        "{\n( %d 0 0 ) ( %d 1 0 ) ( %d 0 1 ) %s 0 0 0 1 1\n( %d 0 0 ) ( %d 0 1 ) ( %d 1 0 ) %s 0 0 0 1 1\n"
        "( 0 %d 0 ) ( 0 %d 1 ) ( 1 %d 0 ) %s 0 0 0 1 1\n( 0 %d 0 ) ( 1 %d 0 ) ( 0 %d 1 ) %s 0 0 0 1 1\n"
        "( 0 0 %d ) ( 1 0 %d ) ( 0 1 %d ) %s 0 0 0 1 1\n( 0 0 %d ) ( 0 1 %d ) ( 1 0 %d ) %s 0 0 0 1 1\n}\n",
        low[0], low[0], low[0], texture, high[0], high[0], high[0], texture, low[1], low[1], low[1], texture, high[1],
        high[1], high[1], texture, low[2], low[2], low[2], texture, high[2], high[2], high[2], texture);
}

/* A floor, a door that slides along y, and a crate of wood that stands; a unit is a metre. */
static firma_level make_level(void) {
    static char text[8192];
    size_t at = 0;
    at += (size_t)snprintf(text, sizeof text, "{\n\"classname\" \"worldspawn\"\n");
    at += put_box(text + at, sizeof text - at, (const int[]){-20, -20, -2}, (const int[]){20, 20, 0}, "rock");
    at += (size_t)snprintf(text + at, sizeof text - at,
                           "}\n{\n\"classname\" \"func_door\"\n\"angle\" \"90\"\n\"speed\" \"2\"\n\"lip\" \"1\"\n");
    at += put_box(text + at, sizeof text - at, (const int[]){4, 0, 0}, (const int[]){6, 1, 3}, "steel");
    at += (size_t)snprintf(
        text + at, sizeof text - at,
        "}\n{\n\"classname\" \"func_breakable\"\n\"health\" \"40\"\n\"dmg\" \"7\"\n\"type\" \"wood\"\n");
    at += put_box(text + at, sizeof text - at, (const int[]){-6, -1, 0}, (const int[]){-4, 1, 2}, "planks");
    at += (size_t)snprintf(text + at, sizeof text - at, "}\n{\n\"classname\" \"func_mystery\"\n");
    at += put_box(text + at, sizeof text - at, (const int[]){8, 8, 0}, (const int[]){9, 9, 1}, "rock");
    at += (size_t)snprintf(text + at, sizeof text - at,
                           "}\n{\n\"classname\" \"info_player_start\"\n\"origin\" \"-5 -5 60\"\n}\n");
    firma_level level = {0};
    CHECK_OK(firma_level_from_map(text, at, "parts.map", 1, &level));
    return level;
}

static firma_part_info info_of(firma_parts parts, uint32_t index) {
    firma_part_info info = {.size = sizeof info};
    CHECK_OK(firma_parts_get(parts, index, &info));
    return info;
}

static void test_paths(void) {
    firma_part_path path;
    firma_part_path_defaults(&path);
    const firma_part_stop stops[2] = {{{0, 0, 0}, 0, 0, 2}, {{0, 0, 4}, 0, 3, 2}};
    path.stops = stops;
    path.stop_count = 2;
    firma_pose pose;
    firma_motion motion;
    double next = 0;
    uint32_t shut = 9;
    CHECK_OK(firma_part_path_pose(&path, 1, &pose));
    CHECK(pose.position[2] == 2 && pose.rotation[3] == 1 && pose.scale == 1);
    CHECK_OK(firma_part_path_motion(&path, 1, 1.5, &motion));
    CHECK(motion.position[2] == 2 && fabs(motion.path[2] - 1) < 1e-12 && motion.turn[2] == 0);
    CHECK_OK(firma_part_path_next_stop(&path, 1, &next));
    CHECK(next == 2);
    CHECK_OK(firma_part_path_next_stop(&path, 100, &next));
    CHECK(isinf(next));
    CHECK_OK(firma_part_path_at_first_stop(&path, 1, &shut));
    CHECK(shut == 0);
    CHECK_OK(firma_part_path_at_first_stop(&path, 100, &shut));
    CHECK(shut == 1);
    path.spin = 1;
    CHECK_OK(firma_part_path_motion(&path, 0, 0.5, &motion));
    CHECK(fabs(motion.turn[2] - 0.5) < 1e-12);

    CHECK_FAILS(firma_part_path_pose(&path, NAN, &pose), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    CHECK_FAILS(firma_part_path_motion(&path, 0, INFINITY, &motion), FIRMA_ERROR_OUT_OF_RANGE, "seconds");
    CHECK_FAILS(firma_part_path_pose(NULL, 0, &pose), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_part_path_pose(&path, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
    path.spin = NAN;
    CHECK_FAILS(firma_part_path_pose(&path, 0, &pose), FIRMA_ERROR_OUT_OF_RANGE, "path");
    path.spin = 0;
    path.repeats = 2;
    CHECK_FAILS(firma_part_path_pose(&path, 0, &pose), FIRMA_ERROR_INVALID, "repeats");
    path.repeats = 0;
    const firma_part_stop bad[1] = {{{0, NAN, 0}, 0, 0, 2}};
    path.stops = bad;
    path.stop_count = 1;
    CHECK_FAILS(firma_part_path_pose(&path, 0, &pose), FIRMA_ERROR_OUT_OF_RANGE, "stop 0");
    path.stops = NULL;
    CHECK_FAILS(firma_part_path_pose(&path, 0, &pose), FIRMA_ERROR_BAD_CALL, "count");
    path.size = 4;
    CHECK_FAILS(firma_part_path_pose(&path, 0, &pose), FIRMA_ERROR_BAD_CALL, "size");
}

static void test_parts(firma_level level, firma_world world) {
    firma_parts parts = {0};
    CHECK_OK(firma_parts_from_level(level, NULL, &parts));
    size_t count = 0;
    CHECK_OK(firma_parts_get_count(parts, &count));
    CHECK(count == 3);
    const firma_part_info door = info_of(parts, 0), crate = info_of(parts, 1);
    CHECK(door.entity == 1 && door.when_blocked == FIRMA_BLOCKED_RETURNS && door.waits_for_trigger && !door.breaks);
    CHECK(door.face_count == 6 && door.low[0] == 4 && door.high[2] == 3 && door.motion.position[1] == 0);
    CHECK(crate.entity == 2 && crate.breaks && !crate.waits_for_trigger);
    firma_part_path path = {.size = sizeof path};
    firma_pose pose;
    CHECK_OK(firma_parts_path(parts, 0, &path));
    CHECK(path.stop_count == 2);
    CHECK_OK(firma_part_path_pose(&path, 1.5, &pose));
    CHECK(fabs(pose.position[1] - 2) < 1e-9); /* 1 m deep and 2 units more, less the lip, at 2 m/s */
    uint32_t entities[2] = {0, 0};
    const char* notes[2] = {NULL, NULL};
    CHECK_OK(firma_parts_notes(parts, entities, notes, 2, &count));
    CHECK(count == 1 && entities[0] == 3 && strstr(notes[0], "stands"));
    firma_world solid = {0};
    CHECK_OK(firma_parts_world(parts, 1, &solid));
    firma_mass mass;
    CHECK_OK(firma_world_mass(solid, 1, &mass));
    CHECK(fabs(mass.volume - 8) < 1e-9);
    CHECK_OK(firma_world_release(solid));
    uint32_t portal = 0;
    CHECK_OK(firma_parts_portals(parts, 0, world, &portal, 1, &count));
    CHECK(count == 0);
    const firma_pose there = {{5, 0.5, 3}, {0, 0, 0, 1}, 1};
    CHECK_OK(firma_parts_pose_in(parts, 0, 0, &there, &pose));
    CHECK(pose.position[0] == 5 && pose.scale == 1);
    /* What was added by hand has neither path nor health. */
    firma_part mine;
    firma_part_defaults(&mine);
    const firma_world room = make_room();
    mine.world = room;
    uint32_t index = 0;
    CHECK_OK(firma_parts_add(parts, &mine, &index));
    CHECK(index == 3 && info_of(parts, 3).entity == FIRMA_NO_PART);
    CHECK_OK(firma_parts_path(parts, 3, &path));
    CHECK(path.stop_count == 0);
    firma_breakable breakable = {.size = sizeof breakable};
    CHECK_OK(firma_parts_breakable(parts, 3, &breakable));
    CHECK(breakable.health == 0 && breakable.matter == FIRMA_NO_MATTER);
    CHECK_OK(firma_world_release(room));

    firma_part_info info = {.size = sizeof info};
    CHECK_FAILS(firma_parts_get(parts, 4, &info), FIRMA_ERROR_OUT_OF_RANGE, "no part 4");
    CHECK_FAILS(firma_parts_get((firma_parts){0}, 0, &info), FIRMA_ERROR_BAD_HANDLE, "parts");
    CHECK_FAILS(firma_parts_path(parts, 4, &path), FIRMA_ERROR_OUT_OF_RANGE, "no part");
    CHECK_FAILS(firma_parts_world(parts, 4, &solid), FIRMA_ERROR_OUT_OF_RANGE, "no part");
    CHECK_FAILS(firma_parts_breakable(parts, 4, &breakable), FIRMA_ERROR_OUT_OF_RANGE, "no part");
    CHECK_FAILS(firma_parts_portals(parts, 0, world, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_parts_pose_in(parts, 0, 2, &there, &pose), FIRMA_ERROR_OUT_OF_RANGE, "fraction");
    CHECK_FAILS(firma_parts_from_level((firma_level){0}, NULL, &parts), FIRMA_ERROR_BAD_HANDLE, "level");
    CHECK_OK(firma_parts_release(parts));
}

static void test_breaks(firma_level level, firma_world world) {
    firma_parts parts = {0};
    firma_bodies bodies = {0};
    firma_debris debris = {0};
    CHECK_OK(firma_parts_from_level(level, NULL, &parts));
    CHECK_OK(firma_bodies_create(&bodies));
    CHECK_OK(firma_debris_create(&debris));
    firma_breakable crate = {.size = sizeof crate};
    CHECK_OK(firma_parts_breakable(parts, 1, &crate));
    CHECK(crate.health == 40 && crate.damage == 7 && crate.max_taken == 0.5 && fabs(crate.whole - 8) < 1e-9);
    CHECK(crate.matter != FIRMA_NO_MATTER && !crate.broken);
    uint32_t breaks = 9;
    CHECK_OK(firma_breakable_hurt(&crate, 30, &breaks));
    CHECK(breaks == 0 && crate.health == 10);
    firma_blast blast;
    firma_blast_defaults(&blast);
    const double at[3] = {-5, 4, 1};
    memcpy(blast.at, at, sizeof at);
    double share = 0;
    CHECK_OK(firma_parts_blast_felt(parts, 1, world, &blast, 0, &share));
    CHECK(fabs(share - 0.25) < 1e-9);
    CHECK_OK(firma_breakable_hurt(&crate, 40 * share, &breaks));
    CHECK(breaks == 1);
    firma_break_options options;
    firma_break_options_defaults(&options);
    CHECK(options.max_pieces == 12 && options.max_spheres == 12 && options.min_volume == 0.001);
    options.has_impact = 1;
    memcpy(options.impact, at, sizeof at);
    firma_break_report report = {.size = sizeof report};
    firma_world after = {0};
    CHECK_OK(firma_parts_break(parts, 1, world, &crate, debris, bodies, &options, &after, &report));
    CHECK(report.pieces >= 6 && report.unfit == 0 && report.opened == 0 && crate.broken == 1);
    CHECK(hash_of(after) == hash_of(world) && info_of(parts, 1).face_count == 0);
    CHECK_OK(firma_world_release(after));
    size_t count = 0;
    CHECK_OK(firma_debris_named(debris, FIRMA_DEBRIS_PIECES, NULL, 0, &count));
    CHECK(count == report.pieces);
    firma_body_id first;
    firma_debris_piece piece = {.size = sizeof piece};
    CHECK_OK(firma_debris_named(debris, FIRMA_DEBRIS_PIECES, &first, 1, &count));
    CHECK_OK(firma_debris_get(debris, bodies, first, &piece));
    CHECK(piece.of_part == 1 && piece.matter == crate.matter && piece.broken == 1);
    /* Once more: nothing is there. */
    CHECK_OK(firma_parts_break(parts, 1, world, NULL, debris, bodies, NULL, &after, &report));
    CHECK(report.pieces == 0);
    CHECK_OK(firma_world_release(after));

    /* The door, cut over its foot: what is above falls, the foot stays. */
    const firma_cutter saw = make_box(3, -1, 1, 7, 2, 1.5);
    const firma_pose here = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    firma_part_cut_options cutting;
    firma_part_cut_options_defaults(&cutting);
    CHECK(cutting.touch == 1.0 / 32 && cutting.pieces.max_pieces == 12);
    firma_part_cut cut = {.size = sizeof cut, .rest = {.size = sizeof cut.rest}};
    CHECK_OK(firma_parts_carve(parts, 0, world, NULL, saw, &here, debris, bodies, &cutting, &after, &cut));
    CHECK(cut.status == FIRMA_CARVE_DONE && cut.loose == 1 && !cut.broke && fabs(cut.volume - 1) < 1e-9);
    CHECK(info_of(parts, 0).high[2] == 1);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_debris_named(debris, FIRMA_DEBRIS_LOOSE, &first, 1, &count));
    CHECK(count == 1);
    CHECK_OK(firma_debris_world(debris, bodies, first, &after));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_parts_carve(parts, 0, world, NULL, saw, &here, debris, bodies, NULL, &after, &cut));
    CHECK(cut.status == FIRMA_CARVE_NOTHING && cut.loose == 0);
    CHECK_OK(firma_world_release(after));
    /* Most of the foot: the rest breaks. */
    firma_breakable foot = {.size = sizeof foot};
    CHECK_OK(firma_parts_breakable(parts, 0, &foot));
    const firma_cutter chisel = make_box(3, -1, -1, 5.25, 2, 2);
    CHECK_OK(firma_parts_carve(parts, 0, world, &foot, chisel, &here, debris, bodies, &cutting, &after, &cut));
    CHECK(cut.broke == 1 && cut.rest.pieces >= 1 && foot.broken == 1 && info_of(parts, 0).face_count == 0);
    CHECK_OK(firma_world_release(after));

    uint64_t before = 0, unchanged = 1;
    CHECK_OK(firma_bodies_hash(bodies, &before));
    after.id = 77;
    options.fraction = 2;
    CHECK_FAILS(firma_parts_break(parts, 2, world, NULL, debris, bodies, &options, &after, NULL),
                FIRMA_ERROR_OUT_OF_RANGE, "option");
    options.unbroken = 2;
    CHECK_FAILS(firma_parts_break(parts, 2, world, NULL, debris, bodies, &options, &after, NULL), FIRMA_ERROR_INVALID,
                "flag");
    foot.matter = 99;
    CHECK_FAILS(firma_parts_break(parts, 2, world, &foot, debris, bodies, NULL, &after, NULL), FIRMA_ERROR_INVALID,
                "matter");
    foot.max_taken = 2;
    CHECK_FAILS(firma_parts_break(parts, 2, world, &foot, debris, bodies, NULL, &after, NULL), FIRMA_ERROR_OUT_OF_RANGE,
                "breakable");
    CHECK_FAILS(firma_breakable_hurt(&crate, NAN, &breaks), FIRMA_ERROR_OUT_OF_RANGE, "damage");
    CHECK_FAILS(firma_breakable_hurt(&crate, 1, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_parts_break(parts, 9, world, NULL, debris, bodies, NULL, &after, NULL), FIRMA_ERROR_OUT_OF_RANGE,
                "no part 9");
    CHECK_FAILS(firma_parts_break(parts, 2, world, NULL, (firma_debris){0}, bodies, NULL, &after, NULL),
                FIRMA_ERROR_BAD_HANDLE, "debris");
    cutting.touch = NAN;
    CHECK_FAILS(firma_parts_carve(parts, 2, world, NULL, saw, &here, debris, bodies, &cutting, &after, NULL),
                FIRMA_ERROR_OUT_OF_RANGE, "touch");
    cutting.hold_largest = 3;
    CHECK_FAILS(firma_parts_carve(parts, 2, world, NULL, saw, &here, debris, bodies, &cutting, &after, NULL),
                FIRMA_ERROR_INVALID, "hold_largest");
    CHECK_FAILS(firma_parts_carve(parts, 2, world, NULL, saw, NULL, debris, bodies, NULL, &after, NULL),
                FIRMA_ERROR_BAD_CALL, "null");
    CHECK(after.id == 77 && info_of(parts, 2).face_count == 6);
    CHECK_OK(firma_bodies_hash(bodies, &unchanged));
    CHECK(before == unchanged);
    CHECK_OK(firma_cutter_release(chisel));
    CHECK_OK(firma_cutter_release(saw));
    CHECK_OK(firma_debris_release(debris));
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_parts_release(parts));
}

void test_level_parts(void) {
    const size_t before = firma_live_handles();
    const firma_level level = make_level();
    firma_world world = {0};
    CHECK_OK(firma_world_from_level(level, NULL, &world));
    test_paths();
    test_parts(level, world);
    test_breaks(level, world);
    /* What holds the entities: the door and the crate on the floor, the player 36 units above it. */
    firma_parts parts = {0};
    firma_supports supports = {0};
    CHECK_OK(firma_parts_from_level(level, NULL, &parts));
    CHECK_OK(firma_supports_from_level(world, level, parts, &supports));
    size_t count = 0;
    CHECK_OK(firma_supports_get_count(supports, &count));
    CHECK(count == 4);
    firma_support support = {.size = sizeof support};
    CHECK_OK(firma_supports_get(supports, 0, &support));
    CHECK(support.entity == 1 && fabs(support.area - 2) < 1e-9 && support.face_count >= 1);
    CHECK_OK(firma_supports_get(supports, 3, &support));
    CHECK(support.entity == 4 && support.kind == FIRMA_SUPPORT_STANDS && fabs(support.lowered - 36) < 1e-9);
    CHECK_OK(firma_supports_release(supports));
    CHECK_OK(firma_parts_release(parts));
    CHECK_OK(firma_world_release(world));
    CHECK_OK(firma_level_release(level));
    CHECK(firma_live_handles() == before);
}

/* SPDX-License-Identifier: MIT */
/* The program of docs/guide.md in C: loads a level, walks through it, shoots, carves, undoes, saves. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "firma/firma_c.h"

static void fail(const char* why) {
    fprintf(stderr, "%s\n", why);
    exit(1);
}

static void must(firma_code code) {
    if (code != FIRMA_OK) fail(firma_error_message());
}

static char* read_file(const char* path, size_t* length) {
    FILE* file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END) != 0) fail("cannot read the level");
    const long end = ftell(file);
    char* text = end < 0 ? NULL : malloc((size_t)end + 1);
    rewind(file);
    if (!text || fread(text, 1, (size_t)end, file) != (size_t)end) fail("cannot read the level");
    fclose(file);
    *length = (size_t)end;
    return text;
}

/* Where the first entity stands that has this value under this key. */
static void place(const firma_level_view* level, const char* key, const char* value, double* point) {
    for (size_t e = 0; e < level->entity_count; ++e) {
        const firma_entity* entity = &level->entities[e];
        for (size_t k = 0; k < entity->key_count; ++k)
            if (entity->has_origin && strcmp(entity->keys[k], key) == 0 && strcmp(entity->values[k], value) == 0) {
                memcpy(point, entity->origin, sizeof entity->origin);
                return;
            }
    }
    fail("the level lacks a place");
}

static const char* name_of(firma_world world, uint32_t room) {
    firma_room info = {.size = sizeof info};
    must(firma_world_room(world, room, &info));
    return info.name;
}

/* to + v * s */
static void add(double* to, const double* v, double s) {
    for (int k = 0; k < 3; ++k) to[k] += v[k] * s;
}

/* One step of 1/60 s toward a place, at 4 m/s, and down. Returns 0 once the ball is there. */
static int walk(firma_world world, firma_cast_input* ball, double* fall, const double* to) {
    const double way[3] = {to[0] - ball->centre[0], to[1] - ball->centre[1], 0};
    const double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    if (length < 0.1) return 0;
    *fall -= 9.81 / 60;
    for (int k = 0; k < 3; ++k) ball->path[k] = way[k] * (4.0 / 60 / length);
    ball->path[2] += *fall / 60;
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.mask = FIRMA_STOPS_WALK;
    for (int k = 0; k < 4; ++k) { /* along four surfaces at most */
        firma_hit hit;
        must(firma_cast(world, ball, &options, &hit, NULL));
        add(ball->centre, ball->path, hit.safe_fraction);
        if (hit.status != FIRMA_HIT && hit.status != FIRMA_INITIAL_OVERLAP) break;
        if (hit.normal[2] > 0.7) *fall = 0; /* it stands on something */
        for (int a = 0; a < 3; ++a) ball->path[a] *= 1 - hit.safe_fraction;
        const double into =
            ball->path[0] * hit.normal[0] + ball->path[1] * hit.normal[1] + ball->path[2] * hit.normal[2];
        add(ball->path, hit.normal, -into); /* what is left of it, along the surface */
    }
    return 1;
}

static firma_hit shoot(const char* who, firma_world world, const firma_cast_input* shot) {
    firma_cast_options options;
    firma_cast_options_defaults(&options);
    options.mask = FIRMA_STOPS_SHOTS;
    firma_hit hit;
    must(firma_cast(world, shot, &options, &hit, NULL));
    if (hit.status == FIRMA_MISS) return printf("%s meets nothing\n", who), hit;
    firma_hit_info info = {.size = sizeof info};
    const char* material = "";
    must(firma_world_hit_info(world, &hit, &info));
    must(firma_world_material(world, hit.material, &material));
    printf("%s meets %s of %s at (%.3f, %.3f, %.3f)\n", who, material, name_of(world, info.room), hit.point[0],
           hit.point[1], hit.point[2]);
    return hit;
}

int main(void) {
    size_t length = 0;
    char* text = read_file("levels/depot.map", &length);
    firma_level level = {0};
    firma_level_view view = {.size = sizeof view};
    firma_world world = {0};
    firma_world_facts facts = {.size = sizeof facts};
    must(firma_level_from_map(text, length, "levels/depot.map", 0, &level));
    must(firma_level_get_view(level, &view));
    must(firma_world_from_level(level, NULL, &world));
    must(firma_world_get_facts(world, &facts));
    free(text);
    printf("%" PRIu64 " faces, %" PRIu64 " rooms, %" PRIu64 " portals\n", facts.face_count, facts.room_count,
           facts.portal_count);

    firma_cast_input ball = {.radius = 0.5};
    uint32_t room = 0, goal_room = 0, where = 0;
    place(&view, "classname", "info_player_start", ball.centre);
    must(firma_world_locate(world, ball.centre, &where, &room));
    printf("the player starts in %s at (%.3f, %.3f, %.3f)\n", name_of(world, room), ball.centre[0], ball.centre[1],
           ball.centre[2]);

    double stops[9][3]; /* the middle of each portal on the way, then the place itself */
    uint32_t portals[8], found = 0;
    size_t portal_count = 0;
    double goal[3];
    place(&view, "name", "office_west", goal);
    must(firma_world_locate(world, goal, &where, &goal_room));
    must(firma_world_path(world, room, goal_room, 0, portals, 8, &portal_count, &found));
    if (!found || portal_count > 8) fail("no way to office_west");
    for (size_t k = 0; k < portal_count; ++k) {
        firma_portal portal = {.size = sizeof portal};
        must(firma_world_portal(world, portals[k], &portal));
        for (int a = 0; a < 3; ++a) stops[k][a] = (portal.low[a] + portal.high[a]) * 0.5;
    }
    memcpy(stops[portal_count], goal, sizeof goal);

    double fall = 0;
    int steps = 0;
    for (size_t k = 0; k <= portal_count; ++k)
        for (; walk(world, &ball, &fall, stops[k]); ++steps) {
            uint32_t here = 0, door = 0;
            must(firma_world_locate(world, ball.centre, &where, &here));
            if (where != FIRMA_AIR || steps == 600) fail("stuck, or in a wall");
            if (here == room) continue;
            size_t count = 0;
            firma_portal portal = {.size = sizeof portal};
            must(firma_world_path(world, room, here, 0, &door, 1, &count, &found));
            must(firma_world_portal(world, door, &portal));
            printf("step %d: through %s into %s\n", steps, portal.name, name_of(world, here));
            room = here;
        }
    printf("step %d: there, at (%.3f, %.3f, %.3f)\n", steps, ball.centre[0], ball.centre[1], ball.centre[2]);

    const firma_cast_input shot = {{ball.centre[0], ball.centre[1], ball.centre[2] + 0.6}, 0, {20, 0.5, 0}};
    const firma_hit hit = shoot("the shot", world, &shot);
    firma_hit_info info = {.size = sizeof info};
    must(firma_world_hit_info(world, &hit, &info));
    printf("face %" PRIu32 ", side %" PRIu32 " of the map\n", hit.face, info.source);

    firma_cutter crater = {0};
    firma_world after = {0};
    firma_carve_report report = {.size = sizeof report};
    must(firma_cutter_crater(FIRMA_ROCKY, 7, &crater));
    const firma_pose pose = {{hit.point[0], hit.point[1], hit.point[2]}, {0, 0, 0, 1}, 0.5};
    const firma_carve_options rubble = {.size = sizeof rubble, .material = "rubble"};
    must(firma_carve(world, crater, &pose, &rubble, &after, &report));
    if (report.status != FIRMA_CARVE_DONE) fail("nothing carved");

    firma_diff diff = {0};
    firma_diff_view changes = {.size = sizeof changes};
    must(firma_world_diff(world, after, 0, &diff));
    must(firma_diff_get_view(diff, &changes));
    printf("carved %.3f m3: %zu faces removed, %zu added\n", report.volume, changes.removed_count, changes.added_count);
    for (size_t k = 0; k < changes.room_count; ++k) {
        firma_triangle_options options;
        firma_triangle_options_defaults(&options);
        options.room = changes.rooms[k];
        firma_triangles triangles = {0};
        firma_triangles_view mesh = {.size = sizeof mesh};
        must(firma_world_triangles(after, &options, &triangles));
        must(firma_triangles_get_view(triangles, &mesh));
        printf("draw %s anew: %zu triangles\n", name_of(after, changes.rooms[k]), mesh.triangle_count);
        must(firma_triangles_release(triangles));
    }
    for (size_t k = 0; k < changes.portals_added_count; ++k) {
        firma_portal hole = {.size = sizeof hole};
        must(firma_world_portal(after, changes.portals_added[k], &hole));
        printf("a hole leads from %s", name_of(after, hole.rooms[0]));
        printf(" to %s\n", name_of(after, hole.rooms[1]));
    }

    shoot("the same shot", after, &shot);
    shoot("without the crater it", world, &shot); /* undo */

    firma_world loaded = {0};
    uint64_t hash = 0, saved_hash = 0;
    must(firma_world_save(after, "build/guide.firma", 1));
    must(firma_world_load("build/guide.firma", NULL, &loaded));
    must(firma_world_hash(after, &saved_hash));
    must(firma_world_hash(loaded, &hash));
    printf("saved, loaded: hash %016" PRIx64 ", %s\n", hash, hash == saved_hash ? "the same" : "another one");

    must(firma_world_release(loaded));
    must(firma_diff_release(diff));
    must(firma_world_release(after));
    must(firma_cutter_release(crater));
    must(firma_world_release(world));
    must(firma_level_release(level));
}

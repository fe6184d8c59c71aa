// SPDX-License-Identifier: MIT
// Cuts a level and casts into it through the C API, and prints hashes of all that came back: the same from every
// machine. same_everywhere.mjs does the very same through the JavaScript API; change both or none.
//
//   same_everywhere LEVEL.obj|LEVEL.bsp CUTS CASTS
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "firma/firma_c.h"

enum { kPortions = 10, kBatch = 100, kMost = 64, kSingles = 50 };

static void must(firma_code code) {
    if (code == FIRMA_OK) return;
    fprintf(stderr, "%d: %s\n", (int)code, firma_error_message());
    exit(1);
}

// ---- random numbers: 32 bits, so that JavaScript makes the same without effort. One draw a statement. ----

static uint32_t state = 20031;

static uint32_t next(void) {
    state += 0x9E3779B9u;
    uint32_t z = state;
    z = (z ^ (z >> 16)) * 0x85EBCA6Bu;
    z = (z ^ (z >> 13)) * 0xC2B2AE35u;
    return z ^ (z >> 16);
}
static uint32_t below(uint32_t count) {
    return next() % count;
}
static uint64_t seed(void) {
    const uint64_t high = next();
    const uint64_t low = next();
    return high << 32 | low;
}
// -1 to 1, a rounded quotient
static double sign_unit(void) {
    const double whole = below(2001);
    return (whole - 1000) / 1000;
}

// ---- the hash of all bits that came back ----

static uint32_t hash_a = 1, hash_b = 2;

static void mix(uint32_t word) {
    hash_a = (hash_a ^ word) * 0x9E3779B1u;
    hash_a ^= hash_a >> 15;
    hash_b = (hash_b + word) * 0x85EBCA6Bu;
    hash_b ^= hash_b >> 13;
}
static void mix_long(uint64_t value) {
    mix((uint32_t)value);
    mix((uint32_t)(value >> 32));
}
static void mix_double(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    mix_long(bits);
}
static void mix_three(const double* values) {
    for (int axis = 0; axis < 3; ++axis) mix_double(values[axis]);
}
static void mix_hit(firma_world world, const firma_hit* hit) {
    mix(hit->status);
    mix_double(hit->fraction);
    mix_double(hit->safe_fraction);
    mix_three(hit->centre);
    mix_three(hit->point);
    mix_three(hit->normal);
    mix_three(hit->face_normal);
    mix(hit->feature);
    mix(hit->feature_index);
    mix(hit->face);
    for (int axis = 0; axis < 3; ++axis) mix((uint32_t)hit->corner[axis]);
    mix(hit->material);
    if (hit->status != FIRMA_HIT && hit->status != FIRMA_INITIAL_OVERLAP) return;
    firma_hit_info info = {.size = sizeof info};
    must(firma_world_hit_info(world, hit, &info));
    mix(info.room);
    mix(info.source);
    mix(info.source_edit);
    mix(info.mask);
    mix(info.flags);
    mix(info.other_face);
}
static void mix_near(const firma_near* near) {
    mix_three(near->point);
    mix_double(near->distance);
    mix_three(near->direction);
    mix_double(near->depth);
    mix(near->face);
    mix(near->material);
    mix(near->feature);
    mix(near->feature_index);
}
static void mix_report(const firma_carve_report* report) {
    mix(report->status);
    mix(report->retries);
    mix_long(report->candidate_faces);
    mix_long(report->faces_cut);
    mix_long(report->faces_removed);
    mix_long(report->faces_added);
    mix_double(report->scale);
    mix_double(report->volume);
}

// ---- where things happen ----

static double low[3], high[3];  // of the level as read, on the grid of 1/4096 m
static double last_cut[3];

// On the grid within the level's bounds.
static void somewhere(double* point) {
    for (int axis = 0; axis < 3; ++axis) {
        const uint32_t cells = (uint32_t)((high[axis] - low[axis]) * 4096);
        const double cell = below(cells + 1);
        point[axis] = low[axis] + cell / 4096;
    }
}

// ---- cuts ----

static unsigned cuts_done, retries;

static void draw_cutter(firma_cutter* cutter) {
    static const double corners[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    static const uint32_t triangles[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    const uint32_t shape = below(6);
    const uint64_t from = seed();
    if (shape == 5)
        must(firma_cutter_from_mesh(corners, 6, triangles, 8, "octahedron", cutter));
    else
        must(firma_cutter_crater(shape, from, cutter));
}

// As it comes, turned by whole numbers, turned evenly.
static void draw_pose(firma_pose* pose) {
    const uint32_t kind = below(3);
    somewhere(pose->position);
    if (kind == 0)
        for (int axis = 0; axis < 3; ++axis) pose->position[axis] = (double)(int)pose->position[axis];
    memcpy(last_cut, pose->position, sizeof last_cut);
    pose->rotation[0] = pose->rotation[1] = pose->rotation[2] = 0;
    pose->rotation[3] = 1;
    if (kind == 1)
        for (int k = 0; k < 4; ++k) {
            const double whole = below(201);
            pose->rotation[k] = whole - 100 + (k == 3 ? 0.5 : 0);
        }
    if (kind == 2) firma_random_turn(seed(), pose->rotation);
    const double tenths = below(26);
    pose->scale = (5 + tenths) / 10;
}

static void count_report(const firma_carve_report* report) {
    mix_report(report);
    cuts_done += report->status == FIRMA_CARVE_DONE;
    retries += report->retries;
}

static void carve_in_slices(firma_world world, firma_cutter cutter, const firma_pose* pose,
                            const firma_carve_options* options, firma_world* after, firma_carve_report* report) {
    firma_job job;
    must(firma_job_start(world, cutter, pose, options, &job));
    uint32_t finished = 0;
    while (!finished) must(firma_job_run(job, 20, &finished));
    must(firma_job_result(job, after, report));
    must(firma_job_release(job));
}

static void carve_three(firma_world world, firma_cutter cutter, firma_pose* pose, const firma_carve_options* options,
                        firma_world* after, firma_carve_report* report) {
    firma_edit edit;
    must(firma_edit_begin(world, &edit));
    for (int k = 0; k < 3; ++k) {
        if (k) count_report(report);
        must(firma_edit_carve(edit, cutter, pose, options, report));
        pose->position[k] += 0.75;
    }
    must(firma_edit_finish(edit, after));
    must(firma_edit_release(edit));
}

static firma_world cut_once(firma_world world) {
    firma_cutter cutter;
    firma_pose pose;
    firma_carve_report report = {.size = sizeof report};
    firma_world after;
    draw_cutter(&cutter);
    draw_pose(&pose);
    const uint32_t kind = below(10);
    const firma_carve_options options = {
        .size = sizeof options, .fill = kind == 0, .material = kind < 5 ? "crater" : NULL};
    const uint32_t way = below(8);
    if (way == 0)
        carve_in_slices(world, cutter, &pose, &options, &after, &report);
    else if (way == 1)
        carve_three(world, cutter, &pose, &options, &after, &report);
    else
        must(firma_carve(world, cutter, &pose, &options, &after, &report));
    count_report(&report);
    must(firma_cutter_release(cutter));
    must(firma_world_release(world));
    return after;
}

// ---- casts ----

// A third of them from the last crater; half of them rays.
static void draw_cast(firma_cast_input* input) {
    somewhere(input->centre);
    if (below(3) == 0)
        for (int axis = 0; axis < 3; ++axis) input->centre[axis] = last_cut[axis] + sign_unit();
    const double thousandths = below(700);
    input->radius = below(2) ? 0 : thousandths / 1000;
    const double length = below(2) ? 1 : 30;
    for (int axis = 0; axis < 3; ++axis) input->path[axis] = sign_unit() * length;
    if (below(8) == 0) input->path[below(3)] = 0;
}

static void draw_options(firma_cast_options* options) {
    firma_cast_options_defaults(options);
    options->sides = below(4) == 0;
    if (below(8) == 0) options->contact_offset = 0.0625;
}

static void ask_more(firma_world world, const firma_cast_input* input, const firma_cast_options* options) {
    static firma_hit hits[kMost];
    static firma_near near[kMost];
    size_t count;
    uint32_t status, found, where;
    must(firma_cast_any(world, input, options, &status));
    mix(status == FIRMA_HIT || status == FIRMA_INITIAL_OVERLAP);
    must(firma_cast_all(world, input, options, hits, kMost, &count));
    mix((uint32_t)count);
    for (size_t k = 0; k < count && k < kMost; ++k) mix_hit(world, &hits[k]);
    must(firma_overlap(world, input->centre, input->radius + 0.25, NULL, near, kMost, &count));
    mix((uint32_t)count);
    for (size_t k = 0; k < count && k < kMost; ++k) mix_near(&near[k]);
    must(firma_closest(world, input->centre, 5, NULL, near, &found));
    mix(found);
    if (found) mix_near(near);
    must(firma_world_locate(world, input->centre, &where, NULL));
    mix(where);
}

static unsigned hit_count;

static void one_batch(firma_world world, uint32_t count) {
    static firma_cast_input inputs[kBatch];
    static firma_hit hits[kBatch];
    firma_cast_options options;
    for (uint32_t k = 0; k < count; ++k) draw_cast(&inputs[k]);
    draw_options(&options);
    must(firma_cast_batch(world, inputs, count, &options, hits, NULL));
    for (uint32_t k = 0; k < count; ++k) {
        mix_hit(world, &hits[k]);
        hit_count += hits[k].status == FIRMA_HIT || hits[k].status == FIRMA_INITIAL_OVERLAP;
    }
}

static void one_by_one(firma_world world, uint32_t count) {
    for (uint32_t k = 0; k < count; ++k) {
        firma_cast_input input;
        firma_cast_options options;
        firma_hit hit;
        draw_cast(&input);
        draw_options(&options);
        must(firma_cast(world, &input, &options, &hit, NULL));
        mix_hit(world, &hit);
        hit_count += hit.status == FIRMA_HIT || hit.status == FIRMA_INITIAL_OVERLAP;
        if (k % 8 == 0) ask_more(world, &input, &options);
    }
}

// `count` casts, by turns fifty singly and a hundred in a batch.
static void cast_many(firma_world world, uint32_t count) {
    while (count) {
        const uint32_t singles = count < kSingles ? count : kSingles;
        one_by_one(world, singles);
        count -= singles;
        const uint32_t batch = count < kBatch ? count : kBatch;
        one_batch(world, batch);
        count -= batch;
    }
}

// ---- the whole ----

static firma_world read_level(const char* path) {
    FILE* file = fopen(path, "rb");
    if (!file) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(1);
    }
    size_t length = 0, room = 1 << 16;
    char* text = malloc(room);
    for (size_t got; text && (got = fread(text + length, 1, room - length, file)) > 0;) {
        length += got;
        if (length == room) text = realloc(text, room *= 2);
    }
    fclose(file);
    if (!text) exit(1);
    firma_world world;
    const char* ending = strrchr(path, '.');
    if (ending && strcmp(ending, ".bsp") == 0)
        must(firma_world_from_bsp(text, length, "level", NULL, &world));
    else
        must(firma_world_from_obj(text, length, "level", NULL, &world));
    free(text);
    return world;
}

static void say(firma_world world, unsigned cuts, unsigned casts) {
    firma_world_facts facts = {.size = sizeof facts};
    uint64_t hash;
    must(firma_world_get_facts(world, &facts));
    must(firma_world_hash(world, &hash));
    printf("cuts=%u done=%u retries=%u casts=%u hits=%u faces=%llu world=%016llx answers=%08x%08x\n", cuts, cuts_done,
           retries, casts, hit_count, (unsigned long long)facts.face_count, (unsigned long long)hash, (unsigned)hash_a,
           (unsigned)hash_b);
    fflush(stdout);
}

// The world's faces as a mesh, and a world of that.
static void say_mesh(firma_world world) {
    firma_faces faces;
    firma_faces_view view = {.size = sizeof view};
    firma_world_facts facts = {.size = sizeof facts};
    must(firma_world_faces(world, &faces));
    must(firma_faces_get_view(faces, &view));
    must(firma_world_get_facts(world, &facts));
    const size_t count = view.face_count;
    uint32_t* words = calloc(view.corner_count + 3 * count + 1, sizeof *words);
    const char** names = calloc(facts.material_count + 1, sizeof *names);
    uint8_t* two_sided = calloc(count + 1, 1);
    if (!words || !names || !two_sided) exit(1);
    uint32_t *corners = words, *counts = corners + view.corner_count, *materials = counts + count;
    uint32_t* masks = materials + count;
    for (size_t k = 0; k < view.corner_count; ++k) corners[k] = (uint32_t)k;
    for (size_t k = 0; k < count; ++k) {
        counts[k] = view.faces[k].corner_count;
        materials[k] = view.faces[k].material;
        masks[k] = view.faces[k].mask;
        two_sided[k] = view.faces[k].flags & FIRMA_FACE_TWO_SIDED;
    }
    for (uint32_t k = 0; k < facts.material_count; ++k) must(firma_world_material(world, k, &names[k]));
    const firma_mesh mesh = {.size = sizeof mesh,
                             .material_count = facts.material_count,
                             .positions = view.corners,
                             .vertex_count = view.corner_count,
                             .corners = corners,
                             .corner_counts = counts,
                             .face_count = count,
                             .materials = materials,
                             .material_names = names,
                             .masks = masks,
                             .two_sided = two_sided};
    firma_world made;
    uint64_t hash;
    must(firma_world_from_mesh(&mesh, "mesh", NULL, &made));
    must(firma_world_hash(made, &hash));
    printf("mesh=%zu world=%016llx\n", count, (unsigned long long)hash);
    must(firma_world_release(made));
    must(firma_faces_release(faces));
    free(words);
    free(names);
    free(two_sided);
}

// The same world, its left half of a harder stone.
static firma_world with_rules(firma_world world) {
    firma_zone zone = {"left half", {low[0], low[1], low[2]}, {(low[0] + high[0]) / 2, high[1], high[2]}, 0.3};
    firma_rules rules = {.size = sizeof rules, .zones = &zone, .zone_count = 1};
    firma_world harder;
    must(firma_world_with_rules(world, &rules, &harder));
    return harder;
}

// ---- a log ----

static firma_command draw_part(uint32_t number) {
    firma_command command, quantised;
    const uint32_t kind = below(8);
    if (kind == 0) {
        const uint32_t portal = below(4);
        must(firma_command_door(number, portal, below(2), &command));
        return command;
    }
    firma_cutter cutter;
    firma_pose pose;
    draw_cutter(&cutter);
    draw_pose(&pose);
    const firma_carve_options options = {
        .size = sizeof options, .fill = kind == 1, .material = kind < 4 ? "logged" : NULL, .chunks = kind != 1};
    must(firma_command_edit(number, cutter, &pose, &options, &command));
    must(firma_cutter_release(cutter));
    if (kind > 5) return command;
    must(firma_command_quantise(command, &quantised));
    must(firma_command_release(command));
    return quantised;
}

// Of every eight one is a group of three.
static firma_command draw_command(uint32_t* number) {
    if (below(8)) return draw_part(++*number);
    firma_command parts[3], group;
    for (int k = 0; k < 3; ++k) parts[k] = draw_part(++*number);
    must(firma_command_group(parts, 3, &group));
    for (int k = 0; k < 3; ++k) must(firma_command_release(parts[k]));
    return group;
}

static firma_world apply_command(firma_world world, firma_command command, bool in_slices) {
    firma_carve_report report = {.size = sizeof report};
    firma_world after;
    if (in_slices) {
        firma_job job;
        must(firma_command_start(world, command, &job));
        uint32_t finished = 0;
        while (!finished) must(firma_job_run(job, 20, &finished));
        must(firma_job_result(job, &after, &report));
        must(firma_job_release(job));
    } else {
        must(firma_command_apply(world, command, &after, &report));
    }
    mix_report(&report);
    mix_long(report.chunks);
    mix_double(report.chunk_volume);
    if (report.chunks) must(firma_chunks_release(report.loose));
    must(firma_world_release(world));
    return after;
}

// The log as bytes, and what comes of these bytes on the level, in slices: it must be `hash`.
static uint64_t replay_packed(firma_world level, firma_log log, uint64_t hash, size_t* length) {
    firma_bytes bytes;
    const void* data;
    firma_log read;
    firma_replay replay;
    firma_replay_facts facts = {.size = sizeof facts};
    firma_world world;
    uint64_t replayed;
    must(firma_log_pack(log, &bytes));
    must(firma_bytes_get_view(bytes, &data, length));
    for (size_t k = 0; k < *length; ++k) mix(((const unsigned char*)data)[k]);
    must(firma_log_unpack(data, *length, "log", &read));
    must(firma_replay_start(level, read, UINT32_MAX, &replay));
    uint32_t finished = 0;
    while (!finished) must(firma_replay_run(replay, 20, &finished));
    must(firma_replay_get_facts(replay, &facts));
    must(firma_replay_result(replay, &world));
    must(firma_world_hash(world, &replayed));
    if (replayed != hash) {
        fprintf(stderr, "a replay gives %016llx, the commands gave %016llx\n", (unsigned long long)replayed,
                (unsigned long long)hash);
        exit(1);
    }
    must(firma_world_release(world));
    must(firma_replay_release(replay));
    must(firma_log_release(read));
    must(firma_bytes_release(bytes));
    return facts.done;
}

// Commands of all kinds, a log of them, and the same with a patch in place of the first half.
static void say_log(firma_world level, unsigned count) {
    firma_log log, compact;
    uint32_t number = 0, half = 0;
    uint64_t hash;
    size_t length, compact_length;
    must(firma_log_begin(level, &log));
    firma_world world;
    must(firma_world_copy(level, &world));
    for (unsigned k = 0; k < count; ++k) {
        const firma_command command = draw_command(&number);
        world = apply_command(world, command, k % 3 == 0);
        must(firma_log_append(log, command));
        must(firma_command_release(command));
        if (k % 10 == 9) must(firma_log_checkpoint(log, world));
        if (k < count / 2) half = number;
    }
    must(firma_world_hash(world, &hash));
    const uint64_t done = replay_packed(level, log, hash, &length);
    must(firma_log_compact(log, level, half, &compact));
    replay_packed(level, compact, hash, &compact_length);
    printf("log=%zu commands=%u done=%llu compact=%zu world=%016llx answers=%08x%08x\n", length, count,
           (unsigned long long)done, compact_length, (unsigned long long)hash, (unsigned)hash_a, (unsigned)hash_b);
    must(firma_log_release(compact));
    must(firma_log_release(log));
    must(firma_world_release(world));
}

// What is only worth it once: volume and area, faces, the difference to the level, the bytes of the file and back.
static void say_rest(firma_world first, firma_world last) {
    double volume, area;
    must(firma_world_measure(last, &volume, &area));
    mix_double(volume);
    mix_double(area);
    firma_diff diff;
    firma_diff_view view = {.size = sizeof view};
    must(firma_world_diff(first, last, 4, &diff));
    must(firma_diff_get_view(diff, &view));
    for (size_t k = 0; k < view.removed_count; ++k) mix(view.removed[k]);
    for (size_t k = 0; k < view.added_count; ++k) {
        mix(view.added[k].id);
        mix_three(view.added[k].normal);
        mix(view.added[k].material);
    }
    for (size_t k = 0; k < 3 * view.corner_count; ++k) mix_double(view.corners[k]);
    for (size_t k = 0; k < 3 * view.tile_count; ++k) mix((uint32_t)view.tiles[k]);
    must(firma_diff_release(diff));
    firma_bytes bytes;
    const void* data;
    size_t length;
    must(firma_world_pack(last, 1, &bytes));
    must(firma_bytes_get_view(bytes, &data, &length));
    for (size_t k = 0; k < length; ++k) mix(((const unsigned char*)data)[k]);
    firma_world again;
    uint64_t hash;
    must(firma_world_unpack(data, length, "again", &again));
    must(firma_world_hash(again, &hash));
    printf("packed=%zu world=%016llx everything=%08x%08x\n", length, (unsigned long long)hash, (unsigned)hash_a,
           (unsigned)hash_b);
    must(firma_world_release(again));
    must(firma_bytes_release(bytes));
}

int main(int count, char** words) {
    if (count != 4) return fputs("usage: same_everywhere LEVEL CUTS CASTS\n", stderr), 2;
    const unsigned cuts = (unsigned)atoi(words[2]), casts = (unsigned)atoi(words[3]);
    const firma_world first = read_level(words[1]);
    firma_world_facts facts = {.size = sizeof facts};
    must(firma_world_get_facts(first, &facts));
    memcpy(low, facts.low, sizeof low);
    memcpy(high, facts.high, sizeof high);
    firma_world world = with_rules(first);
    say_mesh(first);
    say(world, 0, 0);
    unsigned cut = 0, cast = 0;
    for (unsigned portion = 1; portion <= kPortions; ++portion) {
        for (; cut < cuts * portion / kPortions; ++cut) world = cut_once(world);
        const unsigned until = casts * portion / kPortions;
        cast_many(world, until - cast);
        cast = until;
        say(world, cut, cast);
    }
    const firma_world level = with_rules(first);
    say_log(level, cuts / 10);
    must(firma_world_release(level));
    say_rest(first, world);
    must(firma_world_release(world));
    must(firma_world_release(first));
    return firma_live_handles() != 0;
}

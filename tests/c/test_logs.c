/* SPDX-License-Identifier: MIT */
/* Logs: kept beside a game, packed, replayed elsewhere, compacted. */
#include <stdio.h>
#include <stdlib.h>

#include "tests/c/check.h"

static firma_command crater_at(uint32_t number, double x) {
    firma_pose pose = {{x, 4, 0.1}, {0, 0, 0, 1}, 0.8};
    firma_cutter crater = {0};
    firma_command exact = {0}, command = {0};
    firma_random_turn(number, pose.rotation);
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, number, &crater));
    CHECK_OK(firma_command_edit(number, crater, &pose, NULL, &exact));
    CHECK_OK(firma_command_quantise(exact, &command));
    CHECK_OK(firma_command_release(exact));
    CHECK_OK(firma_cutter_release(crater));
    return command;
}

/* Four craters with a checkpoint after each second; the world after them. */
static firma_world play(firma_world room, firma_log log) {
    firma_world now = {0};
    CHECK_OK(firma_world_copy(room, &now));
    for (uint32_t k = 1; k <= 4; ++k) {
        const firma_command command = crater_at(10 * k, 1.5 * k);
        firma_world after = {0};
        CHECK_OK(firma_log_append(log, command));
        CHECK_FAILS(firma_log_append(log, command), FIRMA_ERROR_INVALID, "");
        CHECK_OK(firma_command_apply(now, command, &after, NULL));
        CHECK_OK(firma_world_release(now));
        CHECK_OK(firma_command_release(command));
        now = after;
        if (k % 2 == 0) CHECK_OK(firma_log_checkpoint(log, now));
    }
    return now;
}

static firma_log read_back(firma_log log) {
    firma_bytes bytes = {0};
    firma_log read = {0}, none = {0};
    const void* data = NULL;
    size_t length = 0;
    CHECK_OK(firma_log_pack(log, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    CHECK_OK(firma_log_unpack(data, length, "game", &read));
    unsigned char* const damaged = malloc(length);
    memcpy(damaged, data, length);
    damaged[length / 2] ^= 1;
    CHECK_FAILS(firma_log_unpack(damaged, length, "game", &none), FIRMA_ERROR_MALFORMED, "game");
    CHECK_FAILS(firma_log_unpack(damaged, 3, NULL, &none), FIRMA_ERROR_MALFORMED, "log");
    free(damaged);
    CHECK_OK(firma_bytes_release(bytes));
    return read;
}

static void check_facts(firma_log log, firma_world room) {
    firma_log_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_log_get_facts(log, &facts));
    CHECK(facts.level_edits == 0 && facts.level_hash == hash_of(room) && facts.rules_hash != 0);
    CHECK(facts.command_count == 4 && facts.checkpoint_count == 2 && facts.patch_bytes == 0);
    CHECK(facts.last_number == 40 && facts.patched_number == 0);
    firma_command command = {0};
    firma_command_view view = {.size = sizeof view};
    CHECK_OK(firma_log_command(log, 2, &command));
    CHECK_OK(firma_command_get_view(command, &view));
    CHECK(view.number == 30 && view.seed == 30);
    CHECK_OK(firma_command_release(command));
    CHECK_FAILS(firma_log_command(log, 4, &command), FIRMA_ERROR_OUT_OF_RANGE, "no such command");
}

/* In slices of one piece of work; the hash of what came of it. The reason in `facts`, of the replay, goes with it. */
static uint64_t replayed(firma_world room, firma_log log, uint32_t last_number, firma_replay_facts* facts) {
    firma_replay replay = {0};
    firma_world after = {0};
    uint32_t finished = 0;
    CHECK_OK(firma_replay_start(room, log, last_number, &replay));
    CHECK_FAILS(firma_replay_run(replay, -1, &finished), FIRMA_ERROR_INVALID, "time");
    CHECK_OK(firma_replay_get_facts(replay, facts));
    CHECK(facts->finished == 0 && facts->commands_behind == 0);
    uint64_t behind = 0;
    while (!finished) {
        CHECK_OK(firma_replay_run(replay, 0, &finished));
        CHECK_OK(firma_replay_get_facts(replay, facts));
        CHECK(facts->commands_behind >= behind && facts->commands_behind <= facts->commands_in_all);
        behind = facts->commands_behind;
    }
    CHECK_OK(firma_replay_result(replay, &after));
    const uint64_t hash = hash_of(after);
    CHECK(facts->error && !*facts->error);
    facts->error = NULL;
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_replay_release(replay));
    return hash;
}

static void test_replay(firma_world room, firma_log log, firma_world now) {
    firma_replay_facts facts = {.size = sizeof facts};
    CHECK(replayed(room, log, UINT32_MAX, &facts) == hash_of(now));
    CHECK(facts.finished == 1 && facts.applied == 4 && facts.done == 4 && facts.refused == 0 && facts.nothing == 0);
    CHECK(facts.checkpoints == 2 && facts.commands_in_all == 4);
    CHECK(replayed(room, log, 25, &facts) != hash_of(now));
    CHECK(facts.applied == 2 && facts.checkpoints == 1);
    firma_replay replay = {0};
    firma_world after = {0};
    uint32_t finished = 0;
    CHECK_OK(firma_replay_start(now, log, UINT32_MAX, &replay)); /* not its level */
    CHECK_OK(firma_replay_run(replay, 1e9, &finished));
    CHECK(finished == 1);
    CHECK_OK(firma_replay_get_facts(replay, &facts));
    CHECK(facts.finished == 1 && facts.applied == 0 && strstr(facts.error, "another world"));
    const char* const error = facts.error;
    CHECK_OK(firma_replay_get_facts(replay, &facts));
    CHECK(facts.error == error);
    CHECK_FAILS(firma_replay_result(replay, &after), FIRMA_ERROR_INVALID, "another world");
    CHECK_OK(firma_replay_release(replay));
}

/* A checkpoint that lies. */
static void test_lie(firma_world room) {
    firma_log log = {0};
    firma_replay replay = {0};
    firma_world after = {0};
    uint32_t finished = 0;
    const firma_command command = crater_at(1, 4);
    CHECK_OK(firma_log_begin(room, &log));
    CHECK_OK(firma_log_append(log, command));
    CHECK_OK(firma_log_checkpoint(log, room));
    CHECK_OK(firma_replay_start(room, log, UINT32_MAX, &replay));
    while (!finished) CHECK_OK(firma_replay_run(replay, 1e9, &finished));
    CHECK_FAILS(firma_replay_result(replay, &after), FIRMA_ERROR_MALFORMED, "0");
    CHECK_OK(firma_replay_release(replay));
    CHECK_OK(firma_command_release(command));
    CHECK_OK(firma_log_release(log));
}

static void test_compact(firma_world room, firma_log log, firma_world now) {
    firma_log shorter = {0}, none = {0};
    firma_log_facts facts = {.size = sizeof facts};
    firma_replay_facts came = {.size = sizeof came};
    CHECK_OK(firma_log_compact(log, room, 30, &shorter));
    CHECK_OK(firma_log_get_facts(shorter, &facts));
    CHECK(facts.command_count == 1 && facts.patched_number == 30 && facts.patch_bytes > 0 && facts.last_number == 40);
    const firma_log read = read_back(shorter);
    CHECK(replayed(room, read, UINT32_MAX, &came) == hash_of(now));
    CHECK(came.applied == 1 && came.checkpoints == 1);
    CHECK_FAILS(firma_log_compact(shorter, room, 20, &none), FIRMA_ERROR_INVALID, "");
    CHECK_FAILS(firma_log_compact(log, now, 30, &none), FIRMA_ERROR_INVALID, "");
    CHECK_OK(firma_log_release(read));
    CHECK_OK(firma_log_release(shorter));
}

/* A file of the repository, its length in `length`. */
static unsigned char* bytes_of_file(const char* sources, const char* name, size_t* length) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", sources, name);
    FILE* const file = fopen(path, "rb");
    CHECK(file != NULL);
    if (!file) exit(1);
    fseek(file, 0, SEEK_END);
    *length = (size_t)ftell(file);
    rewind(file);
    unsigned char* const bytes = malloc(*length);
    CHECK(fread(bytes, 1, *length, file) == *length);
    fclose(file);
    return bytes;
}

/* What `firma carve --chunks --log` wrote of the depot (tests/cli/test_log.py): its brushes of firma_anchor hold. */
static void test_log_of_command_line(const char* sources) {
    size_t length = 0, log_length = 0;
    unsigned char* const text = bytes_of_file(sources, "levels/depot.map", &length);
    unsigned char* const bytes = bytes_of_file(sources, "tests/data/depot_bridge.firmalog", &log_length);
    firma_level level = {0};
    firma_level_view view = {.size = sizeof view};
    firma_world depot = {0}, held = {0}, none = {0};
    firma_log log = {0};
    CHECK_OK(firma_level_from_map((const char*)text, length, "depot.map", 0, &level));
    CHECK_OK(firma_level_get_view(level, &view));
    CHECK(view.anchor_count == 4);
    for (size_t k = 0; k < view.anchor_count; ++k)
        for (int axis = 0; axis < 3; ++axis) CHECK(view.anchors[k].low[axis] < view.anchors[k].high[axis]);
    CHECK_OK(firma_world_from_level(level, NULL, &depot));
    CHECK_OK(firma_log_unpack(bytes, log_length, "depot_bridge", &log));
    const firma_anchors anchors = {.size = sizeof anchors, .volumes = view.anchors, .volume_count = view.anchor_count};
    CHECK_OK(firma_world_with_anchors(depot, &anchors, &held));
    firma_replay_facts facts = {.size = sizeof facts};
    CHECK(replayed(held, log, UINT32_MAX, &facts) == 0xe1f4b967d5727f35);
    CHECK(facts.done == 3 && facts.checkpoints == 1);
    CHECK_OK(firma_world_release(held));
    /* Without the volumes it is refused. */
    firma_replay replay = {0};
    CHECK_OK(firma_world_with_anchors(depot, NULL, &held));
    CHECK_OK(firma_replay_start(held, log, UINT32_MAX, &replay));
    CHECK_OK(firma_replay_get_facts(replay, &facts));
    CHECK(facts.finished == 1 && facts.applied == 0 && strstr(facts.error, "other anchors"));
    CHECK_FAILS(firma_replay_result(replay, &none), FIRMA_ERROR_INVALID, "other anchors");
    CHECK_OK(firma_replay_release(replay));
    CHECK_OK(firma_log_release(log));
    CHECK_OK(firma_world_release(held));
    CHECK_OK(firma_world_release(depot));
    CHECK_OK(firma_level_release(level));
    free(bytes);
    free(text);
}

void test_logs(const char* sources) {
    test_log_of_command_line(sources);
    const firma_world room = make_room();
    firma_log log = {0};
    CHECK_OK(firma_log_begin(room, &log));
    const firma_world now = play(room, log);
    const firma_log read = read_back(log);
    check_facts(log, room);
    check_facts(read, room);
    test_replay(room, read, now);
    test_lie(room);
    test_compact(room, read, now);
    CHECK_FAILS(firma_log_begin(room, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_log_release(read));
    CHECK_FAILS(firma_log_pack(read, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_log_checkpoint(read, room), FIRMA_ERROR_BAD_HANDLE, "log");
    CHECK_OK(firma_log_release(log));
    CHECK_OK(firma_world_release(now));
    CHECK_OK(firma_world_release(room));
}

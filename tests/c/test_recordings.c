/* SPDX-License-Identifier: MIT */
/* Games recorded, replayed, packed, saved; bad arguments and calls out of order. */
#include <stddef.h>

#include "tests/c/small_game.h"

static uint64_t game_hash(firma_game game) {
    uint64_t hash = 0;
    CHECK_OK(firma_game_hash(game, &hash));
    return hash;
}

static firma_game_replay replay_of(firma_game game) {
    firma_game_replay replay = {.size = sizeof replay};
    CHECK_OK(firma_game_get_replay(game, &replay));
    return replay;
}

/* Steps a replay to its end. */
static firma_game_replay played(firma_recording recording, uint64_t* hash) {
    firma_game game = {0};
    CHECK_OK(firma_recording_replay(recording, &game));
    firma_game_replay replay = replay_of(game);
    while (!replay.finished) {
        CHECK_OK(firma_game_step(game));
        replay = replay_of(game);
    }
    CHECK_FAILS(firma_game_step(game), FIRMA_ERROR_BAD_CALL, "over");
    CHECK(replay.differs || replay.text[0] == 0);
    *hash = game_hash(game);
    CHECK_OK(firma_game_release(game));
    replay.text = "";
    return replay;
}

static void test_orders(firma_world room) {
    firma_game game = make_game(room), other = {0};
    firma_recording recording = {77};
    firma_game_replay replay = {.size = sizeof replay};
    CHECK_FAILS(firma_game_recording(game, &recording), FIRMA_ERROR_BAD_CALL, "firma_game_record()");
    CHECK_FAILS(firma_game_get_replay(game, &replay), FIRMA_ERROR_BAD_CALL, "no replay");
    CHECK_OK(firma_game_record(game, "room"));
    CHECK_FAILS(firma_game_record(game, "room"), FIRMA_ERROR_BAD_CALL, "already");
    firma_game_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_game_get_facts(game, &facts));
    CHECK(facts.recorded && !facts.replay);

    /* What a recording does not keep may not be changed. */
    firma_game_rules rules;
    firma_game_rules_defaults(&rules);
    firma_weapon weapon;
    firma_weapon_defaults(&weapon);
    firma_game_part part;
    firma_game_part_defaults(&part);
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_BAD_CALL, "recorded");
    CHECK_FAILS(firma_game_set_weapon(game, 0, &weapon), FIRMA_ERROR_BAD_CALL, "recorded");
    CHECK_FAILS(firma_game_add_weapon(game, &weapon, NULL), FIRMA_ERROR_BAD_CALL, "recorded");
    CHECK_FAILS(firma_game_add_part(game, &part, NULL), FIRMA_ERROR_BAD_CALL, "recorded");

    /* What happened after the last tick is in no tick yet. */
    CHECK_OK(firma_game_set_off(game, 0));
    CHECK_FAILS(firma_game_recording(game, &recording), FIRMA_ERROR_BAD_CALL, "step the game first");
    CHECK_FAILS(firma_game_recording(game, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(recording.id == 77);
    CHECK_OK(firma_game_step(game));
    CHECK_OK(firma_game_recording(game, &recording));
    /* A copy is not recorded. */
    CHECK_OK(firma_game_copy(game, &other));
    CHECK_OK(firma_game_set_rules(other, &rules));
    CHECK_OK(firma_game_release(other));

    CHECK_OK(firma_recording_replay(recording, &other));
    const double at[3] = {4, 4, 2};
    firma_charge charge;
    firma_charge_defaults(&charge);
    CHECK_FAILS(firma_game_explode(other, at, &charge), FIRMA_ERROR_BAD_CALL, "replay");
    CHECK_FAILS(firma_game_fire(other, 0, at, at), FIRMA_ERROR_BAD_CALL, "replay");
    CHECK_FAILS(firma_game_set_off(other, 0), FIRMA_ERROR_BAD_CALL, "replay");
    CHECK_FAILS(firma_game_set_rules(other, &rules), FIRMA_ERROR_BAD_CALL, "replay");
    CHECK_FAILS(firma_game_record(other, NULL), FIRMA_ERROR_BAD_CALL, "replay");
    CHECK_FAILS(firma_game_recording(other, &recording), FIRMA_ERROR_BAD_CALL, "not being recorded");
    CHECK_FAILS(firma_recording_replay(recording, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_recording_replay((firma_recording){game.id}, &other), FIRMA_ERROR_BAD_HANDLE, "recording");
    CHECK_FAILS(firma_recording_replay((firma_recording){0}, &other), FIRMA_ERROR_BAD_HANDLE, "recording");
    replay.size = 4;
    CHECK_FAILS(firma_game_get_replay(other, &replay), FIRMA_ERROR_BAD_CALL, "size");
    /* The recording may go before its replay. */
    CHECK_OK(firma_recording_release(recording));
    CHECK_OK(firma_game_step(other));
    CHECK(replay_of(other).finished && replay_of(other).ticks == 1);
    CHECK_OK(firma_game_release(other));
    CHECK_OK(firma_game_release(game));
}

static void test_replays(firma_world room, const char* folder) {
    char path[512];
    snprintf(path, sizeof path, "%s/test_recordings.firmarec", folder);
    firma_game game = make_game(room), start = {0}, end = {0};
    const uint64_t first = game_hash(game);
    CHECK_OK(firma_game_record(game, "room"));
    fight(game, 0, 30);
    firma_recording half = {0}, whole = {0}, read = {0};
    CHECK_OK(firma_game_recording(game, &half));
    const uint64_t middle = game_hash(game);
    fight(game, 30, 70);
    const uint64_t last = game_hash(game);
    CHECK_OK(firma_game_recording(game, &whole));

    firma_recording_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_recording_get_facts(half, &facts));
    CHECK(facts.ticks == 30 && facts.events == 5 && facts.rate == 60 && facts.first_tick == 0);
    CHECK(strcmp(facts.level, "room") == 0 && facts.level_hash == hash_of(room));
    CHECK_OK(firma_recording_get_facts(whole, &facts));
    CHECK(facts.ticks == 70 && facts.events == 6);

    static const uint32_t kinds[6] = {FIRMA_EVENT_PART, FIRMA_EVENT_FIRE, FIRMA_EVENT_BLAST,
                                      FIRMA_EVENT_WISH, FIRMA_EVENT_FIRE, FIRMA_EVENT_EDIT};
    static const uint64_t ticks[6] = {2, 5, 8, 20, 20, 50};
    firma_game_event event = {.size = sizeof event};
    for (size_t k = 0; k < 6; ++k) {
        CHECK_OK(firma_recording_event(whole, k, &event));
        CHECK(event.kind == kinds[k] && event.tick == ticks[k]);
        if (k == 1) CHECK(event.index == 1 && event.position[0] == 6 && event.velocity[0] == -30);
        if (k == 2) CHECK(event.position[1] == 2.9 && event.velocity[0] == 0);
        if (k == 3) CHECK(event.index == 0 && event.velocity[1] == -1);
        if (k == 5) CHECK(event.position[0] == 6);
    }
    CHECK_FAILS(firma_recording_event(whole, 6, &event), FIRMA_ERROR_OUT_OF_RANGE, "event 6");

    /* Each replay is as recorded, also from bytes and from a file. */
    uint64_t hash = 0;
    firma_game_replay replay = played(half, &hash);
    CHECK(replay.ticks == 30 && replay.ticks_in_all == 30 && !replay.differs && hash == middle);
    firma_bytes bytes = {0}, again = {0};
    const void *data = NULL, *same = NULL;
    size_t length = 0, same_length = 0;
    CHECK_OK(firma_recording_pack(whole, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    uint32_t kind = 77;
    CHECK_OK(firma_game_bytes_kind(data, length, &kind));
    CHECK(kind == FIRMA_BYTES_RECORDING);
    CHECK_OK(firma_recording_unpack(data, length, "fight", &read));
    replay = played(read, &hash);
    CHECK(replay.ticks == 70 && !replay.differs && hash == last);
    CHECK_OK(firma_recording_save(read, path));
    CHECK_OK(firma_recording_release(read));
    CHECK_OK(firma_recording_load(path, &read));
    CHECK_OK(firma_recording_pack(read, &again));
    CHECK_OK(firma_bytes_get_view(again, &same, &same_length));
    CHECK(same_length == length && memcmp(same, data, length) == 0);
    remove(path);

    /* Both of its games, which go their own way. */
    CHECK_OK(firma_recording_game(read, 0, &start));
    CHECK_OK(firma_recording_game(read, 1, &end));
    CHECK(game_hash(start) == first && game_hash(end) == last);
    fight(start, 0, 70);
    CHECK(game_hash(start) == last);
    CHECK_FAILS(firma_recording_game(read, 2, &end), FIRMA_ERROR_INVALID, "at_end");
    CHECK_OK(firma_game_release(start));
    CHECK_OK(firma_game_release(end));

    /* A replay is shown as a game is: what happens is in its report; a copy taken in its middle is played on. */
    firma_game shown = {0}, taken = {0};
    CHECK_OK(firma_recording_replay(read, &shown));
    firma_game_report report = {.size = sizeof report};
    for (int tick = 0; tick < 9; ++tick) CHECK_OK(firma_game_step(shown));
    CHECK_OK(firma_game_get_report(shown, &report));
    CHECK(report.blasts >= 1 && report.moves == 1 && report.loose > 0);
    for (int tick = 9; tick < 30; ++tick) CHECK_OK(firma_game_step(shown));
    CHECK(game_hash(shown) == middle && !replay_of(shown).finished && replay_of(shown).ticks == 30);
    CHECK_OK(firma_game_copy(shown, &taken));
    fight(taken, 30, 70);
    CHECK(game_hash(taken) == last);
    CHECK_OK(firma_game_release(taken));
    CHECK_OK(firma_game_release(shown));

    CHECK_OK(firma_recording_release(read));
    read.id = 77;
    CHECK_FAILS(firma_recording_unpack(data, length - 1, "cut", &read), FIRMA_ERROR_MALFORMED, "cut");
    CHECK_FAILS(firma_recording_unpack(NULL, 1, NULL, &read), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_recording_load("/no/such/a.firmarec", &read), FIRMA_ERROR_CANNOT_READ, "/no/such");
    CHECK_FAILS(firma_recording_save(whole, "/no/such/folder/a.firmarec"), FIRMA_ERROR_CANNOT_WRITE, "/no/such/folder");
    CHECK_FAILS(firma_recording_pack(whole, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_recording_get_facts((firma_recording){0}, &facts), FIRMA_ERROR_BAD_HANDLE, "recording");
    CHECK(read.id == 77);
    CHECK_OK(firma_bytes_release(again));
    CHECK_OK(firma_bytes_release(bytes));
    CHECK_OK(firma_recording_release(half));
    CHECK_OK(firma_recording_release(whole));
    CHECK_OK(firma_game_release(game));
}

void test_recordings(const char* folder) {
    const size_t before = firma_live_handles();
    const firma_world room = make_hung_room();
    test_orders(room);
    test_replays(room, folder);
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}

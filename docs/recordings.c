/* SPDX-License-Identifier: MIT */
/* The program of docs/recordings.md in C: a game is recorded while it is played, saved, and replayed. */
#include <stdio.h>

#include "firma/firma_c.h"

static void must(firma_code code) {
    if (code != FIRMA_OK) puts(firma_error_message());
}

/* What happens before a tick, as a player and a program decide it. */
static void play(firma_game game, uint64_t tick) {
    const firma_player_wish walk = {.size = sizeof walk, .velocity = {2, 1, 0}};
    const double muzzle[3] = {32, 29, 2}, way[3] = {-30, 0, 8}, ends[2][3] = {{22, 29, 4.75}, {42, 29, 4.75}};
    firma_charge charge;
    firma_charge_defaults(&charge);
    charge.crater = 3;
    charge.break_radius = 8;
    if (tick == 30) must(firma_game_wish(game, 0, &walk));
    if (tick == 60) must(firma_game_fire(game, 1, muzzle, way)); /* a rocket */
    if (tick == 90) must(firma_game_explode(game, ends[0], &charge));
    if (tick == 120) must(firma_game_explode(game, ends[1], &charge));
}

int main(void) {
    firma_world read = {0}, level = {0};
    firma_game game = {0}, half = {0}, replay = {0};
    firma_recording recording = {0}, loaded = {0};
    firma_game_player player;
    must(firma_world_load("levels/first.obj", NULL, &read));
    must(firma_world_with_anchors(read, NULL, &level));
    must(firma_game_begin(level, 60, &game));
    must(firma_game_record(game, "first.obj"));
    firma_game_player_defaults(&player);
    player.player.position[0] = 30;
    player.player.position[1] = 22;
    player.player.position[2] = 0.5;
    must(firma_player_shape_capsule(NULL, &player.shape));
    must(firma_game_add_player(game, &player, NULL));

    /* Ten seconds of it; in the middle it is saved. */
    for (uint64_t tick = 0; tick < 600; ++tick) {
        if (tick == 200) must(firma_game_save(game, "build/half.firma"));
        play(game, tick);
        must(firma_game_step(game));
    }
    firma_game_facts facts = {.size = sizeof facts};
    must(firma_game_get_facts(game, &facts));
    must(firma_game_recording(game, &recording));
    must(firma_recording_save(recording, "build/fight.firmarec"));
    printf("%d explosions in %d ticks\n", (int)facts.explosions, (int)facts.tick);

    /* A replay is a game that does what was recorded, and compares itself. */
    firma_game_replay told = {.size = sizeof told};
    must(firma_recording_load("build/fight.firmarec", &loaded));
    must(firma_recording_replay(loaded, &replay));
    while (!told.finished) {
        must(firma_game_step(replay));
        must(firma_game_get_replay(replay, &told));
    }
    printf("%d of %d ticks are as recorded\n", (int)told.ticks, (int)told.ticks_in_all);

    /* What was saved in the middle goes on as what was not. */
    uint64_t one = 0, other = 1;
    must(firma_game_load("build/half.firma", &half));
    for (uint64_t tick = 200; tick < 600; ++tick) must(firma_game_step(half));
    must(firma_game_hash(game, &one));
    must(firma_game_hash(half, &other));
    printf("saved at tick 200 and loaded: %s\n", one == other ? "the same end" : "another end");

    must(firma_player_shape_release(player.shape));
    must(firma_recording_release(recording));
    must(firma_recording_release(loaded));
    must(firma_game_release(game));
    must(firma_game_release(half));
    must(firma_game_release(replay));
    must(firma_world_release(level));
    must(firma_world_release(read));
    return (int)firma_live_handles();
}

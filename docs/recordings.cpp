// SPDX-License-Identifier: MIT
// The program of docs/recordings.md: a fight is recorded, replayed, tampered with; a game is saved and goes on.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::World> read = firma::read_world("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    firma::GameState game = firma::begin_game(firma::with_anchors(read.value()), 60);

    // What is to happen, by ticks: a player walks, rockets fly at both ends of the bridge.
    firma::GamePlayer player;
    player.shape = firma::make_player_capsule().value();
    player.player.position = {30, 22, 0.5};
    const std::uint32_t rocket = 1;  // of standard_weapons()
    const std::vector<firma::GameEvent> events{
        {0, firma::PlayerEvent{player}},
        {30, firma::WishEvent{0, {.velocity = {2, 1, 0}}}},
        {60, firma::FireEvent{rocket, {32, 29, 2}, {-30, 0, 8}}},
        {90, firma::BlastEvent{{22, 29, 4.75}, {.crater = 3, .break_radius = 8}}},
        {120, firma::BlastEvent{{42, 29, 4.75}, {.crater = 3, .break_radius = 8}}},
    };

    // Ten seconds of it, recorded; as bytes, and back.
    const firma::Result<firma::Recording> recorded = firma::record_game(game, events, 600, "first.obj");
    if (!recorded) return std::puts(recorded.error().text().c_str()), 1;
    const std::vector<std::byte> bytes = firma::pack_recording(recorded.value()).value();
    firma::Recording recording = firma::unpack_recording(bytes, "fight.firmarec").value();
    const firma::GameState& end = recording.end;
    std::printf("%zu explosions, %zu edits, %zu slots of bodies\n", std::size_t(end.explosions),
                end.log.commands().size(), end.bodies.slots.size());

    // A replay steps the game again and compares it tick by tick.
    const firma::GameReplay replay = firma::replay_game(recording);
    std::printf("%zu ticks are as recorded: %s\n", std::size_t(replay.ticks), replay.ok() ? "all" : "not all");
    std::get<firma::WishEvent>(recording.events[1].what).wish.velocity.x = 2.5;
    const firma::GameReplay other = firma::replay_game(recording);
    if (other.difference)
        std::printf("with another wish: tick %zu, %s\n", std::size_t(other.difference->tick),
                    other.difference->items.front().c_str());

    // One file of everything: what was saved in the middle of the fight goes on as what was not.
    firma::GameRun run(game, events);
    std::vector<std::byte> saved;
    for (int tick = 0; tick < 600; ++tick) {
        if (tick == 200) saved = firma::pack_game(run.game()).value();
        if (run.step()) return 1;
    }
    firma::GameState loaded = firma::unpack_game(saved, "half.firma").value();
    while (loaded.tick < 600)
        if (firma::step_game(loaded)) return 1;
    std::printf("saved at tick 200 and loaded: %s\n",
                firma::hash_game(loaded) == firma::hash_game(run.game()) ? "the same end" : "another end");
}

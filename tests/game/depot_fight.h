// SPDX-License-Identifier: MIT
// A fight in the depot, for tests and for comparing what compilers and machines make of it.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/sort.h"
#include "firma/recording.h"
#include "tests/body/simple_bodies.h"
#include "tests/moving/part_worlds.h"

namespace firma::test {

inline GamePlayer game_player(const Vec3& position) {
    GamePlayer player;
    player.shape = make_player_capsule().value();
    player.player.position = position;
    return player;
}

/// A leaf that slides up by 2 m in a second, waits for one, and comes down.
inline PartDrive sliding_drive(const Vec3& at) {
    PartDrive drive;
    drive.path.stops = {{at, 0, 0, 1}, {at + Vec3{0, 0, 2}, 0, 1, 1}};
    drive.waits = true;
    return drive;
}

inline MovingPart named_part(World world, const std::string& name) {
    MovingPart part(std::move(world));
    part.name = name;
    return part;
}

/// The depot with a door of its own in the hall, and what a script would do in it.
inline GameState depot_game() {
    const BrushLevel level = depot_level();
    const World world = make_world(level).value();
    AnchorRules anchors;
    anchors.volumes = anchor_volumes(level);
    GameState game = begin_game(with_anchors(world, anchors), 60);
    add_part(game, named_part(box_world({-1, -0.125, 0}, {1, 0.125, 2.25}), "gate"), sliding_drive({8, 4, 0}));
    return game;
}

/// Rockets at both ends of the bridge and at walls, grenades, a crowd of bodies, a player who walks, the gate.
inline std::vector<GameEvent> depot_events() {
    std::vector<GameEvent> events;
    events.push_back({0, PlayerEvent{game_player({8, 7, 0.01})}});
    events.push_back({0, PlayerEvent{game_player({20, 7, 0.01})}});
    events.push_back({6, WishEvent{0, {.velocity = {0, -4, 0}}}});
    events.push_back({12, PartEvent{0}});
    for (std::uint64_t k = 0; k < 12; ++k)
        events.push_back({20 + k, BodyEvent{body_here(k % 2 ? ball(0.2) : box_body({0.3, 0.2, 0.2}),
                                                      {10 + 0.7 * double(k), 6, 1.5 + 0.1 * double(k)})}});
    events.push_back({40, FireEvent{1, {14, 7, 1}, {0, -28, 15}}});
    events.push_back({60, FireEvent{1, {14, 7, 1}, {0, 28, 15}}});
    events.push_back({90, BlastEvent{{14, 2, 3.75}, {.crater = 2.2}}});
    events.push_back({120, BlastEvent{{14, 12, 3.75}, {.crater = 2.2}}});
    for (std::uint64_t k = 0; k < 5; ++k)
        events.push_back({150 + 20 * k, FireEvent{2, {12, 7, 2}, {2 + double(k), 1 - double(k) * 0.5, 3}}});
    events.push_back({200, WishEvent{0, {.velocity = {3, 3, 0}, .jump = true}}});
    events.push_back({240, FireEvent{1, {10, 7, 1.5}, {-25, 4, 0}}});
    events.push_back({300, WishEvent{1, {.velocity = {-3, 0.5, 0}}}});
    for (std::uint64_t k = 0; k < 20; ++k)
        events.push_back({330 + k, FireEvent{0, {12, 7, 1.5}, {300, 40 - 4.0 * double(k), 10}}});
    events.push_back({360, BlastEvent{{14, 7, 0.5}, {.crater = 1, .break_radius = 6}}});
    events.push_back({420, PartEvent{0}});
    sort_stably(events, [](const GameEvent& a, const GameEvent& b) { return a.tick < b.tick; });
    return events;
}

}  // namespace firma::test

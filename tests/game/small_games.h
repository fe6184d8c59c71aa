// SPDX-License-Identifier: MIT
// A small game for tests, with one of everything.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "tests/game/depot_fight.h"
#include "tests/save/saved_worlds.h"

namespace firma::test {

/// A room of 8 m with a pillar; a door, a blade, a player and a body: 30 ticks of events.
inline GameState small_game() {
    GameState game = begin_game(with_anchors(room_world()), 60);
    add_part(game, named_part(box_world({-0.5, -0.0625, 0}, {0.5, 0.0625, 1.5}), "leaf"), sliding_drive({2.5, 2, -2}));
    PartDrive blade;
    blade.path.stops = {{{-2.5, 2, 1}, 0, 0, 0}};
    blade.path.spin = 3;
    add_part(game, named_part(box_world({-0.75, -0.0625, -0.0625}, {0.75, 0.0625, 0.0625}), "blade"), blade);
    return game;
}

inline std::vector<GameEvent> small_events() {
    std::vector<GameEvent> events;
    events.push_back({0, PlayerEvent{game_player({-3, -3, -1.99})}});
    events.push_back({0, BodyEvent{body_here(box_body({0.25, 0.25, 0.25}), {-3.4, 1, -1.74})}});
    events.push_back({2, WishEvent{0, {.velocity = {3, 0, 0}, .jump = true}}});
    events.push_back({4, PartEvent{0}});
    events.push_back({5, FireEvent{1, {-3, 3, 0}, {30, -20, 0}}});
    events.push_back({6, FireEvent{2, {3, -2, 1}, {-4, 2, 1}}});
    events.push_back({6, FireEvent{0, {3, 3, 1}, {-300, -10, 0}}});
    events.push_back({8, BlastEvent{{3.5, -3.5, -1.8}, {.crater = 0.5, .radius = 4, .impulse = 1500}}});
    EditCommand fill = crater_command(1, {CutterShape::kBox, 1}, {-3, 0, -2}, 0.25);
    fill.kind = EditKind::kFill;
    events.push_back({9, EditEvent{fill}});
    events.push_back({9, EditEvent{crater_command(1, {CutterShape::kWedge, 4}, {0, -4, 0}, 0.5)}});
    return events;
}

/// A small game after so many ticks.
inline GameState small_game_after(std::uint64_t ticks) {
    const std::vector<GameEvent> events = small_events();
    GameRun run(small_game(), events);
    for (std::uint64_t k = 0; k < ticks; ++k) EXPECT_FALSE(run.step());
    return run.take_game();
}

}  // namespace firma::test

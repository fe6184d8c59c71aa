// SPDX-License-Identifier: MIT
// A player in a level with one part that moves by its path, judged in each tick.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "firma/part_path.h"
#include "firma/players.h"
#include "tests/body/level_floors.h"

namespace firma::test {

struct PathRide {
    const World& level;
    PlayerShape shape;
    PartPath path;
    std::vector<MovingPart> parts;
    Player player{};
    PlayerMove last{};
    int ticks = 0, airborne = 0, pushed = 0, crushed = 0;

    void tick(const PlayerWish& wish = {}) {
        parts[0].motion = part_motion(path, ticks * kTick, (ticks + 1) * kTick);
        last = move_player(Scene{level, parts}, shape, player, wish, kTick);
        player = last.player;
        ++ticks;
        EXPECT_TRUE(last.valid);
        airborne += !player.on_ground;
        pushed += last.pushed_by == 0;
        crushed += last.crushed_by == 0;
        EXPECT_TRUE(player_fits(level, shape, player.position)) << "in the level, tick " << ticks;
        if (last.crushed_by != kNoPart) return;
        EXPECT_TRUE(player_fits(Scene{level, parts, 1, 1}, shape, player.position)) << "in the part, tick " << ticks;
    }
    Vec3 part_at() const { return pose_at(parts[0].motion, 1).position; }
};

}  // namespace firma::test

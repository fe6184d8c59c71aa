// SPDX-License-Identifier: MIT
// A player on its way through a level, judged in each tick: it overlaps nothing, and goes no faster than it was asked
// to.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "firma/players.h"
#include "tests/brush/map_text.h"
#include "tests/player/player_shapes.h"
#include "tests/reference/player_overlap.h"
#include "tests/world/matter_levels.h"

namespace firma::test {

inline constexpr double kOffset = 0.001;  ///< metres: what is kept from all that is touched

/// Of tests that go through player_shapes() by number.
inline std::string name_of_player_shape(const testing::TestParamInfo<int>& shape) {
    return kPlayerShapeNames[std::size_t(shape.param)];
}

inline Vec3 across(const Vec3& v) {
    return {v.x, v.y, 0};
}

class Walk {
public:
    Walk(const World& level, const PlayerShape& player_shape, const Vec3& feet) : world(level), shape(player_shape) {
        player.position = feet;
    }

    /// One tick.
    const PlayerMove& move(const PlayerWish& wish) {
        const Player before = player;
        last = move_player(world, shape, before, wish, seconds, rules);
        player = last.player;
        ++ticks;
        judge(before, wish);
        return last;
    }
    /// So many ticks with one wish.
    void go(const Vec3& velocity, int count) { with({.velocity = velocity}, count); }
    void with(const PlayerWish& wish, int count) {
        for (int k = 0; k < count; ++k) move(wish);
    }
    void wait(int count) { go({}, count); }
    const Vec3& at() const { return player.position; }
    bool met(ContactKind kind) const {
        const auto contacts = last.contacts();
        return std::any_of(contacts.begin(), contacts.end(), [&](const PlayerContact& c) { return c.kind == kind; });
    }

    World world;
    PlayerShape shape;
    Player player;
    PlayerRules rules;
    PlayerMove last;
    double seconds = 1.0 / 60;
    int ticks = 0;
    std::size_t stepped = 0, airborne = 0;
    bool passes_sheets = false;  ///< where craters have cut rims into sheets: what bounds no solid is not judged

private:
    void judge(const Player& before, const PlayerWish& wish) {
        stepped += last.stepped;
        airborne += !player.on_ground;
        EXPECT_TRUE(last.valid) << "tick " << ticks;
        if (player.stuck) return;
        if (passes_sheets) {
            EXPECT_EQ(reference::player_overlap(Scene{world}, shape, at(), player.crouched), "") << "tick " << ticks;
        } else {
            EXPECT_TRUE(player_fits(world, shape, at(), player.crouched)) << "tick " << ticks << " at " << where();
        }
        const double way = length(across(at() - before.position - last.pushed));
        // In the air slopes turn the speed of a fall sideways.
        const double jump = last.jumped ? rules.jump_speed : 0;
        const double flying = length(before.velocity) + jump + rules.gravity * seconds;
        const double had = before.on_ground && !last.jumped ? length(across(before.velocity)) : flying;
        const double asked = std::max(length(across(wish.velocity)), had);
        const double over_gap = last.stepped ? 2 * world.tolerance().contact_offset : 0;
        EXPECT_LE(way, asked * seconds * (1 + 1e-9) + 1e-12 + over_gap) << "tick " << ticks << " at " << where();
    }
    std::string where() const {
        return std::to_string(at().x) + ' ' + std::to_string(at().y) + ' ' + std::to_string(at().z);
    }
};

/// Levels of brushes on a ground whose top is at z = 0.
inline World course(const std::string& brushes) {
    return brush_world(map_text::box({-32, -32, -8}, {32, 32, 0}, "rock") + brushes);
}

/// A wedge that rises along x from `from` at z = 0 to a height at `to`, and is solid below.
inline std::string ramp(double from, double to, double height, double wide = 4) {
    const Vec3 slope{-height, 0, to - from};
    const double size = length(slope);
    return map_text::plane_brush({{slope * (1 / size), dot(slope, Vec3{from, 0, 0}) / size},
                                  {{1, 0, 0}, to},
                                  {{0, 1, 0}, wide},
                                  {{0, -1, 0}, wide},
                                  {{0, 0, -1}, 1}},
                                 "rock");
}

/// Steps up along x from `from`: each so deep and high.
inline std::string stairs(double from, int count, double depth, double height, double wide = 4) {
    std::string brushes;
    for (int k = 0; k < count; ++k)
        brushes += map_text::box({from + k * depth, -wide, -1},
                                 {from + (k + 1) * depth + (k + 1 == count ? 4 : 0), wide, (k + 1) * height}, "rock");
    return brushes;
}

}  // namespace firma::test

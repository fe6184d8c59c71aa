// SPDX-License-Identifier: MIT
// How far there is room for a player, step by step over a grid: judged by a shape that is larger all around by what a
// player keeps from things, and without a move.
#pragma once

#include <array>
#include <queue>
#include <set>

#include "firma/players.h"

namespace firma::test {

/// A grid of 5 cm ahead of a place, to both sides, up and down.
struct FreeWay {
    const World& world;
    PlayerShape larger;  ///< by `by` on all sides
    double by;           ///< metres
    Vec3 from, ahead, aside;

    /// Metres from `from`, at most `most`: over places that touch, 0.4 m aside, 0.3 m down and up at most. Below 0:
    /// there is no room at `from`.
    double reach(double most) const {
        constexpr int kAside = 8, kDown = -6, kUp = 6;
        using Place = std::array<int, 3>;
        std::priority_queue<Place> open;  // the farthest ahead first
        std::set<Place> seen;
        const auto visit = [&](const Place& place) {
            if (std::abs(place[1]) > kAside || place[2] < kDown || place[2] > kUp || place[0] < 0) return;
            if (seen.contains(place) || !player_fits(world, larger, feet(place))) return;
            seen.insert(place);
            open.push(place);
        };
        visit({0, 0, 0});
        int farthest = -1;
        while (!open.empty() && farthest * kEvery < most) {
            const Place at = open.top();
            open.pop();
            farthest = std::max(farthest, at[0]);
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (const int step : {1, -1}) {
                    Place next = at;
                    next[axis] += step;
                    visit(next);
                }
        }
        return farthest * kEvery;
    }

private:
    static constexpr double kEvery = 0.05;

    Vec3 feet(const std::array<int, 3>& at) const {
        return from + ahead * (at[0] * kEvery) + aside * (at[1] * kEvery) + larger.up() * (at[2] * kEvery - by);
    }
};

}  // namespace firma::test

// SPDX-License-Identifier: MIT
// Players with random wishes in a level that is blasted, filled, undone and shut around them, on a lift and beside a
// leaf that swings: never in solid, never out of the level, never faster than they may be, never held where one of
// eight ways is free, never stuck where one of 500 places within reach is.
#pragma once

#include <cstdint>
#include <string>

#include "firma/players.h"

namespace firma::reference {

struct PlayerRun {
    std::uint64_t frames = 10'000;
    double rate = 60;
    std::uint64_t seed = 1;
};

struct PlayerVerdict {
    std::string fault;  ///< "" where there is none; else the frame and what was wrong
    std::uint64_t frames = 0;
    std::size_t cuts = 0, fills = 0, undone = 0, doors = 0;      ///< what was done to the world
    std::size_t jumps = 0, steps = 0, landings = 0, pushed = 0;  ///< what the player did
    std::size_t ridden = 0, shoved = 0, crushed = 0;             ///< moves on a part, pushed by one, pressed by one
    std::size_t stuck = 0;                                       ///< times that there was no way out
    std::size_t missed = 0;  ///< of these, where a place within reach was free: a fault
    std::size_t tried = 0;   ///< free ways that were tried, up to eight a second
    double travelled = 0;    ///< metres
    double seconds = 0;      ///< of the processor, in move_player() alone
};

/// @param level  with rooms that are not outside (judge_bodies.h); in these the player begins, and stays
PlayerVerdict judge_player(const World& level, const PlayerShape& shape, const PlayerRun& run);

}  // namespace firma::reference

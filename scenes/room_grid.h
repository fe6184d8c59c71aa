// SPDX-License-Identifier: MIT
// A building of any size: rooms in a grid with doorways between them, closed, its walls cut into panels of a metre.
//
// Each room is 8 x 8 x 4 m of air, walls between rooms are 1 m thick. Every corner of the one-metre lattice is moved by
// up to `jitter`, so that no two panels lie in one plane; then each panel is two triangles, otherwise one square.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/level.h"
#include "scenes/cast_families.h"
#include "scenes/rng.h"

namespace firma::scenes {

struct RoomGrid {
    int rooms_x = 1, rooms_y = 1, rooms_z = 1;
    double jitter = 0.15;  ///< metres, each way; 0 keeps the panels square
    std::uint64_t seed = 1;
};

/// Faces are wound so that their fronts look into the air; every edge belongs to exactly two.
Level room_grid(const RoomGrid& grid);

/// The smallest grid of rooms with about this many triangles.
RoomGrid room_grid_of(std::size_t triangles);

/// Casts that start in the air, at least their radius away from every wall; half of them near one.
std::vector<CastQuery> casts_in_rooms(const RoomGrid& grid, const CastRange& range, std::size_t count,
                                      std::uint64_t seed);

}  // namespace firma::scenes

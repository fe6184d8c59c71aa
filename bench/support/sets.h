// SPDX-License-Identifier: MIT
// Levels with casts in them, as most benchmarks want them.
#pragma once

#include <string>
#include <vector>

#include "firma/level.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"

namespace firma::bench {

struct CastSet {
    std::string name;
    std::vector<scenes::CastQuery> moves;
};

struct Scene {
    std::string name;
    Level level;
    std::vector<CastSet> sets;
};

/// Rooms with about so many triangles, and four sets of casts.
inline Scene rooms_scene(std::size_t triangles, std::size_t casts) {
    using namespace scenes;
    const RoomGrid grid = room_grid_of(triangles);
    const auto moves = [&](const CastRange& range, std::uint64_t seed) {
        return casts_in_rooms(grid, range, casts, seed);
    };
    return {"rooms",
            room_grid(grid),
            {{"spheres, short", moves(kShortSpheres, 1)},
             {"spheres, 50 m", moves(kLongSpheres, 2)},
             {"rays, short", moves(kShortRays, 3)},
             {"rays, long", moves(kLongRays, 4)}}};
}

/// Open ground with about so many triangles, and four sets of casts.
inline Scene terrain_scene(std::size_t triangles, std::size_t casts) {
    using namespace scenes;
    const Terrain ground{int(std::sqrt(double(triangles) / 2)), 3};
    Level level = terrain(ground);
    const auto moves = [&](const CastRange& range, std::uint64_t seed) {
        return casts_over_terrain(ground, level, range, casts, seed);
    };
    std::vector<CastSet> sets{{"spheres, short", moves(kShortSpheres, 1)},
                              {"spheres, 50 m", moves(kLongSpheres, 2)},
                              {"rays, short", moves(kShortRays, 3)},
                              {"rays, long", moves(kLongRays, 4)}};
    return {"terrain", std::move(level), std::move(sets)};
}

}  // namespace firma::bench

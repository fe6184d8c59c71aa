// SPDX-License-Identifier: MIT
// Rubble of real blasts, for tests of fractures and debris.
#pragma once

#include <algorithm>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "scenes/level_cuts.h"
#include "tests/body/simple_bodies.h"
#include "tests/openarena_maps.h"

namespace firma::test {

struct Rubble {
    World world;  ///< after the blasts
    std::vector<Chunk> chunks;
};

/// Blasts twice as large as those of cuts all over a level, until enough has come loose.
/// @param least  cubic metres: chunks of less do not count
inline Rubble rubble_of(const World& level, std::size_t count, double least, std::uint64_t seed = 7) {
    Rubble rubble{with_anchors(level), {}};
    const scenes::CutPlaces places = scenes::cut_places(level);
    CarveOptions options;
    options.chunks = ChunkOptions{};
    for (std::uint64_t index = 0; index < 100 && rubble.chunks.size() < count; ++index)
        for (const scenes::CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts::kSpread, seed, index)) {
            Pose pose = order.pose;
            pose.scale *= 2;
            const CarveResult cut = carve(rubble.world, order.cutter, pose, options);
            rubble.world = cut.world;
            for (const Chunk& chunk : cut.chunks)
                if (chunk.mass.volume >= least && rubble.chunks.size() < count) rubble.chunks.push_back(chunk);
        }
    return rubble;
}

/// @param name  of a map of OpenArena; there have to be some (openarena_maps())
inline World openarena_world(const char* name) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    const auto map = std::find_if(maps.begin(), maps.end(), [&](const auto& path) { return path.stem() == name; });
    return make_world(read_brush_level(map == maps.end() ? name : map->string()).value()).value();
}

}  // namespace firma::test

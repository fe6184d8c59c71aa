// SPDX-License-Identifier: MIT
// Chunks of the depot by blasts.
#include "support/depot_rubble.h"

#include "firma/brush_world.h"
#include "scenes/level_cuts.h"

namespace firma::bench {

DepotRubble depot_rubble(const World& level, std::size_t count) {
    DepotRubble rubble{with_anchors(level), {}};
    const scenes::CutPlaces places = scenes::cut_places(level);
    CarveOptions options;
    options.chunks = ChunkOptions{.min_volume = 0.05};
    for (std::uint64_t index = 0; rubble.chunks.size() < count && index < 100; ++index)
        for (const scenes::CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts::kSpread, 7, index)) {
            Pose pose = order.pose;
            pose.scale *= 2;
            const CarveResult cut = carve(rubble.world, order.cutter, pose, options);
            rubble.world = cut.world;
            for (const Chunk& chunk : cut.chunks)
                if (rubble.chunks.size() < count) rubble.chunks.push_back(chunk);
        }
    return rubble;
}

}  // namespace firma::bench

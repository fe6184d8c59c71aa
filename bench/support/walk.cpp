// SPDX-License-Identifier: MIT
// The walk of a cast with any way of testing a face put in.
#include "support/walk.h"

#include <cstdio>
#include <cstdlib>

namespace firma::bench {

World world_of(const Level& level, const TreeOptions& options) {
    WorldOptions all;
    all.tree = options;
    Result<World> world = make_world(level, all);
    if (world) return world.value();
    std::fprintf(stderr, "%s\n", world.error().text().c_str());
    std::exit(1);
}

void sort_like_tree(Level& level, const TreeOptions& options) {
    const World world = world_of(level, options);
    std::vector<LevelFace> sorted;
    for_each_block(*world.data().faces_of(0).tree, [&](const Block& block) {
        for (const FaceRecord& face : block.faces) sorted.push_back(level.faces[face.id.value]);
    });
    level.faces = std::move(sorted);
}

}  // namespace firma::bench

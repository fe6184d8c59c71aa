// SPDX-License-Identifier: MIT
// The program of docs/debris.md: a bridge shot at both ends breaks into bodies that fall and become ground.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::World> read = firma::read_world("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    firma::World world = firma::with_anchors(read.value());  // once: what hangs free now stays
    firma::Bodies bodies;
    firma::Debris debris;

    // The bridge across the hall, shot at both ends: each blast is one call.
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    firma::BlastOptions options;
    options.carve.chunks = firma::ChunkOptions{.min_volume = 0.01, .density = 2400};
    options.break_radius = 8;
    for (const double x : {22.0, 42.0}) {
        const firma::Vec3 at{x, 29, 4.75};
        const firma::BlastResult blast =
            firma::explode(world, bodies, debris, {.at = at}, crater, {.position = at, .scale = 3}, options);
        world = blast.carve.world;
        std::printf("%zu loose pieces became %zu bodies\n", blast.carve.chunks.size(), blast.loose.size());
    }

    // They fall. What sleeps for three seconds becomes ground.
    std::size_t grounded = 0;
    const firma::DebrisRules rules{.max_asleep = 3, .to_ground = true};
    for (int frame = 0; frame < 600; ++frame) {
        firma::step(bodies, world, 1.0 / 60);
        const firma::DebrisReport report = firma::tend_debris(world, bodies, debris, 1.0 / 60, rules);
        world = report.world;
        grounded += report.to_ground.size();
    }
    std::printf("%s of them became ground\n", grounded > 0 ? "some" : "none");

    // What a player feels in the open; behind a wall less is seen.
    const firma::Vec3 player[] = {{32, 29, 1}, {32, 29, 1.8}};
    const double seen = firma::exposure(world, {32, 26, 1}, player);
    std::printf("a blast in the open: %.0f%% seen, %.0f N s\n", 100 * seen,
                length(firma::blast_impulse({.at = {32, 26, 1}}, player[0], 0.7, seen)));
}

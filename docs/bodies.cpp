// SPDX-License-Identifier: MIT
// The program of docs/bodies.md: a bridge shot at both ends falls and comes to rest; shot from below it wakes.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::World> read = firma::read_world("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    firma::World world = firma::with_anchors(read.value());  // once: what hangs free now stays

    // The bridge across the hall, shot at both ends.
    const firma::Cutter blast = firma::make_crater(firma::CutterShape::kRocky, 1);
    firma::CarveOptions options;
    options.chunks = firma::ChunkOptions{.min_volume = 0.01, .density = 2400};
    std::vector<firma::Chunk> chunks;
    for (const double x : {22.0, 42.0}) {
        firma::CarveResult shot = firma::carve(world, blast, {.position = {x, 29, 4.75}, .scale = 3}, options);
        world = shot.world;
        chunks.insert(chunks.end(), shot.chunks.begin(), shot.chunks.end());
    }

    // Each piece becomes a body: spheres that cover it from inside, its exact mass.
    firma::Bodies bodies;
    for (const firma::Chunk& chunk : chunks) {
        const firma::Result<firma::Body> body = firma::body_of(chunk, {.max_spheres = 40});
        if (!body) return std::puts(body.error().text().c_str()), 1;
        std::printf("%.0f kg as %zu spheres\n", body.value().shape.mass(), body.value().shape.spheres().size());
        firma::add_body(bodies, body.value());
    }

    // It falls, tumbles, and comes to rest.
    int steps = 0;
    while (steps < 1200 && firma::step(bodies, world, 1.0 / 60).awake > 0) ++steps;
    const firma::Body& bridge = bodies.slots[0];
    std::printf("at rest after %.1f s, the middle %.2f m above the floor\n", steps / 60.0, bridge.position.z);

    // Shot from below, the floor is gone there: it wakes.
    world = firma::carve(world, blast, {.position = {bridge.position.x, bridge.position.y, 0}, .scale = 3}).world;
    std::printf("woken: %zu\n", firma::step(bodies, world, 1.0 / 60).woken);

    // A copy is a snapshot: both go on to the same bits.
    firma::Bodies copy = bodies;
    for (int k = 0; k < 120; ++k) {
        firma::step(bodies, world, 1.0 / 60);
        firma::step(copy, world, 1.0 / 60);
    }
    std::printf("the same: %s\n", firma::hash_bodies(bodies) == firma::hash_bodies(copy) ? "yes" : "no");
}

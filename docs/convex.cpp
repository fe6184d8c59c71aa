// SPDX-License-Identifier: MIT
// The program of docs/convex.md: a piece of the bridge as convex pieces, as another engine wants them.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::World> read = firma::read_world("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    firma::World world = firma::with_anchors(read.value());

    // The bridge across the hall, shot at both ends: its middle comes loose.
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    firma::CarveOptions options;
    options.chunks = firma::ChunkOptions{.min_volume = 0.01, .density = 2400};
    firma::CarveResult cut;
    for (const double x : {22.0, 42.0}) {
        cut = firma::carve(world, crater, {.position = {x, 29, 4.75}, .scale = 3}, options);
        world = cut.world;
    }
    if (cut.chunks.empty()) return std::puts("nothing came loose"), 1;
    const firma::Chunk& chunk = cut.chunks[0];
    std::printf("%.3f m3 came loose\n", chunk.mass.volume);

    // Exactly convex; and what is nearly so as one hull.
    for (const double concavity : {0.0, 0.05, 0.2}) {
        const firma::Result<firma::ConvexPieces> made =
            firma::convex_pieces(chunk.solid, {.max_pieces = 1000, .max_concavity = concavity});
        if (!made) return std::puts(made.error().text().c_str()), 1;
        double pieces = 0, hulls = 0;
        for (const firma::ConvexBody& piece : made.value().pieces) {
            pieces += piece.mass.volume;
            hulls += piece.hull_volume;
        }
        std::printf("within %.2f m: %zu pieces of %.3f m3, hulls of %.3f m3\n", concavity, made.value().pieces.size(),
                    pieces, hulls);
    }
}

// SPDX-License-Identifier: MIT
// What a fracture takes, by pieces: rubble of the depot broken as far as asked for, as solids and as bodies.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "firma/brush_world.h"
#include "firma/debris.h"
#include "support/depot_rubble.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

struct Spent {
    std::vector<double> milliseconds;
    std::size_t pieces = 0, cracks = 0;
    double total = 0;

    void add(double before, std::size_t made, std::size_t planes) {
        milliseconds.push_back((thread_seconds() - before) * 1e3);
        total += milliseconds.back();
        pieces += made;
        cracks += planes;
    }
};

int measure(const Settings& settings) {
    const Result<World> depot = read_world(settings.repository + "/levels/depot.map");
    if (!depot) return std::fprintf(stderr, "%s\n", depot.error().text().c_str()), 1;
    const DepotRubble rubble = depot_rubble(depot.value(), settings.quick ? 3 : 60);
    std::size_t faces = 0;
    for (const Chunk& chunk : rubble.chunks) faces += chunk.solid.face_count();
    std::printf("%zu chunks of %zu faces\n", rubble.chunks.size(), faces);
    Table table("fracture", {"pieces at most", "pieces", "cracks", "fracture ms", "worst ms", "ms a crack",
                             "shatter ms", "worst ms", "ms a piece"});
    const FracturePattern fine{.size = {0.02, 0.02, 0.02}};
    for (const std::size_t most : {2, 4, 8, 16, 32, 64}) {
        Spent solids, bodies;
        for (const Chunk& chunk : rubble.chunks) {
            ShatterOptions options;
            options.world = &rubble.world;
            options.fracture.max_pieces = most;
            options.fracture.min_volume = 1e-5;
            double before = thread_seconds();
            const Result<Fracture> broken = fracture(chunk.solid, fine, options.fracture);
            if (!broken) return std::fprintf(stderr, "%s\n", broken.error().text().c_str()), 1;
            solids.add(before, broken.value().pieces.size(), broken.value().cracks);
            Bodies alone;
            Debris debris;
            const Result<BodyId> id = add_debris(alone, debris, chunk, {.max_spheres = 8});
            if (!id) continue;
            before = thread_seconds();
            const Result<Shattered> pieces = shatter(alone, debris, id.value(), fine, options);
            if (!pieces) return std::fprintf(stderr, "%s\n", pieces.error().text().c_str()), 1;
            bodies.add(before, pieces.value().pieces.size() + pieces.value().dust, pieces.value().cracks);
        }
        const auto worst = [](const Spent& spent) {
            return *std::max_element(spent.milliseconds.begin(), spent.milliseconds.end());
        };
        table.add({count(most), count(solids.pieces), count(solids.cracks), number(median(solids.milliseconds)),
                   number(worst(solids)), number(solids.total / double(solids.cracks)),
                   number(median(bodies.milliseconds)), number(worst(bodies)),
                   number(bodies.total / double(bodies.pieces))});
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What breaking a solid, and a body, takes."));
}

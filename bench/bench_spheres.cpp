// SPDX-License-Identifier: MIT
// How many spheres buy which error: fit_spheres() of chunks of the depot.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "firma/brush_world.h"
#include "firma/sphere_set.h"
#include "support/depot_rubble.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

int measure(const Settings& settings) {
    const Result<World> depot = read_world(settings.repository + "/levels/depot.map");
    if (!depot) return std::fprintf(stderr, "%s\n", depot.error().text().c_str()), 1;
    const DepotRubble rubble = depot_rubble(depot.value(), settings.quick ? 2 : 24);
    std::vector<double> sizes;
    for (const Chunk& chunk : rubble.chunks) {
        const Box box = chunk.solid.bounds();
        sizes.push_back(max_abs(box.high - box.low));
    }
    std::printf("%zu chunks, longest side of the box %s m (median), %s to %s m\n", rubble.chunks.size(),
                number(median(sizes)).c_str(), number(*std::min_element(sizes.begin(), sizes.end())).c_str(),
                number(*std::max_element(sizes.begin(), sizes.end())).c_str());
    Table table("spheres",
                {"spheres at most", "used", "error m", "worst m", "error / size", "worst / size", "ms", "worst ms"});
    for (const std::size_t most : {1, 2, 4, 8, 16, 32, 64, 128}) {
        std::vector<double> used, error, relative, milliseconds;
        for (std::size_t k = 0; k < rubble.chunks.size(); ++k) {
            // So small that the number of spheres is what ends it.
            const FitOptions options{.max_error = sizes[k] / 1000, .max_spheres = most};
            const double before = thread_seconds();
            const Result<SphereFit> fit = fit_spheres(rubble.chunks[k].solid, options);
            milliseconds.push_back((thread_seconds() - before) * 1e3);
            if (!fit) return std::fprintf(stderr, "%s\n", fit.error().text().c_str()), 1;
            used.push_back(double(fit.value().spheres.size()));
            error.push_back(fit.value().error);
            relative.push_back(fit.value().error / sizes[k]);
        }
        const auto worst = [](const std::vector<double>& all) {
            return number(*std::max_element(all.begin(), all.end()));
        };
        table.add({count(most), number(median(used)), number(median(error)), worst(error), number(median(relative)),
                   worst(relative), number(median(milliseconds)), worst(milliseconds)});
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "How near how many spheres are to a chunk."));
}

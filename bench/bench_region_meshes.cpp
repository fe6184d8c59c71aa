// SPDX-License-Identifier: MIT
// What a renderer's meshes cost: all regions of a world once, and after each crater those that it changed.
#include <cstdio>
#include <vector>

#include "firma/region_meshes.h"
#include "firma/triangles.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// Milliseconds of processor time.
template <class Work>
double timed(const Work& work) {
    const double start = thread_seconds();
    work();
    return (thread_seconds() - start) * 1e3;
}

void measure_level(int rooms, double size, const Settings& settings, Table& table) {
    World world = carvable_world(crater_level(rooms));
    const std::size_t faces = world.face_count();
    const RegionMeshOptions options{.size = size};
    const int rounds = settings.quick ? 1 : 3;
    std::size_t regions = 0;
    const auto all_regions = [&] {
        std::vector<double> all;
        for (int round = 0; round < rounds; ++round)
            all.push_back(timed([&] { regions = region_meshes(world, options).value().size(); }));
        return median(all);
    };
    const double first = all_regions();
    std::vector<double> whole;
    for (int round = 0; round < rounds; ++round)
        whole.push_back(timed([&] { keep(triangles_of(world, {.uvs = true}).corners.size()); }));
    const Cutter cutter = crater();
    std::vector<double> cut, find, mesh, changed, triangles;
    const std::size_t cuts = settings.quick ? 20 : 200;
    for (std::size_t k = 0; k < cuts; ++k) {
        const World before = world;
        cut.push_back(cut_crater(world, cutter, crater_pose(rooms, CraterPlaces::kSpread, k)).cpu);
        std::vector<Tile> tiles;
        find.push_back(timed([&] { tiles = changed_regions(before, world, size).value(); }));
        std::size_t count = 0;
        mesh.push_back(timed([&] {
            for (const Tile& tile : tiles) count += region_mesh(world, tile, options).value().corners.size();
        }));
        changed.push_back(double(tiles.size()));
        triangles.push_back(double(count));
    }
    const double last = all_regions();
    table.add({count(faces), number(size), count(regions), number(first), number(median(whole)), count(cuts),
               number(median(cut)), number(median(find) * 1e3), number(median(mesh)), number(quantile(mesh, 0.99)),
               number(median(changed)), number(median(triangles)), number(last),
               times(last / (median(find) + median(mesh)))});
}

int measure(const Settings& settings) {
    Table table("region_meshes", {"triangles", "size m", "regions", "all regions ms", "triangles_of ms", "craters",
                                  "crater ms", "find changed us", "mesh changed ms", "p99 ms", "changed regions",
                                  "their triangles", "all regions then ms", "all to changed"});
    for (const int rooms : {2, 6, 20}) {
        if (settings.quick && rooms > 2) break;
        for (const double size : {8.0, 16.0, 32.0}) measure_level(rooms, size, settings, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Meshes by region: all of a world, and those that a crater changed."));
}

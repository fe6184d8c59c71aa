// SPDX-License-Identifier: MIT
// Every .bsp of a folder: read, built, and cast into ten thousand times.
//
// bench_openarena FOLDER; tools/unpack_openarena.sh fills build/openarena, which is the default.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "firma/queries.h"
#include "scenes/rng.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

/// Half spheres, half rays, of 1 to 20 m, from anywhere within the map's bounds.
std::vector<CastQuery> casts_in(const Box& box, std::size_t count) {
    scenes::Rng rng(51);
    std::vector<CastQuery> casts(count);
    for (std::size_t k = 0; k < count; ++k) {
        for (int axis = 0; axis < 3; ++axis) casts[k].sphere.centre[axis] = rng.uniform(box.low[axis], box.high[axis]);
        casts[k].sphere.radius = k & 1 ? rng.uniform(0.1, 0.5) : 0;
        casts[k].path = rng.direction() * rng.uniform(1, 20);
    }
    return casts;
}

struct Sum {
    std::size_t maps = 0, faulty = 0, faces = 0, casts = 0;
    double seconds = 0;
};

/// One row; false when something went wrong.
bool measure(const std::string& path, const Settings& settings, Table& table, Sum& sum) {
    double before = thread_seconds();
    const Result<Level> level = read_level(path);
    const double read = thread_seconds() - before;
    const std::string name = std::filesystem::path(path).stem().string();
    if (!level) {
        table.add({name, level.error().text()});
        return false;
    }
    before = thread_seconds();
    const Result<World> made = make_world(level.value());
    const double built = thread_seconds() - before;
    if (!made) {
        table.add({name, made.error().text()});
        return false;
    }
    const World& world = made.value();
    const std::vector<CastQuery> casts = casts_in(world.bounds(), settings.few(10000));
    CastCounts counts;
    CastOptions options;
    options.counts = &counts;
    std::size_t hits = 0, errors = 0;
    for (const CastQuery& move : casts) {
        const Hit hit = cast(world, move.sphere, move.path, options);
        hits += hit.touched();
        errors += hit.status == Status::kInvalid;
    }
    const Contender contender{name, [&world, &casts] {
                                  for (const CastQuery& move : casts)
                                      keep(cast(world, move.sphere, move.path).fraction);
                              }};
    const double seconds = race({&contender, 1}, std::min(settings.rounds, 3))[0].seconds, n = double(casts.size());
    std::size_t divided = 0;
    for (const LevelNote& note : level.value().notes) divided += note.what != FaceNote::kNoArea;
    table.add({name, count(world.face_count()), count(level.value().count(FaceNote::kNoArea)), count(divided),
               number(read * 1e3), number(built * 1e3), number(n / seconds / 1e3), number(double(counts.faces) / n),
               percent(double(counts.faces) / n / double(world.face_count())), percent(double(hits) / n),
               count(errors)});
    sum.faces += world.face_count();
    sum.casts += casts.size();
    sum.seconds += seconds;
    return errors == 0;
}

int run(const Settings& settings) {
    const std::string folder = settings.rest.empty() ? settings.repository + "/build/openarena" : settings.rest;
    std::vector<std::string> maps;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".bsp") maps.push_back(entry.path().string());
    if (maps.empty()) {
        std::printf("%s: no maps there; tools/unpack_openarena.sh brings them\n", folder.c_str());
        return 0;
    }
    std::sort(maps.begin(), maps.end());
    if (settings.quick) maps.resize(std::min<std::size_t>(maps.size(), 3));
    Table table("openarena", {"map", "faces", "dropped", "divided", "read ms", "build ms", "k casts/s",
                              "faces looked at a cast", "share of faces", "hits", "errors"});
    Sum sum;
    for (const std::string& map : maps) {
        ++sum.maps;
        sum.faulty += !measure(map, settings, table, sum);
    }
    const bool written = table.finish(settings.csv);
    std::printf("\n%s maps, %s with an error; %s faces, %s casts, %s k casts/s over all\n", count(sum.maps).c_str(),
                count(sum.faulty).c_str(), count(sum.faces).c_str(), count(sum.casts).c_str(),
                number(double(sum.casts) / sum.seconds / 1e3).c_str());
    return written && sum.faulty == 0 ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    return firma::bench::run(firma::bench::read_settings(
        argc, argv, "Reads every .bsp of a folder and casts into it; default build/openarena."));
}

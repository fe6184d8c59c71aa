// SPDX-License-Identifier: MIT
// Casts in levels/first.obj: how many faces one looks at, and how long it takes.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "firma/queries.h"
#include "scenes/rng.h"
#include "support/race.h"
#include "support/sets.h"
#include "support/settings.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

/// In the air of a closed level: what a ray meets first, it meets from the front.
bool in_air(const World& world, const Vec3& point, scenes::Rng& rng) {
    CastOptions options;
    options.sides = Sides::kBoth;
    const Vec3 way = rng.direction() * 1000;
    const Hit hit = cast(world, {point, 0}, way, options);
    return hit.touched() && dot(hit.face_normal, way) < 0;
}

std::vector<CastQuery> moves_in(const World& world, const scenes::CastRange& range, std::size_t count,
                                std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Box box = world.bounds();
    std::vector<CastQuery> moves;
    while (moves.size() < count) {
        const Vec3 point{rng.uniform(box.low.x, box.high.x), rng.uniform(box.low.y, box.high.y),
                         rng.uniform(box.low.z, box.high.z)};
        const double radius = rng.uniform(range.radius_low, range.radius_high);
        if (!in_air(world, point, rng) || closest(world, point, radius)) continue;
        moves.push_back({{point, radius}, rng.direction() * rng.uniform(range.length_low, range.length_high)});
    }
    return moves;
}

int run(const Settings& settings) {
    const std::string path = settings.rest.empty() ? settings.repository + "/levels/first.obj" : settings.rest;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    const Result<Level> level = read_obj(text.str(), path);
    if (!level) {
        std::fprintf(stderr, "%s\n", level.error().text().c_str());
        return 1;
    }
    const World world = world_of(level.value());
    const double faces = double(world.face_count());
    Table table("first_level", {"casts", "hits", "bins a cast", "boxes a cast", "faces looked at a cast",
                                "share of all faces", "most in one cast", "k casts/s"});
    const std::size_t count_of_casts = settings.few(20000);
    const std::pair<const char*, scenes::CastRange> ranges[] = {{"spheres 0.3-0.5 m, 0.1-2 m", scenes::kShortSpheres},
                                                                {"spheres 0.3-0.5 m, 50 m", scenes::kLongSpheres},
                                                                {"rays, 1-2 m", scenes::kShortRays},
                                                                {"rays, 5-100 m", scenes::kLongRays},
                                                                {"spheres 1-2 m, 1-10 m", {1, 2, 1, 10}}};
    double most_share = 0;
    for (const auto& [name, range] : ranges) {
        const std::vector<CastQuery> moves = moves_in(world, range, count_of_casts, 31);
        CastCounts counts;
        CastOptions options;
        options.counts = &counts;
        std::size_t hits = 0;
        std::uint64_t most = 0;
        for (const CastQuery& move : moves) {
            const std::uint64_t before = counts.faces;
            hits += cast(world, move.sphere, move.path, options).touched();
            most = std::max(most, counts.faces - before);
        }
        const Contender contender{name, [&world, &moves] {
                                      for (const CastQuery& move : moves)
                                          keep(cast(world, move.sphere, move.path).fraction);
                                  }};
        const double seconds = race({&contender, 1}, settings.rounds)[0].seconds, n = double(moves.size());
        const double share = double(counts.faces) / n / faces;
        most_share = std::max(most_share, share);
        table.add({name, percent(double(hits) / n), number(double(counts.nodes) / n), number(double(counts.boxes) / n),
                   number(double(counts.faces) / n), percent(share), count(most), number(n / seconds / 1e3)});
    }
    const bool written = table.finish(settings.csv);
    std::printf("\n%s: %s faces\n", path.c_str(), count(world.face_count()).c_str());
    return written && most_share < 0.02 ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    return firma::bench::run(firma::bench::read_settings(
        argc, argv, "How many faces a cast looks at in levels/first.obj, or in the .obj given."));
}

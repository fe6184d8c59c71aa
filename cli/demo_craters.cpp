// SPDX-License-Identifier: MIT
// Queries begin in air, and craters only make more of it, so they may begin there after any of them.
#include "cli/demo_craters.h"
#include "firma/queries.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "cli/fire_blast.h"
#include "cli/progress.h"
#include "scenes/rng.h"

namespace firma::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSmallest = 0.4, kLargest = 1.6;  // metres
constexpr std::size_t kRaysACrater = 100;
constexpr CutterShape kShapes[] = {CutterShape::kRocky, CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kRocky,
                                   CutterShape::kRocky, CutterShape::kDrill, CutterShape::kRocky, CutterShape::kWedge,
                                   CutterShape::kRocky, CutterShape::kBox};

/// Goes through all of the level, the way the query goes.
Query ray_of(const Query& query, double diagonal) {
    return {{query.sphere.centre, 0}, query.path * (2 * diagonal / length(query.path))};
}

bool escapes(const World& world, const Query& ray) {
    CastOptions both;
    both.sides = Sides::kBoth;
    return !cast(world, ray.sphere, ray.path, both).touched();
}

std::vector<Blast> make_blasts(const World& world, const std::vector<Query>& queries, double diagonal,
                               std::size_t count, std::uint64_t seed) {
    scenes::Rng rng(seed);
    std::vector<Blast> blasts;
    // Queries side by side begin side by side: those taken stand apart.
    const std::size_t stride = std::max<std::size_t>(1, queries.size() / std::max<std::size_t>(1, count));
    for (std::size_t k = 0; k < queries.size() && blasts.size() < count; ++k) {
        const std::size_t rounds = (queries.size() + stride - 1) / stride;
        const std::size_t which = k % rounds * stride + k / rounds;
        if (which >= queries.size()) continue;
        const Query ray = ray_of(queries[which], diagonal);
        const Hit hit = cast(world, ray.sphere, ray.path);
        if (!hit.touched()) continue;
        Blast blast;
        blast.position = hit.point;
        blast.radius = rng.uniform(kSmallest, kLargest);
        blast.shape = kShapes[blasts.size() % std::size(kShapes)];
        blast.seed = rng.below(1u << 30);
        blasts.push_back(blast);
    }
    return blasts;
}

/// The part of `total` that falls to crater k of `count`.
std::pair<std::size_t, std::size_t> share(std::size_t total, std::size_t k, std::size_t count) {
    return {k * total / count, (k + 1) * total / count};
}

void cast_between(const std::vector<Query>& queries, std::size_t first, std::size_t last, DemoCraters& did) {
    const auto start = Clock::now();
    for (std::size_t k = first; k < last; ++k) static_cast<void>(cast(did.after, queries[k].sphere, queries[k].path));
    did.cast_seconds += std::chrono::duration<double>(Clock::now() - start).count();
    did.casts += last - first;
}

}  // namespace

DemoCraters fire_demo_craters(const World& level, const World& before, const std::vector<Query>& queries,
                              std::size_t count, std::uint64_t seed) {
    DemoCraters did;
    did.after = before;
    const Box bounds = before.bounds();
    const double diagonal = bounds.empty() ? 1 : length(bounds.high - bounds.low);
    const std::vector<Blast> blasts = make_blasts(before, queries, diagonal, count, seed);
    FireOptions options;
    options.carve.chunks = ChunkOptions{};
    Progress progress("carving", blasts.size());
    for (std::size_t k = 0; k < blasts.size(); ++k) {
        const Fired fired = fire_blast(did.after, blasts[k], options);
        ++did.fired;
        did.done += fired.result.done();
        did.nothing += fired.result.status == CarveStatus::kNothing;
        did.nothing_castable_only += met_only_castable(fired.result);
        if (fired.result.status == CarveStatus::kRefused) {
            ++did.refused;
            ++did.refusals[fired.result.error.reason];
        }
        if (fired.result.done()) {
            did.seconds.push_back(fired.seconds);
            did.volume += fired.result.report.volume;
            did.chunks += fired.result.report.chunks;
            did.chunk_volume += fired.result.report.chunk_volume;
            did.crumbs += fired.result.report.crumbs;
        }
        const auto [first, last] = share(queries.size(), k, blasts.size());
        cast_between(queries, first, last, did);
        for (std::size_t r = 0; r < kRaysACrater; ++r, ++did.rays) {
            const Query ray = ray_of(queries[did.rays % queries.size()], diagonal);
            did.escaped_before += escapes(level, ray);
            did.escaped += escapes(did.after, ray);
        }
        progress.add(1);
    }
    return did;
}

}  // namespace firma::cli

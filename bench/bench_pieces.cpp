// SPDX-License-Identifier: MIT
// The pieces of a cast by themselves, by Google Benchmark: for watching what a change does to each of them.
//
// bench_pieces --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
// --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>

#include "cast/cast_sphere_polygon.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "support/sets.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

constexpr std::size_t kCasts = 1024;

/// A triangle of about a metre and casts around it.
struct Pair {
    std::vector<Vec3> corners{{-0.5, -0.5, 0.25}, {0.75, -0.5, -0.125}, {0, 0.75, 0}};
    PolygonShape shape = make_shape(corners);
    std::vector<CastQuery> moves;
    std::vector<Sweep> sweeps;

    explicit Pair(double radius) : sweeps(kCasts) {
        scenes::Rng rng(1);
        for (std::size_t k = 0; k < kCasts; ++k) {
            const Vec3 target{rng.uniform(-1, 1), rng.uniform(-1, 1), 0};
            const Vec3 start = target + Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), 2};
            moves.push_back({{start, radius}, (target - start) * 1.5});
            make_sweep(moves[k].sphere, moves[k].path, sweeps[k]);
        }
    }
};

void prepare_sweep(benchmark::State& state) {
    const Pair pair(0.25);
    std::size_t k = 0;
    for (auto _ : state) {
        Sweep sweep;
        make_sweep(pair.moves[k].sphere, pair.moves[k].path, sweep);
        benchmark::DoNotOptimize(sweep);
        k = (k + 1) % kCasts;
    }
}
BENCHMARK(prepare_sweep);

void prepare_shape(benchmark::State& state) {
    const Pair pair(0.25);
    for (auto _ : state) {
        PolygonShape shape = make_shape(pair.corners);
        benchmark::DoNotOptimize(shape);
    }
}
BENCHMARK(prepare_shape);

void test_face(benchmark::State& state, double radius) {
    const Pair pair(radius);
    std::size_t k = 0;
    for (auto _ : state) {
        const Sweep& sweep = pair.sweeps[k];
        benchmark::DoNotOptimize(cast_sweep_polygon(sweep, pair.shape, Sides::kFront, sweep.end));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK_CAPTURE(test_face, particle, 0.0);
BENCHMARK_CAPTURE(test_face, sphere, 0.25);

void pair_function(benchmark::State& state, double radius) {
    const Pair pair(radius);
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(cast_polygon(pair.moves[k].sphere, pair.moves[k].path, pair.corners));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK_CAPTURE(pair_function, particle, 0.0);
BENCHMARK_CAPTURE(pair_function, sphere, 0.25);

void nearest_point(benchmark::State& state) {
    const Pair pair(0.25);
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(closest_point(pair.moves[k].sphere.centre, pair.corners));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK(nearest_point);

const Scene& scene() {
    static const Scene rooms = rooms_scene(10000, kCasts);
    return rooms;
}

const World& world() {
    static const World of_rooms = world_of(scene().level);
    return of_rooms;
}

void cast_world(benchmark::State& state) {
    const CastSet& set = scene().sets[std::size_t(state.range(0))];
    state.SetLabel(set.name);
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(cast(world(), set.moves[k].sphere, set.moves[k].path));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK(cast_world)->DenseRange(0, 3);

void any_in_world(benchmark::State& state) {
    const CastSet& set = scene().sets[std::size_t(state.range(0))];
    state.SetLabel(set.name);
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(cast_any(world(), set.moves[k].sphere, set.moves[k].path));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK(any_in_world)->DenseRange(0, 3);

void overlap_world(benchmark::State& state) {
    std::vector<Overlap> found;
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(overlap(world(), scene().sets[0].moves[k].sphere, found));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK(overlap_world);

void closest_in_world(benchmark::State& state) {
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(closest(world(), scene().sets[0].moves[k].sphere.centre));
        k = (k + 1) % kCasts;
    }
}
BENCHMARK(closest_in_world);

void find_face(benchmark::State& state) {
    const FaceId last{std::uint32_t(world().face_count()) - 1};
    for (auto _ : state) benchmark::DoNotOptimize(world().find_face(last));
}
BENCHMARK(find_face);

void find_no_face(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(world().find_face({~0u - 1}));
}
BENCHMARK(find_no_face);

void face_of_ref(benchmark::State& state) {
    const FaceRef ref = world().find_face({std::uint32_t(world().face_count()) / 2})->ref();
    for (auto _ : state) benchmark::DoNotOptimize(world().face(ref));
}
BENCHMARK(face_of_ref);

void bounds_of_world(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(world().bounds());
}
BENCHMARK(bounds_of_world);

void locate_outside(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(locate(world(), {1e4, 1e4, 1e4}));
}
BENCHMARK(locate_outside);

void build_world(benchmark::State& state) {
    for (auto _ : state) {
        World built = world_of(scene().level);
        benchmark::DoNotOptimize(built);
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(scene().level.faces.size()));
}
BENCHMARK(build_world)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace firma::bench

BENCHMARK_MAIN();

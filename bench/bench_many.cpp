// SPDX-License-Identifier: MIT
// Casts together: a batch against single casts, on one thread and on two, where a half of the casts for each is what
// two threads can gain. Scattered casts over open ground, by the clock: nothing else should run. And worlds made on one
// thread and on two.
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "firma/batch.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

std::vector<CastInput> scattered(const scenes::Terrain& ground, const Level& level, std::size_t count,
                                 const scenes::CastRange& range) {
    std::vector<CastInput> casts;
    for (const scenes::CastQuery& query : scenes::casts_over_terrain(ground, level, range, count, 17))
        casts.push_back({query.sphere, query.path});
    return casts;
}

constexpr unsigned kThreads = 2;

void on_threads(const std::function<void(unsigned)>& work) {
    std::thread other(work, 1u);
    work(0);
    other.join();
}

/// Each thread takes the next piece.
void run_on_threads(std::size_t count, void (*work)(void* context, std::size_t k), void* context, void*) {
    std::atomic<std::size_t> next = 0;
    on_threads([&](unsigned) {
        for (std::size_t k = next++; k < count; k = next++) work(context, k);
    });
}

double clock_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The least time of several rounds, in turn.
std::vector<double> least(const std::vector<std::function<void()>>& ways, int rounds) {
    std::vector<double> best(ways.size(), 1e30);
    for (int round = 0; round <= rounds; ++round)
        for (std::size_t k = 0; k < ways.size(); ++k) {
            const double start = clock_seconds();
            ways[k]();
            if (round > 0) best[k] = std::min(best[k], clock_seconds() - start);
        }
    return best;
}

void measure_casts(const std::string& what, const World& world, const std::vector<CastInput>& casts, int rounds,
                   Table& table) {
    std::vector<Hit> hits(casts.size());
    const Tasks tasks{run_on_threads, nullptr};
    const auto many = [&](std::size_t first, std::size_t count, const Tasks* on) {
        keep(cast_many(world, std::span(casts).subspan(first, count), std::span(hits).subspan(first, count),
                       {.tasks = on}));
    };
    const std::vector<double> seconds =
        least({
                  [&] {
                      for (std::size_t k = 0; k < casts.size(); ++k)
                          hits[k] = cast(world, casts[k].sphere, casts[k].path);
                  },
                  [&] { many(0, casts.size(), nullptr); },
                  [&] {
                      const std::size_t half = casts.size() / kThreads;
                      on_threads([&](unsigned thread) {
                          many(thread * half, thread + 1 == kThreads ? casts.size() - thread * half : half, nullptr);
                      });
                  },
                  [&] { many(0, casts.size(), &tasks); },
              },
              rounds);
    const double halves = seconds[1] / seconds[2], pieces = seconds[1] / seconds[3];
    table.add({what, count(world.face_count()), count(casts.size()), number(seconds[0] / double(casts.size()) * 1e9),
               number(seconds[1] / double(casts.size()) * 1e9), times(seconds[1] / seconds[0]), times(halves),
               times(pieces), percent(pieces / halves)});
}

/// Levels made on one thread and on two.
void measure_builds(const std::string& what, const Level& level, int rounds, Table& table) {
    const Tasks tasks{run_on_threads, nullptr};
    WorldOptions together;
    together.work.tasks = &tasks;
    const std::vector<double> seconds = least({
                                                  [&] { keep(make_world(level).value()); },
                                                  [&] { keep(make_world(level, together).value()); },
                                              },
                                              rounds);
    table.add({what, count(level.faces.size()), number(seconds[0] * 1e3), number(seconds[1] * 1e3),
               times(seconds[0] / seconds[1])});
}

bool measure_all_builds(const Settings& settings) {
    Table table("many_builds", {"made", "faces", "ms on one thread", "ms on two", "gain"});
    for (const std::uint32_t faces : {100'000, 1'000'000, 10'000'000}) {
        if (settings.quick && faces > 100'000) break;
        Level level = scenes::room_grid(scenes::room_grid_of(faces));
        measure_builds("with the exact part", level, settings.quick ? 1 : 3, table);
        for (LevelFace& face : level.faces) face.two_sided = true;
        measure_builds("castable only", level, settings.quick ? 1 : 3, table);
    }
    return table.finish(settings.csv);
}

int measure(const Settings& settings) {
    const bool builds = measure_all_builds(settings);
    Table table("many", {"casts", "faces", "how many", "ns a single cast", "ns of a batch", "to single",
                         "two threads, half each", "two threads, pieces", "pieces to halves"});
    for (const int squares : {70, 200, 500, 1000}) {
        if (settings.quick && squares > 200) break;
        const scenes::Terrain ground{squares, 3};
        const Level level = scenes::terrain(ground);
        const World world = make_world(level).value();
        const auto measure_range = [&](const std::string& what, const scenes::CastRange& range) {
            const std::size_t count = settings.few(200000);
            measure_casts(what, world, scattered(ground, level, count, range), settings.quick ? 1 : settings.rounds,
                          table);
        };
        measure_range("rays, 1-2 m", scenes::kShortRays);
        measure_range("rays, 5-100 m", scenes::kLongRays);
        measure_range("spheres, 0.1-2 m", scenes::kShortSpheres);
        measure_range("spheres, 50 m", scenes::kLongSpheres);
    }
    return table.finish(settings.csv) && builds ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(
        read_settings(argc, argv, "Batches of casts against single ones, and worlds made, on one thread and on two."));
}

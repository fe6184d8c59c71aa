// SPDX-License-Identifier: MIT
// Casts together: a batch against single casts, on one thread and on two, where a plain loop over halves is what two
// threads can gain. Scattered casts over open ground, by the clock: nothing else should run.
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "firma/batch.h"
#include "firma/level.h"
#include "scenes/rng.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// Squares of a metre, two triangles each.
Level ground(std::uint32_t side) {
    constexpr auto kMetre = std::int32_t(kSurfaceSteps);
    scenes::Rng rng(5);
    Level level;
    level.name = "ground";
    level.materials.emplace_back();
    for (std::uint32_t j = 0; j <= side; ++j)
        for (std::uint32_t i = 0; i <= side; ++i) {
            const auto height = std::int32_t(rng.below(64)) * (kMetre / 64);
            level.vertices.push_back({(std::int32_t(i) - std::int32_t(side / 2)) * kMetre,
                                      (std::int32_t(j) - std::int32_t(side / 2)) * kMetre, height});
        }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        LevelFace face;
        face.first_corner = std::uint32_t(level.corners.size());
        face.corner_count = 3;
        face.source = std::uint32_t(level.faces.size());
        level.corners.insert(level.corners.end(), {a, b, c});
        level.faces.push_back(face);
    };
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t at = j * (side + 1) + i;
            add(at, at + 1, at + side + 2);
            add(at, at + side + 2, at + side + 1);
        }
    return level;
}

std::vector<CastInput> scattered(std::uint32_t side, std::size_t count, double radius, double from, double to) {
    scenes::Rng rng(17);
    std::vector<CastInput> casts(count);
    const double half = side / 2.0 - 1;
    for (CastInput& cast : casts) {
        for (int axis = 0; axis < 2; ++axis) cast.sphere.centre[axis] = rng.uniform(-half, half);
        cast.sphere.centre.z = rng.uniform(1 + radius, 3);
        cast.sphere.radius = radius;
        const Vec3 way = rng.direction();
        cast.path = way * rng.uniform(from, to);
    }
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
    const auto single = [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) hits[k] = cast(world, casts[k].sphere, casts[k].path);
    };
    const auto many = [&](CastOrder order, const Tasks* on) {
        keep(cast_many(world, casts, hits, {.tasks = on, .order = order}));
    };
    const std::vector<double> seconds =
        least({
                  [&] { single(0, casts.size()); },
                  [&] {
                      on_threads([&](unsigned thread) {
                          const std::size_t half = casts.size() / kThreads;
                          single(thread * half, thread + 1 == kThreads ? casts.size() : (thread + 1) * half);
                      });
                  },
                  [&] { many(CastOrder::kGiven, nullptr); },
                  [&] { many(CastOrder::kGiven, &tasks); },
                  [&] { many(CastOrder::kBest, nullptr); },
                  [&] { many(CastOrder::kBest, &tasks); },
              },
              rounds);
    const double loop = seconds[0] / seconds[1], given = seconds[2] / seconds[3], best = seconds[4] / seconds[5];
    table.add({what, count(world.face_count()), count(casts.size()), number(seconds[0] / double(casts.size()) * 1e9),
               times(seconds[2] / seconds[0]), times(seconds[4] / seconds[0]), times(loop), times(given), times(best),
               percent(given / loop), percent(best / loop)});
}

int measure(const Settings& settings) {
    Table table("many", {"casts", "faces", "how many", "ns a single cast", "together, given order",
                         "together, own order", "two threads, a loop", "together, given order, two threads",
                         "together, own order, two threads", "given order to the loop", "own order to the loop"});
    for (const std::uint32_t side : {200u, 1000u}) {
        if (settings.quick && side > 200) break;
        const World world = make_world(ground(side)).value();
        const std::size_t count = settings.few(200000);
        const int rounds = settings.quick ? 1 : settings.rounds;
        measure_casts("rays, 1-2 m", world, scattered(side, count, 0, 1, 2), rounds, table);
        measure_casts("rays, 20-40 m", world, scattered(side, count, 0, 20, 40), rounds, table);
        measure_casts("spheres of 0.4 m, 1-2 m", world, scattered(side, count, 0.4, 1, 2), rounds, table);
        measure_casts("spheres of 0.4 m, 20-40 m", world, scattered(side, count, 0.4, 20, 40), rounds, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Batches of casts against single ones, on one thread and on two."));
}

// SPDX-License-Identifier: MIT
// One side of bench/against/run.py: the same work for any version of the library, by what its public headers have had
// since 0.1. Before tries of a cut, and before all casts, it waits for a line, so that two versions take turns.
// Prints a line for each try, `cut NUMBER NS` or `cut_and_hashes NUMBER NS`, the last of a turn with ` end`; then a
// line for each kind of cast, its name, 0 and the median in nanoseconds.
//
//   work LEVEL.map SEED TRIES_A_TURN
//   work LEVEL.map SEED instructions    under callgrind: each cut once, its instructions in a file of their own
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else  // then run.py finds no valgrind either
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS
#endif

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#if __has_include("firma/queries.h")
#include "firma/queries.h"
#endif
#include "firma/rooms.h"
#include "firma/solid.h"

namespace {

using namespace firma;
using Clock = std::chrono::steady_clock;

/// A place in a room, as either version says it.
template <class Place>
bool in_air(const Place& place) {
    if constexpr (requires { place.where; })
        return place.room.value < ~0u;
    else
        return place.kind == Place::Kind::kRoom;
}

constexpr int kCuts = 200, kCasts = 20'000;

/// Source: S. Vigna, splitmix64.
struct Numbers {
    std::uint64_t state;
    std::uint64_t next() {
        std::uint64_t z = state += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    double within(double low, double high) { return low + (high - low) * double(next() >> 11) * 0x1p-53; }
    Vec3 point(const Box& box) {
        return {within(box.low.x, box.high.x), within(box.low.y, box.high.y), within(box.low.z, box.high.z)};
    }
};

double nanoseconds(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

void tell(const char* name, std::vector<double> values) {
    const auto at = std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), values.begin() + at, values.end());
    std::printf("%s 0 %.1f\n", name, values[std::size_t(at)]);
}

void wait_for_turn() {
    std::fflush(stdout);
    for (int c = std::getchar(); c != '\n'; c = std::getchar())
        if (c == EOF) std::exit(EXIT_FAILURE);
}

/// How often each cut is made of the same world.
constexpr int kTries = 5;

struct Crater {
    Cutter cutter;
    Pose pose;
};

/// Of 0.7 m, somewhere.
Crater next_crater(Numbers& numbers, const Box& bounds) {
    Cutter cutter = make_crater(CutterShape::kRocky, numbers.next());
    return {std::move(cutter),
            {.position = numbers.point(bounds), .rotation = random_turn(numbers.next()), .scale = 0.7}};
}

/// Craters; those that take nothing are not counted.
World cut(World world, std::uint64_t seed, int tries_a_turn, bool hashed) {
    Numbers numbers{seed};
    const Box bounds = world.bounds();
    std::uint64_t sum = 0;
    int cuts = 0;
    for (int tries = 0; cuts < kCuts && tries < 20 * kCuts; ++tries) {
        const auto [cutter, pose] = next_crater(numbers, bounds);
        if (!carve(world, cutter, pose).done()) continue;
        World after;
        for (int k = 0; k < kTries; ++k) {
            if (k % tries_a_turn == 0) wait_for_turn();
            const Clock::time_point start = Clock::now();
            CarveResult result = carve(world, cutter, pose);
            if (hashed) sum += hash_world(result.world) + hash_solid(result.world);
            std::printf("%s %d %.1f%s\n", hashed ? "cut_and_hashes" : "cut", cuts, nanoseconds(start),
                        (k + 1) % tries_a_turn == 0 || k + 1 == kTries ? " end" : "");
            after = result.world;
        }
        ++cuts;
        world = after;
    }
    if (hashed && sum == 0) std::printf("# no hash\n");
    return world;
}

/// The same craters, each counted by callgrind.
void count_cuts(World world, std::uint64_t seed) {
    Numbers numbers{seed};
    const Box bounds = world.bounds();
    int cuts = 0;
    for (int tries = 0; cuts < kCuts && tries < 20 * kCuts; ++tries) {
        const auto [cutter, pose] = next_crater(numbers, bounds);
        CALLGRIND_ZERO_STATS;
        CarveResult result = carve(world, cutter, pose);
        if (!result.done()) continue;
        CALLGRIND_DUMP_STATS;
        ++cuts;
        world = result.world;
    }
    CALLGRIND_ZERO_STATS;
}

/// Medians of a hundred casts each.
void cast_all(const World& world, const char* name, double radius, double length, std::uint64_t seed) {
    Numbers numbers{seed};
    const Box bounds = world.bounds();
    struct Query {
        Sphere sphere;
        Vec3 path;
    };
    std::vector<Query> queries;
    while (int(queries.size()) < kCasts) {
        const Vec3 start = numbers.point(bounds);
        if (!in_air(locate(world, start))) continue;
        const Vec3 way{numbers.within(-1, 1), numbers.within(-1, 1), numbers.within(-1, 1)};
        queries.push_back({{start, radius}, way * length});
    }
    std::vector<double> times;
    double sum = 0;
    for (int k = 0; k + 100 <= kCasts; k += 100) {
        const Clock::time_point start = Clock::now();
        for (int i = k; i < k + 100; ++i) sum += cast(world, queries[i].sphere, queries[i].path).fraction;
        times.push_back(nanoseconds(start) / 100);
    }
    tell(name, times);
    if (sum < 0) std::printf("# no fractions\n");
}

}  // namespace

int main(int count, char** words) {
    if (count != 4) {
        std::fprintf(stderr, "work LEVEL.map SEED TRIES_A_TURN|instructions\n");
        return EXIT_FAILURE;
    }
    std::ifstream file(words[1], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto level = read_map(text, words[1]);
    if (!level.ok()) {
        std::fprintf(stderr, "%s is no level\n", words[1]);
        return EXIT_FAILURE;
    }
    const World world = make_world(level.value()).value();
    const std::uint64_t seed = std::strtoull(words[2], nullptr, 10);
    if (std::string(words[3]) == "instructions") {
        count_cuts(world, seed);
        return EXIT_SUCCESS;
    }
    const int tries_a_turn = std::max(1, std::atoi(words[3]));
    const World carved = cut(world, seed, tries_a_turn, false);
    cut(world, seed, tries_a_turn, true);
    wait_for_turn();
    for (const auto& [of, in] : {std::pair{"", &world}, std::pair{"_carved", &carved}}) {
        cast_all(*in, (std::string("short_spheres") + of).c_str(), 0.3, 1, seed);
        cast_all(*in, (std::string("long_spheres") + of).c_str(), 0.3, 20, seed);
        cast_all(*in, (std::string("rays") + of).c_str(), 0, 20, seed);
    }
    return EXIT_SUCCESS;
}

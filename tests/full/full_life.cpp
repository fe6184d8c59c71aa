// SPDX-License-Identifier: MIT
// A long life: craters, each filled again a while later, over and over. At its end casts look at no more than a little
// more than in an index built anew, and answer the same. Prints a claim a world and one in total.
//
//   full_life --count 120000 --seed 1       (a third of the count in each of three worlds, half of it by each Split)
//
// Beside one another: boxes of bins and faces that casts look at, counted, and times, of nine rounds in turns the
// quickest each.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/room_grid.h"
#include "tests/full/options.h"

namespace {

using namespace firma;
using ull = unsigned long long;

constexpr double kMost = 1.15;     ///< boxes, and time: times those in an index built anew
constexpr std::size_t kOpen = 60;  ///< craters at a time

struct Life {
    std::string name;
    TreeOptions options;
    World world;
    Box where;  ///< of the cuts
    std::vector<scenes::CastQuery> casts;
};

/// Casts between places in the air of any world.
std::vector<scenes::CastQuery> casts_within(const World& world, std::size_t count, scenes::Rng& rng) {
    const Box bounds = world.bounds();
    std::vector<scenes::CastQuery> casts;
    while (casts.size() < count) {
        scenes::CastQuery query;
        for (int axis = 0; axis < 3; ++axis)
            query.sphere.centre[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        if (locate(world, query.sphere.centre).where != Where::kAir) continue;
        query.sphere.radius = rng.chance(0.5) ? 0 : rng.uniform(0.02, 0.4);
        query.path = rng.direction() * rng.uniform(0.1, rng.chance(0.5) ? 2.0 : 20.0);
        casts.push_back(query);
    }
    return casts;
}

std::vector<Life> lives(std::uint64_t seed, const TreeOptions& options) {
    scenes::Rng rng(seed);
    std::vector<Life> made;
    const scenes::RoomGrid grid = scenes::room_grid_of(6000);
    const World rooms = make_world(scenes::room_grid(grid), {.tree = options}).value();
    std::vector<scenes::CastQuery> casts;
    for (const scenes::CastRange& range : {scenes::kShortSpheres, scenes::kLongSpheres, scenes::kShortRays})
        for (const scenes::CastQuery& query : scenes::casts_in_rooms(grid, range, 1000, seed)) casts.push_back(query);
    made.push_back({"rooms", options, rooms, rooms.bounds(), casts});
    Box corner = rooms.bounds();
    for (int axis = 0; axis < 3; ++axis) corner.high[axis] = corner.low[axis] + 6;
    made.push_back({"corner", options, rooms, corner, casts});

    std::ifstream file(FIRMA_ROOT "/levels/depot.map", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const World depot = make_world(read_map(text, "depot.map").value(), {.tree = options}).value();
    made.push_back({"depot", options, depot, depot.bounds(), casts_within(depot, 3000, rng)});
    return made;
}

/// @return edits that were done
std::uint64_t live(Life& life, std::uint64_t edits, scenes::Rng& rng) {
    std::vector<Pose> open;
    std::uint64_t done = 0;
    for (std::uint64_t k = 0; k < edits; ++k) {
        const bool fills = open.size() > kOpen;
        Pose pose;
        if (fills) {
            pose = open.front();
            open.erase(open.begin());
            pose.scale *= 1.3;
        } else {
            for (int axis = 0; axis < 3; ++axis)
                pose.position[axis] = rng.uniform(life.where.low[axis], life.where.high[axis]);
            pose.rotation = random_turn(rng.next());
            pose.scale = rng.uniform(0.3, 0.9);
        }
        const Cutter cutter = make_crater(CutterShape::kRocky, fills ? 2 : 1);
        const CarveResult edit = fills ? fill(life.world, cutter, pose) : carve(life.world, cutter, pose);
        done += edit.done();
        if (edit.done()) life.world = edit.world;
        if (!fills && edit.done()) open.push_back(pose);
    }
    return done;
}

double looked_at(const World& world, const std::vector<scenes::CastQuery>& casts) {
    CastCounts counts;
    for (const scenes::CastQuery& query : casts)
        static_cast<void>(cast(world, query.sphere, query.path, {.counts = &counts}));
    return double(counts.nodes + counts.boxes);
}

double seconds(const World& world, const std::vector<scenes::CastQuery>& casts) {
    const auto start = std::chrono::steady_clock::now();
    for (const scenes::CastQuery& query : casts) static_cast<void>(cast(world, query.sphere, query.path));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of nine rounds in turns, the quickest of each.
double time_ratio(const World& world, const World& anew, const std::vector<scenes::CastQuery>& casts) {
    double quickest = 1e9, quickest_anew = 1e9;
    for (int round = 0; round < 9; ++round) {
        quickest = std::min(quickest, seconds(world, casts));
        quickest_anew = std::min(quickest_anew, seconds(anew, casts));
    }
    return quickest / quickest_anew;
}

std::uint64_t other_answers(const World& world, const World& anew, const std::vector<scenes::CastQuery>& casts) {
    std::uint64_t other = hash_world(world) != hash_world(anew);
    for (const scenes::CastQuery& query : casts) {
        const Hit one = cast(world, query.sphere, query.path), two = cast(anew, query.sphere, query.path);
        other += one.status != two.status || one.fraction != two.fraction || one.face != two.face;
    }
    return other;
}

/// What casts came to at the end of a life, beside an index built anew.
struct Sum {
    std::uint64_t done = 0;   ///< edits
    std::uint64_t other = 0;  ///< answers that differ
    double boxes = 0, time = 0;
};

Sum live_and_compare(Life& life, std::uint64_t edits, std::uint64_t seed) {
    scenes::Rng rng(seed);
    Sum sum;
    sum.done = live(life, edits, rng);
    const World anew = rebuild_index(life.world, life.options);
    sum.boxes = looked_at(life.world, life.casts) / looked_at(anew, life.casts);
    sum.time = time_ratio(life.world, anew, life.casts);
    sum.other = other_answers(life.world, anew, life.casts);
    std::printf(
        "claim=long_life family=%s_%s count=%llu seed=%llu done=%llu faces=%llu boxes=%.3f time=%.3f other=%llu\n",
        life.name.c_str(), life.options.split == Split::kSurfaceArea ? "area" : "axis", ull(edits), ull(seed),
        ull(sum.done), ull(life.world.face_count()), sum.boxes, sum.time, ull(sum.other));
    std::fflush(stdout);
    return sum;
}

}  // namespace

int main(int count, char** words) {
    full::Options options;
    options.count = 120000;
    if (!full::read_options(count, words, options, {})) {
        std::fprintf(stderr, "full_life [--count N] [--seed N]\n");
        return 2;
    }
    const std::uint64_t edits = options.count / 6;
    Sum total;
    for (const Split split : {Split::kLongestAxis, Split::kSurfaceArea})
        for (Life& life : lives(options.seed, {.split = split})) {
            const Sum sum = live_and_compare(life, edits, options.seed);
            total.done += sum.done;
            total.other += sum.other;
            total.boxes = std::max(total.boxes, sum.boxes);
            total.time = std::max(total.time, sum.time);
        }
    const bool pass = total.other == 0 && total.boxes <= kMost && total.time <= kMost && total.done >= 3 * edits;
    std::printf(
        "claim=long_life family=total count=%llu seed=%llu done=%llu boxes=%.3f time=%.3f other=%llu result=%s\n",
        ull(6 * edits), ull(options.seed), ull(total.done), total.boxes, total.time, ull(total.other),
        pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}

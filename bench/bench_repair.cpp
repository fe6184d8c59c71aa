// SPDX-License-Identifier: MIT
// What it takes to repair a peer that lost one crater of many, and to join late, in bytes and processor time.
#include <algorithm>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/edit_log.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "firma/world_patch.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

constexpr std::uint32_t kLostBeforeLast = 30;  ///< edits made after the one that is lost
constexpr int kRepairRounds = 3;

/// Milliseconds of processor time, the least of several.
template <class Work>
double least_ms(const Work& work) {
    double least = 1e9;
    for (int round = 0; round < kRepairRounds; ++round) {
        const double start = thread_seconds();
        work();
        least = std::min(least, (thread_seconds() - start) * 1e3);
    }
    return least;
}

/// Rocky craters of 0.4 to 1.2 m where random rays meet the level.
std::vector<EditCommand> craters(const World& level, std::uint32_t count) {
    std::mt19937_64 random(1);
    const auto uniform = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
    const Box bounds = level.bounds();
    std::vector<EditCommand> commands;
    while (commands.size() < count) {
        Vec3 start, path;
        for (int axis = 0; axis < 3; ++axis) start[axis] = uniform(bounds.low[axis], bounds.high[axis]);
        for (int axis = 0; axis < 3; ++axis) path[axis] = uniform(-100, 100);
        const Hit hit = cast(level, Ray{start, path});
        if (hit.status != Status::kHit) continue;
        commands.push_back(crater_command(std::uint32_t(commands.size()) + 1, {CutterShape::kRocky, random()},
                                          hit.point, uniform(0.4, 1.2), {.material = "crater"}));
    }
    return commands;
}

void measure_repairs(const World& level, std::uint32_t count, Table& table) {
    World all = level, some = level;
    EditLog log(level);
    for (const EditCommand& command : craters(level, count)) {
        all = apply(all, command).world;
        if (command.number + kLostBeforeLast != count) some = apply(some, command).world;
        if (log.append(command)) return;
    }
    const std::vector<Region> regions = differing_regions(hash_regions(some), hash_regions(all));
    const std::vector<std::byte> list = list_faces(some, regions);
    const std::vector<std::byte> patch = make_patch(all, list, "list").value();
    const std::vector<std::byte> joining = make_patch(level, all), bytes = pack_log(log);
    table.add(
        {std::to_string(count), firma::bench::count(all.face_count()), number(double(bytes.size()) / double(count)),
         firma::bench::count(28 * hash_regions(all).size()), firma::bench::count(list.size()),
         firma::bench::count(patch.size()), number(least_ms([&] { keep(list_faces(some, regions).size()); })),
         number(least_ms([&] { keep(make_patch(all, list, "list").ok()); })),
         number(least_ms([&] { keep(apply_patch(some, patch, "patch").ok()); })),
         number(least_ms([&] { keep(!check_world(all) && !check_solid(all)); })), firma::bench::count(joining.size()),
         number(least_ms([&] { keep(apply_patch(level, joining, "patch").ok()); })),
         number(least_ms([&] { keep(replay(level, log).ok()); }))});
}

int measure(const Settings& settings) {
    Table table("repair", {"craters", "faces", "log: bytes a crater", "hashes of regions: bytes", "list: bytes",
                           "patch: bytes", "list_faces ms", "make_patch ms", "apply_patch ms",
                           "all of it judged would take ms", "joining by a patch: bytes", "ms", "by the log ms"});
    const Result<BrushLevel> read = read_brush_level(settings.repository + "/levels/depot.map");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    const World level = make_world(read.value()).value();
    for (const std::uint32_t count : {200, 1000}) {
        if (settings.quick && count > 200) break;
        measure_repairs(level, settings.quick ? 40 : count, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What repairing a peer takes, and joining late."));
}

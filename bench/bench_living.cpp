// SPDX-License-Identifier: MIT
// A whole edit of a living world: a crater of 180 triangles with rooms, portals, matter, loose pieces and both hashes,
// one after the other in the depot, in rooms, and in maps; CARVING.md section 7 has the targets.
//
// The machine's speed changes from minute to minute: so all cuts are made three times, each time from the level as it
// was, and of each the fastest counts; and in turn with them a plain crater in the rooms of ten thousand triangles that
// bench_carve measures, beside whose median all times stand.
//
// Each level has a process of its own, as a game has: where others came and went, the pool's pieces lie scattered.
//
// bench_living [--csv FOLDER]; of OpenArena's maps where FIRMA_OPENARENA names their folder.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "firma/brush_world.h"
#include "firma/chunk.h"
#include "firma/rooms.h"
#include "scenes/level_cuts.h"
#include "support/craters.h"
#include "support/own_process.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "tests/openarena_maps.h"

namespace firma::bench {
namespace {

/// Of one round, or the fastest of each cut over several.
struct Row {
    std::vector<double> milliseconds;  ///< of cuts that took something
    std::size_t nothing = 0, refused = 0, chunks = 0;
    double slowest_search = 0;
};

void crater_on(World& world, const Cutter& cutter, const Pose& pose, bool all, Row& row) {
    CarveOptions options;
    if (all) options.chunks = ChunkOptions{};
    std::uint64_t hash = 0;
    const double before = thread_seconds();
    CarveResult result = carve(world, cutter, pose, options);
    if (all && result.done()) hash = hash_world(result.world) ^ hash_solid(result.world);
    const double spent = (thread_seconds() - before) * 1e3;
    keep(double(hash & 1));
    row.refused += result.status == CarveStatus::kRefused;
    row.nothing += result.status == CarveStatus::kNothing;
    if (!result.done()) return;
    row.milliseconds.push_back(spent);
    row.chunks += result.report.chunks;
    row.slowest_search = std::max(row.slowest_search, result.report.times.chunks * 1e-3);
    world = std::move(result.world);
}

void keep_fastest(Row& row, Row round) {
    for (std::size_t k = 0; k < row.milliseconds.size(); ++k)
        round.milliseconds[k] = std::min(round.milliseconds[k], row.milliseconds[k]);
    if (!row.milliseconds.empty()) round.slowest_search = std::min(round.slowest_search, row.slowest_search);
    row = std::move(round);
}

double median_of(const std::vector<double>& all, std::size_t first, std::size_t count) {
    if (all.size() < first + count || count == 0) return 0;
    return median({all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(first + count)});
}

constexpr int kPlainRooms = 2;

/// The same craters in turn in a world without the rest and in one with all of it, and a plain one in rooms.
/// @return a row of the table
template <class PoseOf>
std::vector<std::string> measure_level(const std::string& name, const World& level, std::size_t cuts, int rounds,
                                       const PoseOf& pose_of) {
    const World all_rooms = carvable_world(crater_level(kPlainRooms));
    Row without, with, in_rooms;
    const Cutter cutter = crater();
    std::size_t portals = 0;
    for (int round = 0; round < rounds; ++round) {
        World plain = level, whole = with_anchors(level), rooms = all_rooms;
        Row some_without, some_with, some_in_rooms;
        for (std::size_t k = 0; k < cuts; ++k) {
            const Pose pose = pose_of(k);
            if (k % 2) crater_on(plain, cutter, pose, false, some_without);
            crater_on(whole, cutter, pose, true, some_with);
            if (k % 2 == 0) crater_on(plain, cutter, pose, false, some_without);
            crater_on(rooms, cutter, crater_pose(kPlainRooms, CraterPlaces::kSpread, k), false, some_in_rooms);
        }
        keep_fastest(without, std::move(some_without));
        keep_fastest(with, std::move(some_with));
        keep_fastest(in_rooms, std::move(some_in_rooms));
        portals = portal_count(whole) - portal_count(level);
    }
    const double yard = median(in_rooms.milliseconds);
    const std::vector<double>& all = with.milliseconds;
    const std::size_t part = std::min<std::size_t>(100, all.size() / 4);
    const double first = median_of(all, 0, part), last = median_of(all, all.size() - part, part);
    return {name,
            count(level.face_count()),
            count(all.size()),
            count(with.nothing),
            count(with.refused),
            number(median(without.milliseconds)),
            number(median(all)),
            number(quantile(without.milliseconds, 0.99)),
            number(quantile(all, 0.99)),
            number(yard),
            times(median(all) / yard),
            times(quantile(all, 0.99) / yard),
            number(quantile(all, 1)),
            number(with.slowest_search),
            number(first),
            number(last),
            times(last / first),
            count(with.chunks),
            count(portals)};
}

/// Craters of 0.4 to 1.6 m on the walls of rooms.
auto on_walls(const World& world) {
    return [places = std::make_shared<scenes::CutPlaces>(scenes::cut_places(world))](std::size_t k) {
        scenes::Rng rng(k + 1);
        const std::vector<scenes::CutOrder> cuts = scenes::level_cuts(*places, scenes::LevelCuts::kSpread, 7, k);
        Pose pose = cuts[rng.below(std::uint32_t(cuts.size()))].pose;
        pose.rotation = random_turn(rng.next());
        pose.scale = rng.uniform(0.4, 1.6);
        return pose;
    };
}

int measure(const Settings& settings) {
    Table table("living",
                {"level", "faces", "cuts", "nothing", "refused", "cut alone ms", "whole ms", "cut alone p99 ms",
                 "whole p99 ms", "plain crater in rooms ms", "whole to plain", "whole p99 to plain", "worst ms",
                 "worst search ms", "first 100 ms", "last 100 ms", "last to first", "chunks", "portals more"});
    const std::size_t cuts = settings.quick ? 20 : 1000;
    const int rounds = settings.quick ? 1 : 3;
    std::vector<int> sizes{2, 20};
    if (settings.quick) sizes = {1};
    for (const int rooms : sizes)
        for (const CraterPlaces places : {CraterPlaces::kSpread, CraterPlaces::kCorner})
            table.add(in_own_process([&] {
                return measure_level(places == CraterPlaces::kCorner ? "rooms, in one corner" : "rooms",
                                     carvable_world(crater_level(rooms)), 2 * cuts, rounds,
                                     [&](std::size_t k) { return crater_pose(rooms, places, k); });
            }));
    std::vector<std::string> files{settings.repository + "/levels/depot.map"};
    const char* folder = std::getenv("FIRMA_OPENARENA");
    if (folder != nullptr && !settings.quick)
        for (std::size_t k = 0; k < kCarvedMaps; ++k)
            files.push_back(std::string(folder) + "/" + kRoomMaps[k] + ".bsp");
    for (const std::string& file : files)
        table.add(in_own_process([&]() -> std::vector<std::string> {
            const Result<World> world = read_world(file);
            if (!world) {
                std::fprintf(stderr, "%s\n", world.error().text().c_str());
                std::_Exit(1);
            }
            return measure_level(std::filesystem::path(file).stem().string(), world.value(), cuts, rounds,
                                 on_walls(world.value()));
        }));
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Whole edits of a living world: portals, matter, loose pieces, hashes."));
}

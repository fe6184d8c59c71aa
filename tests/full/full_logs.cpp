// SPDX-License-Identifier: MIT
// Edit logs of random commands in the depot, a map of OpenArena and buildings on grids: repaired after losses, replayed
// in slices and on threads, disjoint edits in any order, all checks after each. Prints a claim a world and one in
// total.
//
//   full_logs --what repair --count 10000 --seed 1 [--threads 2] [--maps DIR] [--world NAME] [--from CASE] [--show 3]
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "firma/brush_world.h"
#include "scenes/blast_worlds.h"
#include "scenes/blasts.h"
#include "tests/full/options.h"
#include "tests/openarena_maps.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/judge_logs.h"

namespace {

using namespace firma;
using reference::LogTally;
using ull = unsigned long long;

struct Kind {
    const char *what, *claim;
    LogTally (*judge)(const World& level, const std::string& where, scenes::Rng& rng, std::size_t count);
    std::size_t commands;  ///< a log
};
constexpr Kind kKinds[] = {{"repair", "region_repair", reference::judge_repair, 100},
                           {"replay", "log_replay", reference::judge_replay, 40},
                           {"disjoint", "disjoint_edits", reference::judge_disjoint, 30},
                           {"sequences", "log_sequences", reference::judge_sequence, 30}};

World read_map(const std::string& file) {
    const Result<BrushLevel> level = read_brush_level(file);
    if (level) return with_rules(make_world(level.value()).value(), {}).value();
    std::fprintf(stderr, "%s\n", level.error().text().c_str());
    std::exit(2);
}

/// Cases go round the worlds: every fifth one to the depot, every tenth to a map, the others to buildings.
struct Worlds {
    World depot, map;
    bool has_map = false;

    World at(std::uint64_t seed, std::uint64_t index, std::string& name) const {
        if (index % 5 == 0 && (index % 10 == 0 || !has_map)) return name = "depot", depot;
        if (index % 5 == 0) return name = kRoomMaps[1], map;
        const auto kind = std::size_t(index % 5 + index / 5) % scenes::kBlastWorldNames.size();
        name = scenes::kBlastWorldNames[kind];
        return scenes::blast_world(scenes::BlastWorld(kind), seed * 1'000'003 + index);
    }
};

void print(const Kind& kind, std::uint64_t seed, const LogTally& all) {
    const bool pass = all.failed == 0 && all.done * 2 >= all.commands;
    std::printf(
        "claim=%s family=total count=%llu seed=%llu done=%llu refused=%llu nothing=%llu logs=%llu lost=%llu "
        "repairs=%llu "
        "whole_lists=%llu bytes=%llu lies=%llu lies_refused=%llu replays=%llu checkpoints=%llu log_bytes=%llu "
        "orders=%llu "
        "rooms_made=%llu portals_made=%llu failed=%llu result=%s\n",
        kind.claim, ull(all.commands), ull(seed), ull(all.done), ull(all.refused), ull(all.nothing), ull(all.logs),
        ull(all.lost), ull(all.repairs), ull(all.whole_lists), ull(all.bytes), ull(all.lies), ull(all.lies_refused),
        ull(all.replays), ull(all.checkpoints), ull(all.log_bytes), ull(all.orders), ull(all.rooms_made),
        ull(all.portals_made), ull(all.failed), pass ? "pass" : "fail");
}

}  // namespace

int main(int count, char** words) {
    full::Options options;
    options.count = 10000;
    std::string what = "repair", folder, only;
    std::uint64_t from = 0;
    const Kind* kind = nullptr;
    const bool read = full::read_options(
        count, words, options,
        {{"--what", nullptr, &what}, {"--maps", nullptr, &folder}, {"--world", nullptr, &only}, {"--from", &from}});
    for (const Kind& known : kKinds)
        if (known.what == what) kind = &known;
    if (!read || !kind) {
        std::fprintf(stderr,
                     "full_logs --what repair|replay|disjoint|sequences [--count N] [--seed N] [--threads N] "
                     "[--maps DIR] [--world NAME] [--from CASE] [--show N]\n");
        return 2;
    }
    reference::report_contradictions();
    Worlds worlds;
    worlds.depot = read_map(FIRMA_ROOT "/levels/depot.map");
    worlds.has_map = !folder.empty();
    if (worlds.has_map) worlds.map = read_map(folder + "/" + kRoomMaps[1] + ".bsp");
    std::mutex mutex;
    LogTally all;
    std::uint64_t next = from;
    const auto work = [&] {
        for (;;) {
            std::uint64_t index = 0;
            {
                const std::lock_guard lock(mutex);
                if (all.commands >= options.count) return;
                index = next++;
            }
            std::string name;
            scenes::Rng rng(options.seed * 0x9E3779B97F4A7C15ull ^ (index + 1) * 0xD1B54A32D192ED03ull);
            const World made = worlds.at(options.seed, index, name);
            if (!only.empty() && only != name) continue;
            const World level = scenes::with_closed_doors(made, 1.0 / 3, rng);
            const std::string where = name + " seed=" + std::to_string(options.seed) + " case=" + std::to_string(index);
            const LogTally tally = kind->judge(level, where, rng, kind->commands);
            const std::lock_guard lock(mutex);
            all.add(tally);
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    for (std::size_t k = 0; k < all.failures.size() && k < options.show; ++k)
        std::printf("failure %s\n", all.failures[k].c_str());
    print(*kind, options.seed, all);
    return all.failed == 0 && all.done * 2 >= all.commands ? EXIT_SUCCESS : EXIT_FAILURE;
}

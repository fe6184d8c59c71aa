// SPDX-License-Identifier: MIT
// Thousands of blasts in worlds with rooms and doors, each judged by all that must hold of rooms: the depot, maps of
// OpenArena, buildings on grids. A third of the doors is closed. Prints a claim a world and one in total.
//
//   full_blasts --count 10000 --seed 1 [--threads 2] [--from 0] [--to N] [--family WORLD] [--maps DIR] [--show 3]
#include <filesystem>
#include <mutex>
#include <span>

#include "firma/brush_world.h"
#include "scenes/blast_worlds.h"
#include "scenes/blasts.h"
#include "tests/full/family_run.h"
#include "tests/openarena_maps.h"
#include "tests/reference/judge_blast.h"

namespace {

using namespace firma;
using ull = unsigned long long;

constexpr std::size_t kBlastsACase = 12;
constexpr double kClosedDoors = 1.0 / 3;
/// So many may be refused for what may not be carved: shots at the sky of maps.
constexpr double kMostRefused = 0.01;
/// In worlds of more faces the library's own check of all of it is made of every tenth blast.
constexpr std::size_t kLargeWorld = 8000;

struct NamedMap {
    std::string name;
    World world;
};

std::vector<NamedMap> read_maps(const full::FamilyOptions& options, const std::string& folder) {
    std::vector<std::string> files{FIRMA_ROOT "/levels/depot.map"};
    if (!folder.empty())
        for (const char* map : std::span(kRoomMaps).first(kCarvedMaps)) files.push_back(folder + "/" + map + ".bsp");
    std::vector<NamedMap> maps;
    for (const std::string& file : files) {
        const std::string name = std::filesystem::path(file).stem().string();
        if (!options.family.empty() && options.family != name) continue;
        const Result<BrushLevel> level = read_brush_level(file);
        if (!level) {
            std::fprintf(stderr, "%s\n", level.error().text().c_str());
            std::exit(2);
        }
        maps.push_back({name, with_rules(make_world(level.value()).value(), {}).value()});
    }
    return maps;
}

/// Adds up what cases came to, from several threads.
class BlastSum {
public:
    reference::CutTally judge(const World& world, const std::string& name, std::uint64_t seed, std::uint64_t index) {
        scenes::Rng rng(seed * 0x9E3779B97F4A7C15ull ^ (index + 1) * 0xD1B54A32D192ED03ull);
        const World shut = scenes::with_closed_doors(world, kClosedDoors, rng);
        const auto blasts = scenes::room_blasts(scenes::blast_places(shut), kBlastsACase, rng);
        reference::BlastJudgeOptions options;
        if (world.face_count() > kLargeWorld) options.whole_every = options.chunks_every = 10;
        const std::string where = name + " seed=" + std::to_string(seed) + " case=" + std::to_string(index);
        const reference::BlastTally tally = reference::judge_blasts(shut, blasts, where, seed ^ index << 32, options);
        const std::lock_guard lock(mutex_);
        all_.add(tally);
        return tally;
    }

    /// Whether all that is judged came up.
    bool report() const {
        std::printf(
            "blasts filled=%llu shot_from=%llu cut_short=%llu rooms_made=%llu rooms_swallowed=%llu rooms_filled=%llu "
            "choices=%llu "
            "portals_made=%llu portals_grown=%llu portals_divided=%llu portals_clipped=%llu portals_filled=%llu "
            "portal_sides=%llu door_casts=%llu open_casts=%llu room_casts=%llu ways=%llu crossings=%llu "
            "chunk_searches=%llu chunks=%llu protected=%llu ms_judged=%.1f\n",
            ull(all_.filled), ull(all_.shot_from), ull(all_.cut_short), ull(all_.rooms_made), ull(all_.rooms_swallowed),
            ull(all_.rooms_filled), ull(all_.choices), ull(all_.portals_made), ull(all_.portals_grown),
            ull(all_.portals_divided), ull(all_.portals_clipped), ull(all_.portals_filled), ull(all_.portal_sides),
            ull(all_.door_casts), ull(all_.open_casts), ull(all_.room_casts), ull(all_.ways), ull(all_.crossings),
            ull(all_.chunk_searches), ull(all_.chunks), ull(all_.protected_points),
            1e3 * all_.judge_seconds / double(std::max<ull>(all_.cuts, 1)));
        return all_.filled > 0 && all_.shot_from > 0 && all_.rooms_made > 0 && all_.choices > 0 &&
               all_.portals_made > 0 && all_.portal_sides > 0 && all_.door_casts > 0 && all_.open_casts > 0 &&
               all_.crossings > 0 && all_.chunks > 0 && all_.protected_points > 0;
    }

private:
    std::mutex mutex_;
    reference::BlastTally all_;
};

}  // namespace

int main(int count, char** words) {
    full::FamilyOptions options;
    options.count = 10000;
    std::string folder;
    std::vector<full::ExtraOption> extra = options.words();
    extra.push_back({"--maps", nullptr, &folder});
    if (!full::read_options(count, words, options, extra)) {
        std::fprintf(stderr,
                     "full_blasts [--count N] [--seed N] [--threads N] [--from CASE] [--to CASE] [--family WORLD] "
                     "[--maps DIR] [--show N]\n");
        return 2;
    }
    reference::report_contradictions();
    BlastSum sum;
    std::vector<full::JudgedFamily> families;
    const std::vector<NamedMap> maps = read_maps(options, folder);
    for (const NamedMap& map : maps)
        families.push_back({map.name, [&](std::uint64_t seed, std::uint64_t index) {
                                return sum.judge(map.world, map.name, seed, index);
                            }});
    for (std::size_t kind = 0; kind < scenes::kBlastWorldNames.size(); ++kind) {
        const std::string name(scenes::kBlastWorldNames[kind]);
        families.push_back({name, [&sum, kind, name](std::uint64_t seed, std::uint64_t index) {
                                const World world =
                                    scenes::blast_world(scenes::BlastWorld(kind), seed * 1'000'003 + index);
                                return sum.judge(world, name, seed, index);
                            }});
    }
    full::FamilyRun run(options, {"blasts", kMostRefused, 0}, families);
    if (run.empty()) {
        std::fprintf(stderr, "full_blasts: no such world\n");
        return 2;
    }
    const int status = run.run();
    const bool covered = sum.report() || options.to != ~0ull || !options.family.empty();
    if (!covered) std::printf("failure: some of what is judged never came up\n");
    return covered ? status : EXIT_FAILURE;
}

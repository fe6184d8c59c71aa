// SPDX-License-Identifier: MIT
// Levels of brushes: random piles joined and judged; casts by room against casts of all faces; rays that must not
// escape from closed rooms; craters in levels. Prints one claim.
//
//   full_levels --what piles|maps|casts|rays|cuts --count 1000000 --seed 1 [--threads 2] [--maps DIR] [--show 3]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "firma/brush_world.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/brush_piles.h"
#include "scenes/level_cuts.h"
#include "scenes/rng.h"
#include "tests/full/options.h"
#include "tests/openarena_maps.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/judge_joined.h"
#include "tests/reference/judge_rooms.h"

namespace {

using namespace firma;
using ull = unsigned long long;

constexpr double kJustBefore = 0.01;  ///< metres before what a ray meets
constexpr double kSamePoint = 1e-9;   ///< metres: faces that meet in a point are reached alike, but for rounding
constexpr double kClear = 1e-5;       ///< metres: nearer to a face it is not asked where a point is

struct Options : full::Options {
    std::string what, maps;
};

struct NamedWorld {
    std::string name;
    World world;
    World again;               ///< made once more, where it is wanted
    std::vector<bool> closed;  ///< by room: no way leads from it to the exterior
};

/// The depot, and the maps that there are.
std::vector<NamedWorld> worlds(const Options& options) {
    std::vector<std::string> files{FIRMA_ROOT "/levels/depot.map"};
    const bool cuts = options.what == "cuts";
    for (const char* map : std::span(kRoomMaps).first(cuts ? kCarvedMaps : std::size(kRoomMaps)))
        files.push_back(options.maps + "/" + map + ".bsp");
    std::vector<NamedWorld> made;
    for (const std::string& file : files) {
        const Result<BrushLevel> level = read_brush_level(file);
        if (!level.ok()) {
            std::fprintf(stderr, "%s\n", level.error().text().c_str());
            return {};
        }
        const Result<World> world = make_world(level.value());
        const World again = cuts ? make_world(level.value()).value() : World();
        made.push_back({std::filesystem::path(file).stem().string(), world.value(), again,
                        reference::closed_rooms(world.value())});
        std::printf("world name=%s faces=%zu rooms=%zu portals=%zu closed=%zu\n", made.back().name.c_str(),
                    world.value().face_count(), world.value().room_count(), portal_count(world.value()),
                    std::size_t(std::count(made.back().closed.begin(), made.back().closed.end(), true)));
    }
    return made;
}

/// What all chunks came to, and the first failures.
struct Tally {
    ull count = 0, failed = 0, extra = 0;
    std::vector<std::string> failures;

    void fail(std::string what) {
        ++failed;
        failures.push_back(std::move(what));
    }
};

/// Calls work(chunk, rng, tally) on threads until all chunks are done; prints failures.
Tally in_chunks(const Options& options, std::uint64_t chunks,
                const std::function<void(std::uint64_t, scenes::Rng&, Tally&)>& work) {
    std::uint64_t next = 0;
    std::mutex mutex;
    Tally total;
    const auto run = [&] {
        for (;;) {
            std::uint64_t chunk = 0;
            {
                const std::lock_guard lock(mutex);
                if (next == chunks) return;
                chunk = next++;
            }
            scenes::Rng rng(options.seed * 0x9E3779B97F4A7C15ull ^ (chunk + 1) * 0xD1B54A32D192ED03ull);
            Tally tally;
            work(chunk, rng, tally);
            const std::lock_guard lock(mutex);
            total.count += tally.count;
            total.failed += tally.failed;
            total.extra += tally.extra;
            for (const std::string& failure : tally.failures) {
                if (total.failures.size() >= options.show) break;
                total.failures.push_back(failure);
                std::printf("failure chunk=%llu seed=%llu %s\n", ull(chunk), ull(options.seed), failure.c_str());
            }
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(run);
    for (std::thread& thread : threads) thread.join();
    return total;
}

int tell(const char* claim, const Options& options, const Tally& tally, const char* extra) {
    const bool pass = tally.failed == 0 && tally.count > 0;
    std::printf("claim=%s family=total count=%llu seed=%llu failed=%llu %s=%llu result=%s\n", claim, tally.count,
                ull(options.seed), tally.failed, extra, tally.extra, pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// Each kind in turn, of 4 to 20 brushes.
void judge_piles(const Options& options, std::uint64_t chunk, scenes::Rng& rng, Tally& tally) {
    const auto kind = scenes::BrushPile(chunk % scenes::kBrushPiles);
    const int brushes = 4 + int(rng.below(kind == scenes::BrushPile::kCrystals ? 5 : 17));
    const std::uint64_t seed = options.seed * 1'000'000 + chunk;
    const reference::JoinedVerdict verdict = reference::judge_joined(scenes::brush_pile(kind, seed, brushes), seed);
    ++tally.count;
    tally.extra += verdict.planes_moved > 0 || verdict.left_out > 0;
    if (!verdict.fault.empty())
        tally.fail("pile=" + std::to_string(int(kind)) + " seed=" + std::to_string(seed) +
                   " brushes=" + std::to_string(brushes) + ": " + verdict.fault);
}

/// The depot and all maps in the folder, one a chunk.
int judge_maps(const Options& options) {
    std::vector<std::string> files{FIRMA_ROOT "/levels/depot.map"};
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(options.maps, none))
        if (entry.path().extension() == ".bsp") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    if (files.size() > options.count) files.resize(options.count);
    std::mutex mutex;
    const Tally tally = in_chunks(options, files.size(), [&](std::uint64_t chunk, scenes::Rng&, Tally& part) {
        const Result<BrushLevel> level = read_brush_level(files[chunk]);
        const std::string name = std::filesystem::path(files[chunk]).stem().string();
        ++part.count;
        if (!level.ok()) return part.fail(level.error().text());
        const reference::JoinedVerdict verdict = reference::judge_joined(level.value(), options.seed, 400);
        part.extra += verdict.planes_moved;
        if (!verdict.fault.empty()) part.fail(name + ": " + verdict.fault);
        if (verdict.portals > 0 && verdict.crossings == 0) part.fail(name + ": no way through a portal was judged");
        const std::lock_guard lock(mutex);
        std::printf(
            "map name=%s rooms=%zu portals=%zu points=%zu ways=%zu crossings=%zu planes_moved=%zu left_out=%zu "
            "farthest=%.3g volume=%.17g\n",
            name.c_str(), verdict.rooms, verdict.portals, verdict.points, verdict.ways, verdict.crossings,
            verdict.planes_moved, verdict.left_out, verdict.farthest, verdict.volume);
        std::fflush(stdout);
    });
    return tell("join_maps", options, tally, "planes_moved");
}

std::string text_of(const NamedWorld& in, const Sphere& sphere, const Vec3& path) {
    char text[400];
    std::snprintf(text, sizeof text, "%s: from {%.17g, %.17g, %.17g} radius %.17g by {%.17g, %.17g, %.17g}",
                  in.name.c_str(), sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius, path.x, path.y,
                  path.z);
    return text;
}

/// In a bounding box, or near a portal.
Vec3 some_point(const World& world, const Box& box, scenes::Rng& rng) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(box.low[axis], box.high[axis]);
    if (portal_count(world) == 0 || rng.chance(0.5)) return point;
    const Box door = portal_info(world, {rng.below(std::uint32_t(portal_count(world)))})->bounds;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = door.low[axis] - 1, high = door.high[axis] + 1;
        point[axis] = rng.uniform(low, high);
    }
    return point;
}

/// From the air, clear of the walls: by room as against all faces.
void judge_casts(const NamedWorld& in, std::uint64_t casts, scenes::Rng& rng, Tally& tally) {
    const Box box = in.world.bounds();
    while (tally.count < casts) {
        Sphere sphere;
        sphere.centre = some_point(in.world, box, rng);
        sphere.radius = rng.chance(0.4) ? 0 : rng.uniform(0.01, 0.6);
        if (locate(in.world, sphere.centre).where != Where::kAir) continue;
        if (closest(in.world, sphere.centre, sphere.radius + 1e-5)) continue;
        for (int k = 0; k < 8 && tally.count < casts; ++k) {
            const Vec3 direction = rng.direction();
            const Vec3 path = direction * std::exp2(rng.uniform(-4, 7));
            std::uint32_t passed = 0;
            const std::string wrong = reference::judge_cast_by_room(in.world, sphere, path, passed);
            ++tally.count;
            tally.extra += passed > 1;
            if (!wrong.empty()) tally.fail(in.name + ": " + wrong);
        }
    }
}

/// A point of a face: inside it, on its rim, a corner.
Vec3 point_of(const std::vector<Vec3>& corners, scenes::Rng& rng, Tally& tally) {
    const auto count = std::uint32_t(corners.size());
    const std::uint32_t k = rng.below(count);
    const Vec3 &a = corners[k], &b = corners[(k + 1) % count], &c = corners[(k + 2) % count];
    const double s = rng.uniform(), t = rng.uniform() * (1 - s);
    if (rng.chance(0.9)) return a + (b - a) * s + (c - a) * t;
    ++tally.extra;
    return rng.chance(0.5) ? a : a + (b - a) * s;
}

/// What is wrong with a ray from a closed room: it must meet something, the same by room as among all faces, and just
/// before that be in the air of a room that it passed. Which of several faces that meet in a point it names is open.
const char* judge_ray(const World& world, const Vec3& start, RoomId room, const Vec3& path) {
    CastOptions walls;
    walls.mask = kStopsSight;
    const Hit all = cast(world, {start, 0}, path, walls);
    if (!all.touched()) return "escapes";
    std::array<RoomId, 1024> passed;
    RoomTrail trail{passed};
    walls.room = room;
    walls.trail = &trail;
    const Hit by_room = cast(world, {start, 0}, path, walls);
    const double apart = std::fabs(by_room.fraction - all.fraction) * length(path);
    if (by_room.status != all.status || apart > kSamePoint) return "by room meets something else";
    const double before = all.fraction - std::min(0.5 * all.fraction, kJustBefore / length(path));
    const Vec3 point = start + path * before;
    if (closest(world, point, kClear)) return nullptr;
    const Location where = locate(world, point);
    const auto end = passed.begin() + std::min<std::ptrdiff_t>(trail.count, std::ssize(passed));
    if (where.where != Where::kAir || std::find(passed.begin(), end, where.room) == end)
        return "leaves the rooms that it passes";
    return nullptr;
}

/// From closed rooms: something is always met.
void shoot_rays(const NamedWorld& in, std::uint64_t rays, scenes::Rng& rng, Tally& tally) {
    const Box box = in.world.bounds();
    const double far = 4 * length(box.high - box.low);
    std::vector<Overlap> near;
    for (std::uint64_t tries = 0; tally.count < rays; ++tries) {
        if (tries > 100 * rays) return tally.fail(in.name + ": no start in a closed room was found");
        const Vec3 start = some_point(in.world, box, rng);
        const Location where = locate(in.world, start);
        if (where.where != Where::kAir || !in.closed[where.room.value]) continue;
        if (closest(in.world, start, 1e-4)) continue;
        overlap(in.world, {start, 8}, near, {.mask = kStopsSight});
        if (near.empty()) continue;
        for (int k = 0; k < 100 && tally.count < rays; ++k) {
            const std::vector<Vec3> corners = in.world.face(near[rng.below(std::uint32_t(near.size()))].face)->corners;
            const Vec3 way = point_of(corners, rng, tally) - start;
            if (!(length(way) > 1e-9)) continue;
            const Vec3 path = way * std::exp2(std::ceil(std::log2(far / length(way))));
            ++tally.count;
            if (const char* wrong = judge_ray(in.world, start, where.room, path))
                tally.fail(text_of(in, {start, 0}, path) + " " + wrong);
        }
    }
}

/// Of the cuts of levels so many may be refused for what the library is to blame for.
constexpr double kMostBlamed = 0.02;
constexpr std::uint64_t kCutsAChunk = 24;

/// Cuts of every kind in the depot and five maps: chunk by chunk the next world, world by world the next kind.
int judge_level_cuts(const Options& options, const std::vector<NamedWorld>& all) {
    const std::size_t used = std::min<std::size_t>(all.size(), 6);
    std::vector<scenes::CutPlaces> places;
    for (std::size_t k = 0; k < used; ++k) places.push_back(scenes::cut_places(all[k].world));
    reference::report_contradictions();
    std::mutex mutex;
    reference::CutTally total;
    const std::uint64_t chunks = (options.count + kCutsAChunk - 1) / kCutsAChunk;
    Tally tally = in_chunks(options, chunks, [&](std::uint64_t chunk, scenes::Rng&, Tally& part) {
        const NamedWorld& in = all[chunk % used];
        const std::size_t kind = chunk / used % scenes::kLevelCutNames.size();
        const auto cuts = scenes::level_cuts(places[chunk % used], scenes::LevelCuts(kind), options.seed, chunk);
        const std::string name = in.name + " " + std::string(scenes::kLevelCutNames[kind]);
        reference::JudgeOptions judge;
        judge.most_cuts = kCutsAChunk;
        const reference::CutTally judged =
            reference::judge_cuts(in.world, in.again, cuts, name, options.seed ^ chunk << 32, judge);
        part.count = judged.cuts;
        part.failed = judged.failed;
        part.failures = judged.failures;
        const std::lock_guard lock(mutex);
        total.add(judged);
    });
    for (const auto& [reason, some] : total.refusals)
        std::printf("refused %llu times: %s (first %s)\n", ull(some.count), reason.c_str(), some.first.c_str());
    if (double(total.blamed) > kMostBlamed * double(total.cuts))
        tally.fail("too many refusals to blame the library for");
    const bool pass =
        tally.failed == 0 && total.done > 0 && total.crossings > 0 && total.holed > 0 && total.protected_points > 0;
    std::printf(
        "claim=level_cuts family=total count=%llu seed=%llu failed=%llu done=%llu nothing=%llu refused=%llu "
        "unplaceable=%llu blamed=%llu sliced=%llu commuted=%llu reseamed=%llu replayed=%llu points=%llu "
        "rays=%llu casts=%llu room_casts=%llu crossings=%llu ways=%llu holed=%llu protected=%llu ms_a_cut=%.3f "
        "result=%s\n",
        ull(total.cuts), ull(options.seed), ull(tally.failed), ull(total.done), ull(total.nothing), ull(total.refused),
        ull(total.unplaceable), ull(total.blamed), ull(total.sliced), ull(total.commuted), ull(total.reseamed),
        ull(total.replayed), ull(total.points), ull(total.rays), ull(total.casts), ull(total.room_casts),
        ull(total.crossings), ull(total.ways), ull(total.holed), ull(total.protected_points),
        1e3 * total.carve_seconds / double(std::max<ull>(total.cuts, 1)), pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}

int run(const Options& options) {
    if (options.what == "piles")
        return tell("join_piles", options,
                    in_chunks(options, options.count,
                              [&](std::uint64_t chunk, scenes::Rng& rng, Tally& tally) {
                                  judge_piles(options, chunk, rng, tally);
                              }),
                    "moved");
    if (options.what == "maps") return judge_maps(options);
    const std::vector<NamedWorld> all = worlds(options);
    if (all.empty()) return EXIT_FAILURE;
    if (options.what == "cuts") return judge_level_cuts(options, all);
    const bool casts = options.what == "casts";
    constexpr std::uint64_t kEach = 10'000;
    const std::uint64_t chunks = (options.count + kEach - 1) / kEach;
    const Tally tally = in_chunks(options, chunks, [&](std::uint64_t chunk, scenes::Rng& rng, Tally& part) {
        const NamedWorld& in = all[chunk % all.size()];
        casts ? judge_casts(in, kEach, rng, part) : shoot_rays(in, kEach, rng, part);
    });
    return tell(casts ? "room_casts" : "room_rays", options, tally, casts ? "through_portals" : "at_edges");
}

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 1000;
    const bool read = full::read_options(count, words, options,
                                         {{"--what", nullptr, &options.what}, {"--maps", nullptr, &options.maps}});
    constexpr const char* kWhats[] = {"piles", "maps", "casts", "rays", "cuts"};
    if (!read || std::find(std::begin(kWhats), std::end(kWhats), options.what) == std::end(kWhats)) {
        std::fprintf(stderr,
                     "full_levels --what piles|maps|casts|rays|cuts [--count N] [--seed N] [--threads N] [--maps DIR] "
                     "[--show N]\n");
        return 2;
    }
    return run(options);
}

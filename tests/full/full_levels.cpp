// SPDX-License-Identifier: MIT
// Levels of brushes: random piles joined and judged; casts by room against casts of all faces; rays that must not
// escape from closed rooms; craters in levels. Prints one claim.
//
//   full_levels --what piles|casts|rays|cuts --count 1000000 --seed 1 [--threads 2] [--maps DIR] [--show 3]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "firma/carve.h"
#include "scenes/brush_piles.h"
#include "scenes/rng.h"
#include "tests/full/options.h"
#include "tests/join/judge_pile.h"

namespace {

using namespace firma;
using ull = unsigned long long;

struct Options : full::Options {
    std::string what, maps;
};

/// Of OpenArena: closed ones of every size, most of them with area portals.
constexpr const char* kMaps[] = {"kaos2",   "czest2ctf", "islandctf",  "oa_koth1",    "ctf_compromise",
                                 "pul1ctf", "oa_dm5",    "ctf_inyard", "sleekgrinder"};

struct NamedWorld {
    std::string name;
    World world;
    std::vector<bool> closed;  ///< by room: no way leads from it to the exterior
};

std::vector<bool> closed_rooms(const World& world) {
    std::vector<bool> closed;
    for (std::uint32_t k = 0; k < world.room_count(); ++k) {
        bool open = false;
        for (std::uint32_t other = 0; other < world.room_count() && !open; ++other)
            open = room_info(world, {other}).exterior && find_path(world, {k}, {other}, Doors::kAllOpen).has_value();
        closed.push_back(!open);
    }
    return closed;
}

/// The depot, and the maps that there are.
std::vector<NamedWorld> worlds(const Options& options) {
    std::vector<std::string> files{FIRMA_ROOT "/levels/depot.map"};
    for (const char* map : kMaps) files.push_back(options.maps + "/" + map + ".bsp");
    std::vector<NamedWorld> made;
    for (const std::string& file : files) {
        const Result<BrushLevel> level = read_brush_level(file);
        if (!level.ok()) {
            std::fprintf(stderr, "%s\n", level.error().text().c_str());
            return {};
        }
        const Result<World> world = make_world(level.value());
        made.push_back({std::filesystem::path(file).stem().string(), world.value(), closed_rooms(world.value())});
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
    const reference::PileVerdict verdict =
        reference::judge_pile(scenes::brush_pile(kind, seed, brushes), seed, 40, true);
    ++tally.count;
    tally.extra += verdict.moved;
    if (!verdict.fault.empty())
        tally.fail("pile=" + std::to_string(int(kind)) + " seed=" + std::to_string(seed) +
                   " brushes=" + std::to_string(brushes) + ": " + verdict.fault);
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
    const Box door = portal_info(world, {rng.below(std::uint32_t(portal_count(world)))}).bounds;
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
        const Location start = locate(in.world, sphere.centre);
        if (start.kind != Location::Kind::kRoom || closest(in.world, sphere.centre, sphere.radius + 1e-5)) continue;
        for (int k = 0; k < 8 && tally.count < casts; ++k) {
            const Vec3 direction = rng.direction();
            const Vec3 path = direction * std::exp2(rng.uniform(-4, 7));
            const Hit all = cast(in.world, sphere, path), by_room = cast(in.world, sphere, path, {.room = start.room});
            ++tally.count;
            tally.extra += by_room.rooms_passed > 1;
            if (by_room.status != all.status || by_room.fraction != all.fraction || by_room.face != all.face ||
                by_room.feature != all.feature || by_room.room != all.room || by_room.portal != all.portal)
                tally.fail(text_of(in, sphere, path));
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

/// From closed rooms: something is always met.
void shoot_rays(const NamedWorld& in, std::uint64_t rays, scenes::Rng& rng, Tally& tally) {
    const Box box = in.world.bounds();
    const double far = 4 * length(box.high - box.low);
    std::vector<NearFace> near;
    CastOptions walls;
    walls.mask = kStopsSight;
    for (std::uint64_t tries = 0; tally.count < rays; ++tries) {
        if (tries > 100 * rays) return tally.fail(in.name + ": no start in a closed room was found");
        const Vec3 start = some_point(in.world, box, rng);
        const Location where = locate(in.world, start);
        if (where.kind != Location::Kind::kRoom || !in.closed[where.room.value]) continue;
        if (closest(in.world, start, 1e-4)) continue;
        overlap(in.world, {start, 8}, near, kStopsSight);
        if (near.empty()) continue;
        for (int k = 0; k < 100 && tally.count < rays; ++k) {
            const std::vector<Vec3> corners = in.world.face(near[rng.below(std::uint32_t(near.size()))].ref).corners;
            const Vec3 way = point_of(corners, rng, tally) - start;
            if (!(length(way) > 1e-9)) continue;
            const Vec3 path = way * std::exp2(std::ceil(std::log2(far / length(way))));
            ++tally.count;
            if (!cast(in.world, {start, 0}, path, walls).touched()) tally.fail(text_of(in, {start, 0}, path));
        }
    }
}

/// Craters where shots from the air meet something, each judged.
void cut(const NamedWorld& in, std::uint64_t cuts, scenes::Rng& rng, Tally& tally) {
    World world = in.world;
    const Box box = world.bounds();
    while (tally.count < cuts) {
        const Vec3 start = some_point(world, box, rng);
        if (locate(world, start).kind != Location::Kind::kRoom) continue;
        const Vec3 direction = rng.direction();
        const Hit hit = cast(world, {start, 0}, direction * 60.0, {.mask = kStopsSight});
        if (!hit.touched()) continue;
        Pose pose;
        pose.position = hit.point;
        pose.scale = std::exp2(rng.uniform(-1, 1.5));
        const auto shape = CutterShape(rng.below(3));
        const double before = measure_solid(world).volume;
        const CarveResult result = carve(world, make_crater(shape, rng.next()), pose);
        ++tally.count;
        tally.extra += !result.done();
        world = result.world;
        const double removed = before - measure_solid(world).volume;
        if (const auto fault = check_world(world)) return tally.fail(in.name + ": " + fault->what);
        if (const auto fault = check_solid(world)) return tally.fail(in.name + ": " + fault->what);
        if (std::fabs(removed - result.report.volume) > 1e-6 * (1 + std::fabs(before) * 1e-6))
            return tally.fail(in.name + ": the volume removed is not what the solid lost");
    }
}

int run(const Options& options) {
    if (options.what == "piles")
        return tell("join_piles", options,
                    in_chunks(options, options.count,
                              [&](std::uint64_t chunk, scenes::Rng& rng, Tally& tally) {
                                  judge_piles(options, chunk, rng, tally);
                              }),
                    "moved");
    const std::vector<NamedWorld> all = worlds(options);
    if (all.empty()) return EXIT_FAILURE;
    const bool cuts = options.what == "cuts", casts = options.what == "casts";
    const std::size_t used = cuts ? 6 : all.size();
    const std::uint64_t each = cuts ? 25 : 10'000;
    const std::uint64_t chunks = (options.count + each - 1) / each;
    const Tally tally = in_chunks(options, chunks, [&](std::uint64_t chunk, scenes::Rng& rng, Tally& part) {
        const NamedWorld& in = all[chunk % used];
        if (cuts)
            cut(in, each, rng, part);
        else if (casts)
            judge_casts(in, each, rng, part);
        else
            shoot_rays(in, each, rng, part);
    });
    return tell(cuts    ? "level_cuts"
                : casts ? "room_casts"
                        : "room_rays",
                options, tally,
                cuts    ? "not_done"
                : casts ? "through_portals"
                        : "at_edges");
}

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 1000;
    const bool read = full::read_options(count, words, options,
                                         {{"--what", nullptr, &options.what}, {"--maps", nullptr, &options.maps}});
    constexpr const char* kWhats[] = {"piles", "casts", "rays", "cuts"};
    if (!read || std::find(std::begin(kWhats), std::end(kWhats), options.what) == std::end(kWhats)) {
        std::fprintf(stderr,
                     "full_levels --what piles|casts|rays|cuts [--count N] [--seed N] [--threads N] [--maps DIR] "
                     "[--show N]\n");
        return 2;
    }
    return run(options);
}

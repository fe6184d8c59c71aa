// SPDX-License-Identifier: MIT
// Firma beside the libraries that Debian has, from ten thousand to ten million triangles: builds, memory, casts, cuts;
// and whether the answers agree. run.sh builds and runs it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "firma/memory.h"
#include "firma/mesh.h"
#include "scale/child.h"
#include "scale/cuts.h"
#include "scale/differences.h"
#include "scale/dump.h"
#include "scale/scale_peer.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/table.h"

namespace firma::bench {
namespace {

struct ScaleSettings {
    bool quick = false, full = false;
    std::string csv, dump;
    std::vector<std::size_t> sizes{10'000, 30'000, 100'000, 300'000, 1'000'000};
    int rounds = 5;
    std::size_t casts = 20'000;
    double cast_budget = 0.3;  ///< seconds a round for each peer and kind of cast; slower ones get fewer casts
    double cut_budget = 8;     ///< seconds for all cuts of each
    std::size_t cuts = 200;
    double judged = 2e8;             ///< triangles looked at to judge differences, see Judge
    std::size_t dumped = 1'200'000;  ///< triangles of the largest scene that is written for node
};

constexpr const char* kHelp = R"(Firma beside the libraries that Debian has, by size of the scene.

bench_scale [--quick | --full] [--sizes N,N,...] [--rounds N] [--csv FOLDER] [--dump FOLDER]
  --quick   ten thousand triangles, few casts: to see that it works
  --full    ten million triangles as well, and slow libraries on larger scenes
  --csv     tables as CSV into this folder
  --dump    scenes, casts and Firma's answers for bench/node/bench_scale.mjs into this folder
)";

[[noreturn]] void refuse_argument(const char* argument) {
    std::fprintf(stderr, "bench_scale: what is %s? Try --help\n", argument);
    std::exit(2);
}

std::vector<std::size_t> read_sizes(const char* text) {
    std::vector<std::size_t> sizes;
    for (const char* at = text;;) {
        char* end = nullptr;
        sizes.push_back(std::strtoull(at, &end, 10));
        if (end == at || sizes.back() < 1000 || sizes.back() > 20'000'000) refuse_argument(text);
        if (*end == 0) return sizes;
        if (*end != ',') refuse_argument(text);
        at = end + 1;
    }
}

ScaleSettings read_scale_settings(int argc, char** argv) {
    ScaleSettings settings;
    for (int k = 1; k < argc; ++k) {
        const bool has_next = k + 1 < argc;
        if (!std::strcmp(argv[k], "--help")) std::fputs(kHelp, stdout), std::exit(0);
        if (!std::strcmp(argv[k], "--quick")) {
            settings.quick = true;
            settings.sizes = {10'000};
            settings.rounds = 1;
            settings.casts = 300;
            settings.cast_budget = 0.02;
            settings.cut_budget = 0.3;
            settings.cuts = 10;
        } else if (!std::strcmp(argv[k], "--full")) {
            settings.full = true;
            settings.sizes.push_back(10'000'000);
        } else if (!std::strcmp(argv[k], "--sizes") && has_next)
            settings.sizes = read_sizes(argv[++k]);
        else if (!std::strcmp(argv[k], "--rounds") && has_next)
            settings.rounds = std::max(1, std::atoi(argv[++k]));
        else if (!std::strcmp(argv[k], "--csv") && has_next)
            settings.csv = argv[++k];
        else if (!std::strcmp(argv[k], "--dump") && has_next)
            settings.dump = argv[++k];
        else
            refuse_argument(argv[k]);
    }
    return settings;
}

bool takes_part(const PeerEntry& peer, const ScaleScene& scene, const ScaleSettings& settings) {
    return scene.mesh.triangles() <= (settings.full ? peer.max_in_full : peer.max_triangles);
}

void say(const ScaleScene& scene, const char* what) {
    std::fprintf(stderr, "%s, %s triangles: %s\n", scene.name.c_str(), count(scene.mesh.triangles()).c_str(), what);
}

// ---- builds and memory

/// What a way of building cost: the first time with its memory, the second time, on memory that the process has, its
/// time. The largest scenes are built once.
struct BuildCost {
    double seconds = 0, resident = 0, peak = 0, own = 0;
};

/// @param make  gives a thing whose run() builds and whose own_bytes() tells what it holds
template <class Make>
BuildCost cost_of(const Make& make, bool twice) {
    BuildCost cost;
    {
        auto thing = make();
        const double before = resident_bytes();
        forget_peak();
        const double start = process_seconds();
        thing.run();
        cost.seconds = process_seconds() - start;
        cost.peak = peak_bytes() - before;
        cost.resident = resident_bytes() - before;
        cost.own = double(thing.own_bytes());
    }
    if (twice) {
        auto thing = make();
        const double start = process_seconds();
        thing.run();
        cost.seconds = process_seconds() - start;
    }
    return cost;
}

struct PeerBuild {
    std::unique_ptr<ScalePeer> peer;
    const ScaleScene& scene;

    void run() { peer->build(scene); }
    std::size_t own_bytes() const { return peer->own_bytes(); }
};

struct ExactBuild {
    Level level;
    std::optional<World> world;

    void run() { world = make_world(level).value(); }
    std::size_t own_bytes() const { return memory_used(*world); }
};

struct MeshBuild {
    std::vector<Vec3> vertices;
    std::span<const std::uint32_t> corners;
    std::optional<Level> level;

    void run() {
        Mesh mesh;
        mesh.vertices = vertices;
        mesh.corners = corners;
        level = level_from_mesh(mesh, "scene").value();
    }
    std::size_t own_bytes() const { return 0; }
};

struct WayToBuild {
    std::string name;
    std::function<BuildCost(bool twice)> cost;
};

std::vector<WayToBuild> ways_to_build(const ScaleScene& scene, const ScaleSettings& settings) {
    std::vector<WayToBuild> ways;
    for (const PeerEntry& peer : scale_peers()) {
        if (!takes_part(peer, scene, settings)) continue;
        ways.push_back({peer.name, [&](bool twice) {
                            return cost_of(
                                [&] {
                                    PeerBuild build{peer.make(), scene};
                                    build.peer->prepare(scene);
                                    return build;
                                },
                                twice);
                        }});
    }
    ways[0].name = "Firma, castable only";
    ways.insert(ways.begin() + 1, {"Firma, with the exact part", [&](bool twice) {
                                       return cost_of([&] { return ExactBuild{closed_level(scene), {}}; }, twice);
                                   }});
    ways.insert(ways.begin() + 2, {"Firma's level_from_mesh() before", [&](bool twice) {
                                       return cost_of(
                                           [&] {
                                               MeshBuild build{{}, scene.mesh.corners, {}};
                                               for (const GridPoint& v : scene.level.vertices)
                                                   build.vertices.push_back(to_metres(v));
                                               return build;
                                           },
                                           twice);
                                   }});
    return ways;
}

void measure_builds(const ScaleScene& scene, const ScaleSettings& settings, Table& table) {
    say(scene, "builds");
    const std::vector<WayToBuild> ways = ways_to_build(scene, settings);
    const bool large = scene.mesh.triangles() > 3'000'000;
    const int rounds = large ? 1 : std::min(settings.rounds, 3);
    std::vector<std::vector<double>> seconds(ways.size()), ratios(ways.size());
    std::vector<BuildCost> costs(ways.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < ways.size(); ++k) {
            const auto rows = rows_of_child("the build of " + ways[k].name, [&](std::vector<Cells>& cells) {
                const BuildCost cost = ways[k].cost(!large);
                cells.push_back({std::to_string(cost.seconds), std::to_string(cost.resident), std::to_string(cost.peak),
                                 std::to_string(cost.own)});
            });
            if (rows.empty()) continue;
            costs[k] = {std::stod(rows[0][0]), std::stod(rows[0][1]), std::stod(rows[0][2]), std::stod(rows[0][3])};
            seconds[k].push_back(costs[k].seconds);
            ratios[k].push_back(costs[k].seconds / costs[0].seconds);
        }
    const auto a_triangle = [&](double bytes) {
        return bytes > 0 ? number(bytes / double(scene.mesh.triangles())) : std::string();
    };
    for (std::size_t k = 0; k < ways.size(); ++k)
        if (!seconds[k].empty())
            table.add({scene.name, count(scene.mesh.triangles()), ways[k].name, number(median(seconds[k]) * 1e3),
                       times(median(ratios[k])), a_triangle(costs[k].resident), a_triangle(costs[k].peak),
                       a_triangle(costs[k].own)});
}

// ---- casts

struct Caster {
    std::size_t place;  ///< in scale_peer_names()
    std::unique_ptr<ScalePeer> peer;
};

std::size_t place_of(const char* name) {
    const auto names = scale_peer_names();
    return std::size_t(std::find(names.begin(), names.end(), std::string_view(name)) - names.begin());
}

/// How many of the casts fit a round.
std::size_t casts_in_time(ScalePeer& peer, CastShape shape, std::span<const FloatCast> casts, double budget) {
    std::vector<double> fractions(casts.size());
    std::size_t some = 2;
    for (;;) {
        some = std::min(some, casts.size());
        const double start = thread_seconds();
        peer.cast(shape, casts.first(some), fractions.data());
        const double spent = thread_seconds() - start;
        if (some == casts.size()) return some;
        if (spent > budget / 8)
            return std::clamp(std::size_t(double(some) * budget / spent), std::size_t(2), casts.size());
        some *= 4;
    }
}

/// Rows: "casts", place of the kind, cells; "answers", place of the kind, cells.
void cast_by_all(const ScaleScene& scene, const ScaleSettings& settings, std::vector<Cells>& rows) {
    std::vector<Caster> casters;
    for (const PeerEntry& peer : scale_peers()) {
        if (!takes_part(peer, scene, settings)) continue;
        casters.push_back({place_of(peer.name), peer.make()});
        casters.back().peer->prepare(scene);
        casters.back().peer->build(scene);
    }
    const World world = make_world(castable_only(scene.level)).value();
    const std::string triangles = count(scene.mesh.triangles());
    SceneDump dump(scene, settings.casts);
    for (const KindOfCast& kind : kKinds) {
        const std::string place = std::to_string(&kind - kKinds);
        const std::vector<FloatCast> casts = casts_of(scene, kind, world, settings.casts);
        std::vector<Contender> contenders;
        std::vector<const Caster*> who;
        std::vector<std::vector<double>> fractions;
        fractions.reserve(casters.size());
        for (const Caster& caster : casters) {
            if (!caster.peer->has(kind.shape)) continue;
            const std::size_t some = casts_in_time(*caster.peer, kind.shape, casts, settings.cast_budget);
            std::vector<double>& answers = fractions.emplace_back(caster.place == 0 ? casts.size() : some);
            contenders.push_back({"", [&, peer = caster.peer.get()] {
                                      peer->cast(kind.shape, std::span(casts).first(answers.size()), answers.data());
                                  }});
            who.push_back(&caster);
        }
        const std::vector<Lap> laps = race(contenders, settings.rounds);
        const std::size_t peers = scale_peer_names().size();
        Cells row{"casts", place, scene.name, triangles, kind.name};
        row.resize(5 + 3 * peers);
        Judge judge(scene.mesh, casts, kind.at_edges, settings.judged);
        for (std::size_t k = 0; k < who.size(); ++k) {
            const double asked = double(fractions[k].size());
            const std::size_t at = 5 + who[k]->place;
            row[at] = number(laps[k].seconds / asked * 1e9);
            if (k > 0) row[at + peers] = times(laps[k].ratio * double(casts.size()) / asked);
            row[at + 2 * peers] = count(fractions[k].size());
            const Differences d = judge.compare(fractions[0], fractions[k]);
            rows.push_back({"answers", place, scene.name, triangles, kind.name, scale_peer_names()[who[k]->place],
                            count(d.asked), count(d.hits), count(d.differ), count(d.judged), count(d.wrong),
                            count(d.missed), count(d.false_hits), count(d.early), count(d.late),
                            kind.at_edges ? count(d.leaks) : "", count(d.ours_wrong)});
        }
        rows.push_back(row);
        dump.add(kind, casts, fractions[0]);
    }
    if (!settings.dump.empty() && scene.mesh.triangles() <= settings.dumped) dump.write(settings.dump);
}

// ---- cuts

void cut_by_both(const ScaleScene& scene, const ScaleSettings& settings, std::vector<Cells>& rows) {
    const Level level = closed_level(scene);
    const World world = make_world(level).value();
    const std::vector<Pose> poses = crater_poses(scene, world, settings.cuts);
    const CutTimes ours = cut_by_firma(world, poses, settings.cut_budget);
    const bool beside = has_cgal_cuts() && (settings.full || scene.mesh.triangles() <= 2'000'000);
    const CutTimes theirs = beside ? cut_by_cgal(mesh_of_level(level), poses, settings.cut_budget) : CutTimes();
    const std::size_t both = std::min(ours.ms.size(), theirs.ms.size());
    Cells row{scene.name,
              count(scene.mesh.triangles()),
              count(world.solid().face_count()),
              count(ours.ms.size()),
              number(median(ours.ms)),
              number(quantile(ours.ms, 0.99)),
              count(ours.refused)};
    row.resize(13);
    if (both > 0) {
        row[7] = count(theirs.ms.size());
        row[8] = number(median(theirs.ms));
        row[9] = times(median(theirs.ms) / median(ours.ms));
        row[10] = number(ours.taken[both - 1]);
        row[11] = number(theirs.taken[both - 1]);
        row[12] = number(std::fabs(theirs.taken[both - 1] / ours.taken[both - 1] - 1));
    }
    rows.push_back(row);
}

// ---- all of it

std::vector<std::string> cast_columns() {
    std::vector<std::string> columns{"scene", "triangles", "casts"};
    const auto names = scale_peer_names();
    for (const char* name : names) columns.push_back(std::string(name) + " ns");
    for (const char* name : names) columns.push_back(std::string(name) + " to Firma");
    for (const char* name : names) columns.push_back("casts by " + std::string(name));
    columns.erase(columns.begin() + std::ptrdiff_t(3 + names.size()));  // Firma to Firma
    return columns;
}

int measure(const ScaleSettings& settings) {
    Table who("scale_who", {"who", "what"});
    for (const Cells& row : rows_of_child("the names", [](std::vector<Cells>& rows) {
             for (const PeerEntry& peer : scale_peers()) rows.push_back({peer.name, peer.make()->describe()});
             if (has_cgal_cuts())
                 rows.push_back({"CGAL's cuts", "corefine_and_compute_difference() in place, exact predicates"});
         }))
        who.add(row);
    Table builds("scale_builds", {"scene", "triangles", "who", "build ms", "to Firma, castable only",
                                  "resident bytes a triangle", "peak bytes a triangle", "its own count of it"});
    Table casts("scale_casts", cast_columns());
    Table answers("scale_answers", {"scene", "triangles", "casts", "who", "asked", "hits", "differ from Firma",
                                    "judged", "wrong", "missed", "false", "early", "late", "leaks", "Firma wrong"});
    Table cuts("scale_cuts",
               {"scene", "triangles", "of the solid", "cuts", "Firma median ms", "Firma p99 ms", "not cut by Firma",
                "CGAL's cuts", "CGAL median ms", "CGAL to Firma", "Firma took m3", "CGAL took m3", "differ by"});
    std::vector<std::vector<Cells>> cast_rows(std::size(kKinds)), answer_rows(std::size(kKinds));
    bool fine = true;
    for (const auto make_scene : {ground_scene, rooms_scene_of})
        for (const std::size_t triangles : settings.sizes) {
            const ScaleScene scene = make_scene(triangles);
            measure_builds(scene, settings, builds);
            say(scene, "casts");
            const auto rows = rows_of_child("the casts", [&](auto& cells) { cast_by_all(scene, settings, cells); });
            fine &= !rows.empty();
            for (const Cells& row : rows)
                (row[0] == "casts" ? cast_rows : answer_rows)[std::stoul(row[1])].push_back(
                    {row.begin() + 2, row.end()});
            say(scene, "cuts");
            const auto cut = rows_of_child("the cuts", [&](auto& cells) { cut_by_both(scene, settings, cells); });
            fine &= !cut.empty();
            for (const Cells& row : cut) cuts.add(row);
        }
    const std::size_t firma_to_firma = 3 + scale_peer_names().size();
    for (std::size_t kind = 0; kind < std::size(kKinds); ++kind) {
        for (Cells row : cast_rows[kind]) {
            row.erase(row.begin() + std::ptrdiff_t(firma_to_firma));
            casts.add(row);
        }
        for (const Cells& row : answer_rows[kind]) answers.add(row);
    }
    for (const Table* table : {&who, &builds, &casts, &answers, &cuts}) fine &= table->finish(settings.csv);
    return fine ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_scale_settings(argc, argv));
}

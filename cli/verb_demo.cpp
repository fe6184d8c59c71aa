// SPDX-License-Identifier: MIT
// A fire fight (demo_fight.h); or casts and craters, an oracle without a tree that says whether casts are right, a
// table and pictures.
#include "cli/verbs.h"
#include "firma/batch.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/anchor_options.h"
#include "cli/atomic_file.h"
#include "cli/demo_casts.h"
#include "cli/demo_craters.h"
#include "cli/demo_depot.h"
#include "cli/demo_fight.h"
#include "cli/failure.h"
#include "cli/find_camera.h"
#include "cli/fire_blast.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "cli/read_hits.h"
#include "cli/tbb_tasks.h"
#include "draw/draw_plan.h"
#include "draw/draw_view.h"
#include "draw/picture.h"
#include "firma/polygon.h"

namespace firma::cli {

namespace {

struct DemoArguments {
    LevelArguments level;
    std::string out, casts, craters, seed, frames, seconds;
    bool json = false;

    /// Casts and craters in place of the fire fight.
    bool wants_casts() const { return !out.empty() || !casts.empty() || !craters.empty(); }
};

constexpr std::size_t kSample = 2000;
constexpr std::size_t kMostOracleFaces = 40000000;  // faces the oracle looks at in all; a smaller sample in huge levels
constexpr std::size_t kDrawn = 100;

constexpr const char* kDemoFooter =
    R"(Without LEVEL it takes levels/depot.map, here or in the folder that Firma was built from.

It is a fire fight, at 60 frames a second: rockets fly and blow craters; what comes loose falls, breaks as its matter
does, tumbles and comes to rest; a player walks about and is pushed by blasts. In the depot the bridge across the hall
is shot at both ends and falls, then the crane and two pillars, and the player goes through a hole that was just blown in
a wall; in other levels the player walks where there is room, fires at what it sees, and goes through the holes that come
of it. All follows from the level and --seed; the hash at the end covers the world, all bodies, rockets and the player.

After each frame it is judged: no sphere of a body may be deeper in the level than the contact offset and no centre in
solid, no body lost, the player neither in solid nor overlapping anything nor stuck, and out of a closed level no ray may
escape. The first fault ends it. A crater that would open a way out of the level is taken back.

--frames FOLDER draws film strips of it, nine frames each: fight.png, and of the depot bridge.png. Bodies are drawn as
the solids that they are.

--casts, --craters or -o ask for casts and craters in place of the fire fight, and a picture: an SVG in build/demo.svg
where there is a levels/depot.map, else in firma_demo.svg; -o names another.

The casts are seeded: half of them particles, half spheres of up to 0.5 m, paths from a thousandth of the level's
diagonal to all of it. A sample is checked against a reference oracle without a tree, which asks the pair function of every
face; they must agree to the last bit.

In the depot two things are shot at first. The bridge across the hall, at both ends: it hangs on nothing then, so it
leaves the level as a chunk, with volume and mass. And the wall of 6 cm between two offices: the hole is a portal
between them, and a cast that met the wall before goes through it.

Then craters are carved where casts meet the level (200, or --craters; 0.4 to 1.6 m, made from the seed), with the
same casts spread between them, checked again after the last. Out of a closed level no ray may escape, after any
of them: 100 are cast after each. Pieces that come loose leave the level; brushes of firma_anchor hold what reaches into
them. The picture shows the level after them;
beside it, in FILE_view.png, stands a view before and after: of the depot's bridge, else the one that shows craters
well. Levels without closed solids have nothing to carve.

--json: of the fire fight level, frames, seconds, wall_seconds, rockets {fired, hit}, craters {done, nothing, refused,
taken_back (of these)}, bodies {loose, broken, dust, unfit, pushes, max, end, at_rest, removed, lost, spheres_judged,
deepest_mm}, player {way (metres), through_solid (times that it came to where the level was solid), pushed, rooms, at},
blasts [{seconds, at, crater, loose, broken}], rays {cast, escaped}, ms {casts, cuts, bodies, debris, player: {mean,
worst} of a frame, processor time}, hash, pictures, fault (null
where all held).

--json: of casts and craters level, faces, read_seconds, build_seconds, casts, hit, touching, miss, casts_per_second (one thread),
casts_per_second_all_threads, threads, faces_per_cast, share_of_faces, checked, disagreements, depot {bridge {shots,
ms, chunks, crumbs, volume, mass, largest {volume, mass, centre}}, hole {ms, portals, portal (its id, or null), rooms [two names], area, before
{distance, material, room}, after}} (null of other levels, and with --craters 0), craters {count, done, nothing,
nothing_castable_only (of these), refused, median_ms, p99_ms, volume, chunks, chunk_volume, crumbs, faces_after, casts,
casts_per_second, rays, escaped_before, escaped, checked, disagreements, hash}, view (null where there is none), out.

Exit codes: 0 done; 1 something did not hold, the oracle disagrees or a ray escapes; 2 a bad call or bad input, with `firma: place: reason` on stderr.
)";

struct Checked {
    std::size_t casts = 0, disagreements = 0;
    std::string first;  ///< disagreement
};

struct Results {
    std::vector<Hit> hits;
    std::size_t hit = 0, touching = 0, miss = 0;
    CastCounts counts;
    double seconds = 0, parallel_seconds = 0;  ///< of all casts on one thread, on all
    int threads = 1;
    Checked checked, checked_after;  ///< without craters, after the last
    std::optional<DemoDepot> depot;
    DemoCraters craters;
    std::string view;  ///< the picture of them; empty: none

    std::size_t disagreements() const { return checked.disagreements + checked_after.disagreements; }
};

void fire(const World& world, const std::vector<Query>& queries, Results& results) {
    results.hits.resize(queries.size());
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < queries.size(); ++k) results.hits[k] = cast(world, queries[k].sphere, queries[k].path);
    results.seconds = seconds_since(start);

    results.threads = tbb::this_task_arena::max_concurrency();
    std::vector<Hit> again(queries.size());
    std::vector<CastInput> inputs;
    for (const Query& query : queries) inputs.push_back({query.sphere, query.path});
    const Tasks tasks{.run = run_by_tbb};
    const auto parallel_start = std::chrono::steady_clock::now();
    const ManyResult all = cast_many(world, inputs, again, {.tasks = &tasks});
    results.parallel_seconds = seconds_since(parallel_start);
    if (all != ManyResult::kDone) throw Failure("demo", "casts on all threads were not all made");

    CastOptions counting;
    counting.counts = &results.counts;
    for (const Query& query : queries) static_cast<void>(cast(world, query.sphere, query.path, counting));
    for (const Hit& hit : results.hits) {
        results.hit += hit.status == Status::kHit;
        results.touching += hit.status == Status::kInitialOverlap;
        results.miss += !hit.touched();
    }
}

/// The first touch by asking every face, in order of id, by itself.
struct OracleHit {
    PolygonHit hit;
    FaceId face;
};
OracleHit ask_every_face(const std::vector<Face>& faces, const Query& query) {
    OracleHit first;
    for (const Face& face : faces) {
        const Sides sides = face.two_sided ? Sides::kBoth : Sides::kFront;
        const PolygonHit hit = cast_polygon(query.sphere, query.path, face.corners, sides);
        if (hit.touched() && (!first.hit.touched() || hit.fraction < first.hit.fraction)) first = {hit, face.id};
    }
    return first;
}

bool agree(const Hit& hit, const OracleHit& oracle) {
    if (hit.touched() != oracle.hit.touched()) return false;
    if (!hit.touched()) return hit.status == oracle.hit.status;
    return hit.status == oracle.hit.status && hit.fraction == oracle.hit.fraction && hit.face.id == oracle.face;
}

std::string describe(const Query& query, const Hit& hit, const OracleHit& oracle) {
    const Vec3 &p = query.sphere.centre, &d = query.path;
    return fmt::format(
        "start {:.17g},{:.17g},{:.17g} path {:.17g},{:.17g},{:.17g} radius {:.17g}: world says status {} at {:.17g} "
        "face "
        "{}, the oracle says status {} at {:.17g} face {}",
        p.x, p.y, p.z, d.x, d.y, d.z, query.sphere.radius, int(hit.status), hit.fraction, hit.face.id.value,
        int(oracle.hit.status), oracle.hit.fraction, oracle.face.value);
}

Checked check_sample(const World& world, const std::vector<Query>& queries) {
    Checked checked;
    const std::vector<Face> faces = world.faces();
    if (faces.empty()) return checked;
    checked.casts = std::min({kSample, queries.size(), std::max<std::size_t>(kMostOracleFaces / faces.size(), 20)});
    Progress progress("checking", checked.casts);
    std::vector<std::string> wrong(checked.casts);
    tbb::parallel_for(std::size_t(0), checked.casts, [&](std::size_t k) {
        const Query& query = queries[k * queries.size() / checked.casts];
        const Hit hit = cast(world, query.sphere, query.path);
        const OracleHit oracle = ask_every_face(faces, query);
        if (!agree(hit, oracle)) wrong[k] = describe(query, hit, oracle);
        progress.add(1);
    });
    for (const std::string& text : wrong) {
        if (text.empty()) continue;
        if (checked.disagreements++ == 0) checked.first = text;
    }
    return checked;
}

draw::Plan draw(const World& world, const std::vector<Query>& queries, const std::string& title) {
    std::vector<draw::DrawnCast> casts;
    for (const Query& query : queries) casts.push_back(drawn(query, cast(world, query.sphere, query.path)));
    draw::PlanOptions options;
    options.title = title;
    options.most_casts = kDrawn;
    return draw::draw_plan(world, casts, options);
}

double per_cast(const Results& results) {
    return results.hits.empty() ? 0 : double(results.counts.faces) / double(results.hits.size());
}

double rate(std::size_t casts, double seconds) {
    return seconds > 0 ? double(casts) / seconds : 0;
}

std::string checked_text(const Checked& checked) {
    return fmt::format("{} casts, {} disagreements", grouped(checked.casts), grouped(checked.disagreements));
}

std::string row_text(const char* what, const std::string& value) {
    return fmt::format("{:<24} {}\n", what, value);
}

std::string craters_text(const LoadedLevel& loaded, const Results& results) {
    const DemoCraters& craters = results.craters;
    if (craters.fired == 0) return "";
    std::string text =
        row_text("craters", fmt::format("{}: {} done, {} nothing, {} refused", grouped(craters.fired),
                                        grouped(craters.done), grouped(craters.nothing), grouped(craters.refused)));
    if (craters.nothing_castable_only > 0)
        text +=
            row_text("", fmt::format("{} of them met only faces that stay", grouped(craters.nothing_castable_only)));
    for (const auto& [reason, count] : craters.refusals)
        text += row_text("", fmt::format("{} refused: {}", grouped(count), reason));
    if (craters.done == 0) return text + row_text("", "nothing here that a crater takes");
    std::vector<double> seconds = craters.seconds;
    text += row_text("time of a crater",
                     fmt::format("median {}, 99th percentile {}", seconds_text(percentile(seconds, 0.5)),
                                 seconds_text(percentile(seconds, 0.99))));
    text += row_text("volume taken", fmt::format("{:.4g} cubic metres", craters.volume));
    if (craters.volume == 0) text += row_text("", "nothing here bounds a closed solid: craters are holes in faces");
    if (craters.chunks + craters.crumbs > 0)
        text += row_text("came loose", fmt::format("{} of {:.3g} cubic metres, {}", counted(craters.chunks, "chunk"),
                                                   craters.chunk_volume, counted(craters.crumbs, "crumb")));
    text += row_text(
        "faces after",
        fmt::format("{}, {:.0f} more a crater", grouped(craters.after.face_count()),
                    (double(craters.after.face_count()) - double(loaded.world.face_count())) / double(craters.done)));
    text += row_text("casts between", fmt::format("{}: {} a second on one thread", grouped(craters.casts),
                                                  grouped(std::uint64_t(rate(craters.casts, craters.cast_seconds)))));
    text += row_text("rays that escape",
                     craters.escaped_before == 0
                         ? fmt::format("{} of {}", grouped(craters.escaped), grouped(craters.rays))
                         : fmt::format("{} of {}; {} before: the level is open", grouped(craters.escaped),
                                       grouped(craters.rays), grouped(craters.escaped_before)));
    text += row_text("checked by the oracle", checked_text(results.checked_after));
    return text + row_text("hash of the world", fmt::format("{:016x}", hash_world(craters.after)));
}

std::string text_for_people(const LoadedLevel& loaded, const Results& results, const std::string& out) {
    std::string text;
    const auto row = [&](const char* what, const std::string& value) { text += row_text(what, value); };
    const double faces = double(std::max<std::size_t>(loaded.world.face_count(), 1));
    row("level", loaded.level.name);
    row("faces", grouped(loaded.world.face_count()));
    row("time to read", seconds_text(loaded.read_seconds));
    row("time to build", seconds_text(loaded.build_seconds));
    row("casts", fmt::format("{}: {} hit, {} initial overlap, {} miss", grouped(results.hits.size()),
                             grouped(results.hit), grouped(results.touching), grouped(results.miss)));
    row("casts a second",
        fmt::format("{} on one thread, {} on {}", grouped(std::uint64_t(rate(results.hits.size(), results.seconds))),
                    grouped(std::uint64_t(rate(results.hits.size(), results.parallel_seconds))), results.threads));
    row("candidate faces a cast",
        fmt::format("{:.1f}, {:.2f}% of all", per_cast(results), 100 * per_cast(results) / faces));
    row("checked by the oracle", checked_text(results.checked));
    if (results.depot) text += depot_text(*results.depot);
    text += craters_text(loaded, results);
    row("picture", out);
    if (!results.view.empty()) row("before and after", results.view);
    if (results.disagreements() > 0)
        text += "\nTHE ORACLE DISAGREES: casts through the tree are not right. The first:\n" +
                (results.checked.first.empty() ? results.checked_after.first : results.checked.first) + "\n";
    if (results.craters.leaks()) text += "\nTHE LEVEL LEAKS: rays escape through what was carved.\n";
    return text;
}

Json craters_json(const Results& results) {
    const DemoCraters& craters = results.craters;
    std::vector<double> seconds = craters.seconds;
    Json json;
    json["count"] = craters.fired;
    json["done"] = craters.done;
    json["nothing"] = craters.nothing;
    json["nothing_castable_only"] = craters.nothing_castable_only;
    json["refused"] = craters.refused;
    json["median_ms"] = 1e3 * percentile(seconds, 0.5);
    json["p99_ms"] = 1e3 * percentile(seconds, 0.99);
    json["volume"] = craters.volume;
    json["chunks"] = craters.chunks;
    json["chunk_volume"] = craters.chunk_volume;
    json["crumbs"] = craters.crumbs;
    json["faces_after"] = craters.after.face_count();
    json["casts"] = craters.casts;
    json["casts_per_second"] = rate(craters.casts, craters.cast_seconds);
    json["rays"] = craters.rays;
    json["escaped_before"] = craters.escaped_before;
    json["escaped"] = craters.escaped;
    json["checked"] = results.checked_after.casts;
    json["disagreements"] = results.checked_after.disagreements;
    if (results.checked_after.disagreements > 0) json["first_disagreement"] = results.checked_after.first;
    json["hash"] = fmt::format("{:016x}", hash_world(craters.after));
    return json;
}

Json json_of(const LoadedLevel& loaded, const Results& results, const std::string& out) {
    const std::size_t faces = loaded.world.face_count();
    Json json;
    json["level"] = loaded.level.name;
    json["faces"] = faces;
    json["read_seconds"] = loaded.read_seconds;
    json["build_seconds"] = loaded.build_seconds;
    json["casts"] = results.hits.size();
    json["hit"] = results.hit;
    json["touching"] = results.touching;
    json["miss"] = results.miss;
    json["casts_per_second"] = rate(results.hits.size(), results.seconds);
    json["casts_per_second_all_threads"] = rate(results.hits.size(), results.parallel_seconds);
    json["threads"] = results.threads;
    json["faces_per_cast"] = per_cast(results);
    json["share_of_faces"] = faces > 0 ? per_cast(results) / double(faces) : 0;
    json["checked"] = results.checked.casts;
    json["disagreements"] = results.checked.disagreements;
    if (results.checked.disagreements > 0) json["first_disagreement"] = results.checked.first;
    json["depot"] = depot_json(results.depot);
    json["craters"] = craters_json(results);
    json["view"] = results.view.empty() ? Json() : Json(results.view);
    json["out"] = out;
    return json;
}

std::string default_level() {
    const std::string here = "levels/depot.map";
    std::error_code none;
    return std::filesystem::exists(here, none) ? here : std::string(FIRMA_ROOT) + "/" + here;
}

/// build/demo.svg in the folder of the project, else a file right here.
std::string default_picture() {
    std::error_code none;
    return std::filesystem::exists("levels/depot.map", none) ? "build/demo.svg" : "firma_demo.svg";
}

void make_folder_of(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (!folder.empty() && !is_standard_output(path)) make_folder(folder.string());
}

/// build/demo.svg -> build/demo_view.png
std::string view_path(const std::string& out) {
    const std::filesystem::path path(out);
    return (path.parent_path() / (path.stem().string() + "_view.png")).string();
}

/// Before and after, where the picture itself goes to a file and craters are to be seen.
void draw_craters(const World& before, const std::string& out, Results& results) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(out, none)) return;
    const std::optional<draw::Camera> camera =
        results.depot ? depot_camera() : find_camera(before, results.craters.after, draw::Camera());
    if (!camera) return;
    results.view = view_path(out);
    AtomicFile file(results.view);
    file.write(
        png_bytes(side_by_side(draw::draw_view(before, *camera), draw::draw_view(results.craters.after, *camera))));
    file.commit();
}

int run_casts(const DemoArguments& given) {
    DemoArguments arguments = given;
    if (arguments.out.empty()) arguments.out = default_picture();
    const std::size_t count = arguments.casts.empty() ? 100000 : count_option("--casts", arguments.casts, 1, 10000000);
    const std::uint64_t seed =
        arguments.seed.empty() ? 1 : count_option("--seed", arguments.seed, 0, ~std::uint64_t(0));
    const std::size_t craters =
        arguments.craters.empty() ? 200 : count_option("--craters", arguments.craters, 0, 100000);
    refuse_json_beside(arguments.json, arguments.out);
    refuse_overwriting(arguments.out, arguments.level.path);
    const LoadedLevel loaded = load_level(arguments.level);
    make_folder_of(arguments.out);
    AtomicFile out(arguments.out);

    const std::vector<Query> queries = make_demo_casts(loaded.world, count, seed);
    Results results;
    fire(loaded.world, queries, results);
    results.checked = check_sample(loaded.world, queries);
    const World held = with_usual_anchors(anchored(loaded, {}));
    if (craters > 0) results.depot = shoot_depot(held);
    results.craters = fire_demo_craters(held, results.depot ? results.depot->after : held, queries, craters, seed);
    const World& after = results.craters.after;
    if (results.craters.done > 0) results.checked_after = check_sample(after, queries);
    out.write(draw(after, queries, short_name(arguments.level.path)).svg);
    out.commit();
    draw_craters(loaded.world, arguments.out, results);
    if (arguments.json) {
        print(json_text(json_of(loaded, results, arguments.out)));
    } else if (may_print_beside(arguments.out)) {
        print(text_for_people(loaded, results, arguments.out));
    }
    return results.disagreements() > 0 || results.craters.leaks() ? 1 : 0;
}

int run(const DemoArguments& given) {
    DemoArguments arguments = given;
    if (arguments.level.path.empty()) arguments.level.path = default_level();
    if (!arguments.wants_casts())
        return run_fight({arguments.level, arguments.frames, arguments.seconds, arguments.seed, arguments.json});
    for (const auto& [option, value] :
         {std::pair("--frames", &arguments.frames), std::pair("--seconds", &arguments.seconds)})
        if (!value->empty())
            throw Failure(option, "is of the fire fight; --casts, --craters and -o ask for casts and craters instead");
    return run_casts(arguments);
}

}  // namespace

Verb add_demo(CLI::App& app) {
    Command command(app, "demo",
                    "A fire fight in our level, judged frame by frame; or casts and craters; a table, pictures");
    const auto arguments = std::make_shared<DemoArguments>();
    add_level_arguments(command, arguments->level, false);
    add_rooms_option(command, arguments->level);
    add_matter_option(command, arguments->level);
    add_out_option(command, arguments->out,
                   "casts and craters: SVG to write (default: see below); its folder is made when missing", false);
    command.add_option("--casts", arguments->casts, "N", "casts, 1 .. 10000000 (default 100000)");
    command.add_option("--craters", arguments->craters, "N", "craters, 0 .. 100000 (default 200)");
    command.add_option("--frames", arguments->frames, "FOLDER", "film strips of the fire fight; made when missing");
    command.add_option("--seconds", arguments->seconds, "T", "of the fire fight, 0.1 .. 600 (default 20)");
    command.add_option("--seed", arguments->seed, "S", "of the random numbers, 0 .. 2^64 - 1 (default 1)");
    add_json_flag(command, arguments->json);
    command.set_footer(kDemoFooter);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli

// SPDX-License-Identifier: MIT
// Reads all queries, casts them in chunks on all cores, writes rows in order.
#include "cli/verbs.h"
#include "firma/queries.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/atomic_file.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "cli/read_queries.h"
#include "cli/write_hits.h"
#include "firma/level.h"

namespace firma::cli {

namespace {

struct CastArguments {
    LevelArguments level;
    std::string queries, out, contact_offset, threads, meets;
    bool two_sided = false;
    bool json = false;
};

constexpr std::size_t kChunk = 1024;  // casts in a row before the pipeline hands them on

constexpr const char* kCastFooter =
    R"(Queries: csv with a header; the columns px,py,pz (start of the centre, metres), dx,dy,dz (path, metres) and
radius (metres, 0 or more; 0 is a particle): all of them, no others, in any order. Decimal numbers. An empty
line, a missing or additional field, NaN, infinity, a hexadecimal number or a negative radius is an error that
names file and line. Lines count from 1, the header included. `-` reads standard input.

Hits: one row a query, in the order of the queries, the same bytes for any number of threads. Columns:
  query          row of the queries, from 0
  status         miss, hit, or touching (starts in touch or overlap and gets nearer); a miss leaves the rest empty
  fraction       of the path at first contact, 0 .. 1
  safe_fraction  how far to go so that the contact_offset is kept, 0 .. fraction
  cx,cy,cz       centre at `fraction`, metres
  px,py,pz       contact point on the face, metres
  nx,ny,nz       unit contact normal, from the contact point toward the centre
  fnx,fny,fnz    unit normal of the face
  face           index of the face in the level's file, from 0, dropped ones counted; see below
  feature        face, edge or vertex of it
  room           of the contact, from 0
Numbers have 17 significant digits. The file appears whole or not at all; `-` writes standard output.

`face` by format: of glTF the triangle, by node, primitive and triangle. Of a level of brushes (.map, .bsp without
--surfaces) the side of the brush, counted through all brushes as they were read, without sides that were left out;
the convex pieces of curved patches count on from there, with --rooms auto behind six sides for each portal added. Of a
.firma as of the level that it was made of; where a cut made the face, the triangle of the cutter.

--meets takes one or more of these words, with commas between them (walk,shots); met are the faces that stop any of it:
  walk    bodies that walk: stopped by walls, glass, clip brushes
  shots   stopped by walls, glass, shot clips
  sight   stopped by walls, but no glass
  liquid  stopped by the surface of water, slime, lava, and by no wall
All solid is a wall, what is painted with the sky too. Faces of formats that know no contents (.obj, the --surfaces of
a .bsp, glTF without masks) stop everything. For instance, what stops players; they pass through the water's surface:
  firma cast levels/depot.map --queries q.csv --meets walk -o hits.csv

--json: level, queries, hit, touching, miss, threads, read_seconds, build_seconds, queries_seconds,
cast_seconds, out.
)";

struct CastTally {
    std::size_t hit = 0, touching = 0, miss = 0;
    void add(const CastTally& other) {
        hit += other.hit;
        touching += other.touching;
        miss += other.miss;
    }
};

/// A chunk on its way through the pipeline.
struct Rows {
    std::string text;
    std::size_t count = 0;
    CastTally tally;
};

Rows cast_chunk(const World& world, const std::vector<Query>& queries, std::size_t first, std::size_t last,
                const CastOptions& options, const std::string& place) {
    Rows rows;
    rows.count = last - first;
    rows.text.reserve(rows.count * 340);
    for (std::size_t k = first; k < last; ++k) {
        const Hit hit = cast(world, queries[k].sphere, queries[k].path, options);
        if (hit.status == Status::kInvalid)  // the reader has refused all of these already, so this is belt and braces
            throw Failure(fmt::format("{}:{}", place, k + 2), "a number is too large to be computed with");
        rows.tally.hit += hit.status == Status::kHit;
        rows.tally.touching += hit.status == Status::kInitialOverlap;
        rows.tally.miss += hit.status == Status::kMiss;
        append_hit(rows.text, k, world, hit);
    }
    return rows;
}

/// Casting runs in parallel, cutting up and writing in order.
CastTally cast_all_rows(const World& world, const std::vector<Query>& queries, const CastOptions& options, int threads,
                        const std::string& place, AtomicFile& out) {
    Progress progress("casting", queries.size());
    CastTally tally;
    std::size_t begun = 0;
    const auto next_chunk = [&](tbb::flow_control& flow) -> std::size_t {
        const std::size_t first = begun;
        if (first >= queries.size()) flow.stop();
        begun = std::min(first + kChunk, queries.size());
        return first;
    };
    const auto do_chunk = [&](std::size_t first) {
        return std::make_shared<Rows>(
            cast_chunk(world, queries, first, std::min(first + kChunk, queries.size()), options, place));
    };
    const auto put_chunk = [&](const std::shared_ptr<Rows>& rows) {
        out.write(rows->text);
        tally.add(rows->tally);
        progress.add(rows->count);
    };
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_pipeline(
            std::size_t(threads) * 4,
            tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, next_chunk) &
                tbb::make_filter<std::size_t, std::shared_ptr<Rows>>(tbb::filter_mode::parallel, do_chunk) &
                tbb::make_filter<std::shared_ptr<Rows>, void>(tbb::filter_mode::serial_in_order, put_chunk));
    });
    return tally;
}

/// "walk,liquid" -> the bits of firma/level.h
std::uint32_t mask_option(const std::string& text) {
    constexpr std::pair<std::string_view, std::uint32_t> kWords[] = {
        {"walk", kStopsWalk}, {"shots", kStopsShots}, {"sight", kStopsSight}, {"liquid", kStopsLiquid}};
    std::uint32_t mask = 0;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view word = std::string_view(text).substr(begin, end - begin);
        const auto known = std::find_if(std::begin(kWords), std::end(kWords),
                                        [&](const auto& candidate) { return candidate.first == word; });
        if (known == std::end(kWords))
            throw Failure("--meets", fmt::format("'{}' is none of walk, shots, sight, liquid", word));
        mask |= known->second;
        begin = end + 1;
    }
    return mask;
}

struct Times {
    double queries = 0, casting = 0;
};

Json json_of(const CastArguments& arguments, const LoadedLevel& loaded, const CastTally& tally, int threads,
             const Times& times) {
    Json json;
    json["level"] = arguments.level.path;
    json["queries"] = tally.hit + tally.touching + tally.miss;
    json["hit"] = tally.hit;
    json["touching"] = tally.touching;
    json["miss"] = tally.miss;
    json["threads"] = threads;
    json["read_seconds"] = loaded.read_seconds;
    json["build_seconds"] = loaded.build_seconds;
    json["queries_seconds"] = times.queries;
    json["cast_seconds"] = times.casting;
    json["out"] = arguments.out;
    return json;
}

int run(const CastArguments& arguments) {
    CastOptions options;
    if (arguments.two_sided) options.sides = Sides::kBoth;
    if (!arguments.meets.empty()) options.mask = mask_option(arguments.meets);
    if (!arguments.contact_offset.empty())
        options.contact_offset = number_option("--skin", arguments.contact_offset, 0, INFINITY);
    const int threads = arguments.threads.empty() ? tbb::this_task_arena::max_concurrency()
                                                  : int(count_option("--threads", arguments.threads, 1, 256));
    refuse_json_beside(arguments.json, arguments.out);
    refuse_overwriting(arguments.out, arguments.level.path);
    refuse_overwriting(arguments.out, arguments.queries);
    const LoadedLevel loaded = load_level(arguments.level);
    Times times;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Query> queries = read_queries(arguments.queries);
    times.queries = seconds_since(start);

    AtomicFile out(arguments.out);
    const auto ready = std::chrono::steady_clock::now();
    out.write(kHitsHeader);
    const CastTally tally = cast_all_rows(loaded.world, queries, options, threads, arguments.queries, out);
    out.commit();
    times.casting = seconds_since(ready);

    if (arguments.json) {
        print(json_text(json_of(arguments, loaded, tally, threads, times)));
    } else if (may_print_beside(arguments.out)) {
        print(fmt::format("{}: {} casts in {}: {} hit, {} initial overlap, {} miss\n", arguments.out,
                          grouped(queries.size()), seconds_text(times.casting), grouped(tally.hit),
                          grouped(tally.touching), grouped(tally.miss)));
    }
    return 0;
}

}  // namespace

Verb add_cast(CLI::App& app) {
    Command command(app, "cast", "Casts spheres and particles from a csv file through a level");
    const auto arguments = std::make_shared<CastArguments>();
    add_level_arguments(command, arguments->level);
    add_rooms_option(command, arguments->level);
    command.add_option("--queries", arguments->queries, "FILE", "csv of casts, see below", true);
    add_out_option(command, arguments->out, "csv of hits to write, see below", true);
    command.add_flag("--two-sided", arguments->two_sided, "meet both sides of every face, not only the front");
    command.add_option("--meets", arguments->meets, "WORDS",
                       "meet only faces that stop this: walk, shots, sight, liquid, see below (default: all faces)");
    command.add_option("--skin", arguments->contact_offset, "M",
                       "distance that safe_fraction keeps, metres, 0 or more (default 0.001)");
    command.add_option("--threads", arguments->threads, "N", "1 .. 256 (default: one a core)");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kCastFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli

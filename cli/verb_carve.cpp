// SPDX-License-Identifier: MIT
// Fires blasts one after the other, keeps account of each, writes the world after the last.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/anchor_options.h"
#include "cli/atomic_file.h"
#include "cli/edit_log_file.h"
#include "cli/failure.h"
#include "cli/fire_blast.h"
#include "cli/glb_parts.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/merge_option.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "cli/read_blasts.h"
#include "cli/write_glb.h"
#include "cli/write_level.h"
#include "firma/chunk.h"
#include "world/world_data.h"

namespace firma::cli {

namespace {

struct CarveArguments : LevelOutput {
    LevelArguments level;
    AnchorArguments anchors;
    std::string blasts, report, log, material, slices, merge_share, min_volume, density, chunk_report;
    bool chunks = false, json = false;
};

constexpr const char* kReportHeader =
    "blast,status,ms,faces_gone,faces_new,retries,volume,hash,castable_only,portals,rooms,chunks,chunk_volume,"
    "open_trimmed,open_removed,panes,clips,reason\n";
constexpr const char* kChunkHeader = "blast,chunk,volume,mass,x,y,z,ixx,iyy,izz,ixy,ixz,iyz\n";

constexpr const char* kCarveFooter =
    R"(Blasts: csv with a header; the columns x,y,z (place, metres), radius (metres), shape and seed: all of them, in any
order, and if you like fx,fy,fz, where the shot came from (metres): what a crater opens between rooms becomes air of the
room that this lies in. Shapes, of mean radius 1 before `radius` scales them:
  rocky  a rough ball of 180 triangles       spiky  a ball of 180 triangles with 32 spikes
  drill  a pointed rod of 64 triangles       wedge  a blade of 8 triangles
  box    a cube of 12 triangles, 2 a side
The seed (0 .. 2^64 - 1) makes the shape and its random turn. An empty line, a missing or additional field, NaN,
infinity, an unknown shape or a malformed seed is an error that names file and line; nothing is written then.
Lines count from 1, the header included. `-` reads standard input.

The report: one row a blast, in their order:
  blast       row of the blasts, from 0
  status      done; nothing (the cutter met only air, only touched the solid, or met only faces that stay: see
              castable_only);
              refused (see stderr; the world stays as it was)
  ms          wall time of that edit alone with everything in it, milliseconds; not of making the cutter's shape
              from its seed, nor of the hash or of output
  faces_gone  faces that casts met before and no more
  faces_new   faces that casts meet from now on
  retries     0: no cutter is moved, also where it touches
  volume      taken from the solid, cubic metres, 17 significant digits
  hash        of the whole world after that blast: 16 hexadecimal digits, the same on every machine
  castable_only
              faces that reach into the cutter and were left as they are: liquids, and what may not be carved
  portals     that the blast made: holes between rooms
  rooms       that it made: pockets in rock
  chunks      pieces that came loose with it and left the level; 0 without --chunks
  chunk_volume
              of these, cubic metres, 17 significant digits; `volume` is what the cutter took, without them
  open_trimmed
              faces that bound no closed solid (patches, sheets, glass, clips) of which the blast took a part
  open_removed
              those that it took whole, panes of glass among them
  panes       panes that went whole, each with all its faces
  clips       of those two columns: faces that stop walkers alone, or shots alone
  reason      why it was refused; empty otherwise. Commas are semicolons
A number that makes no crater (a radius of 0 or less, a place outside the world) is refused. Neither
refusals nor blasts that came to nothing change the exit code.

--chunks looks for loose pieces after each blast: what the blast cuts off and nothing holds leaves the level. Held is rock
around rooms; what hangs free in LEVEL as it is read, and its parts, unless --no-hanging; faces of the materials that
--anchors names; of a level of brushes what reaches into a brush of firma_anchor; and what hangs on any of these. A
.firma file keeps what was said for it, unless these options say it anew; made with --chunks it has the brushes' volumes.
Pieces smaller than --min-volume leave as well, but are only counted (crumbs). Give --chunks to all runs over a level or
to none: a piece left hanging is not looked for later. --chunk-report writes a row a chunk: blast (its row, from 0), chunk
(of that blast, from 0), volume (cubic metres), mass (kilograms, by matter or --density), x,y,z (its centre of mass,
metres, where it was), ixx,iyy,izz,ixy,ixz,iyz (the tensor of inertia about that, kg m2, 17 significant digits).

--merge-share X makes two rooms one once the open portals that blasts made between them are together larger than X times
the walls of the one that has less of them; never where a closed portal lies between them. The higher id then leads to the
other room. A .firma file keeps the share, and one that it has goes on to count unless it is given anew.

The level written goes by the ending of AFTER. A .firma file holds all of it, its exact solid, tree and counters
too: blasts go on from it as if there had been no file between. A .glb is binary glTF 2.0, for viewers and engines: the
faces that casts meet as triangles with normals, rounded to 32-bit floats (exact within 64 m of the origin, at most
1/4096 m off at the rim), under a material each of the level's; faces that cuts made have one of their own, with (cut)
behind its name. In glTF y points up: the node turns the axis of the level that does so there, z or what --up says; the
positions stay the level's. An .obj, or a name without an ending, gets the faces that casts meet, convex polygons of
exactly the corners they have (decimals, multiples of 1/262144 m), with their materials; of brushes, and of a .firma with
several rooms, those that bound the solid, which are closed: glass, clips, liquids and patches come with --castable.
Other endings are refused. Only closed solids are carved; a .bsp with --surfaces seldom has any. An .obj read again, its
vertices are snapped to 1/4096 m; where that makes faces touch or cross, what they bound is closed no longer to Firma and
is not carved. All files appear whole or not at all; `-` writes standard output, an .obj. When blasts leave no face at
all, stderr says so: AFTER.obj then holds
none, and `firma check` does not take it ("no face"); AFTER.glb is an empty scene. Should cuts contradict each other,
which would be a fault of Firma, the blast is refused and AFTER.repro-N.obj (N: the blast) holds the faces and the
cutter.

--log writes what was done, for others to do the same to the same level: `firma log replay` gives the world that AFTER
holds, to the bit. Each blast is quantised before it is fired, its place to 1/4096 m and its radius to 1/4096, and is
given a number, from which the ids of its faces follow: so the hashes differ from those of a run without --log. A
checkpoint, the world's hash, stands after every 100 blasts and at the end. With --chunks it says so of every blast: then
replay needs the same --anchors and --no-hanging; the brushes of firma_anchor it takes from LEVEL. It needs the same
--merge-share, too.

--json: level, blasts, done, nothing, nothing_castable_only (of these: met only faces that stay), refused,
faces_before, faces_after, castable_only (of all faces), median_ms, p99_ms, longest_ms, longest_slice_ms, retries,
volume, chunks, chunk_volume, chunk_mass, crumbs, crumb_volume, anchors {materials, sources, edits, hanging, volumes} (how
many of each hold; all six null without --chunks), merge_share (0: rooms stay apart), hash, read_seconds, build_seconds, out, report, chunk_report, log.

For instance, a crater and a drill hole in our level:
  printf 'x,y,z,radius,shape,seed\n35,29,0.2,1.6,rocky,1\n30,25,0,0.5,drill,2\n' > blasts.csv
  firma carve levels/first.obj --blasts blasts.csv -o after.obj --report report.csv
)";

/// What is told about all blasts together.
struct Tally {
    std::size_t done = 0, nothing = 0, refused = 0;
    std::size_t nothing_castable_only = 0, faces_met = 0;  ///< of `nothing`: met only faces that stay
    std::size_t open_trimmed = 0, open_removed = 0, panes = 0;
    std::size_t faces_before = 0, faces_after = 0;
    std::vector<double> seconds;  ///< of the edits that carved something
    double longest_slice = 0, longest = 0;
    std::uint64_t retries = 0;
    double volume = 0;
    std::size_t chunks = 0, crumbs = 0;
    double chunk_volume = 0, chunk_mass = 0, crumb_volume = 0;
};

const char* status_name(CarveStatus status) {
    switch (status) {
        case CarveStatus::kDone:
            return "done";
        case CarveStatus::kNothing:
            return "nothing";
        case CarveStatus::kRefused:
            return "refused";
    }
    return "";
}

/// Faces that blasts pass by.
std::size_t castable_only(const World& world) {
    return world.data().castable.count;
}

std::string hash_text(const World& world) {
    return fmt::format("{:016x}", hash_world(world));
}

void write_row(AtomicFile& report, std::size_t blast, const Fired& fired, const World& world) {
    const CarveReport& did = fired.result.report;
    const bool done = fired.result.done();
    std::string row =
        fmt::format("{},{},{:.4f},{},{},{},", blast, status_name(fired.result.status), 1e3 * fired.seconds,
                    done ? did.faces_removed : 0, done ? did.faces_added : 0, did.retries);
    append_17(row, done ? did.volume : 0);
    std::string reason = fired.result.status == CarveStatus::kRefused ? fired.result.error.text() : "";
    std::replace(reason.begin(), reason.end(), ',', ';');
    row += fmt::format(",{},{},{},{},{},", hash_text(world), did.faces_castable_only, done ? did.portals : 0,
                       done ? did.rooms : 0, done ? did.chunks : 0);
    append_17(row, done ? did.chunk_volume : 0);
    row += fmt::format(",{},{},{},{}", did.open_trimmed, did.open_removed, did.panes, did.clips);
    report.write(row + "," + reason + "\n");
}

void write_chunks(AtomicFile& report, std::size_t blast, const std::vector<Chunk>& chunks) {
    for (std::size_t k = 0; k < chunks.size(); ++k) {
        const MassProperties& mass = chunks[k].mass;
        const Vec3 centre = chunks[k].origin + mass.centre;
        std::string row = fmt::format("{},{}", blast, k);
        for (const double value :
             {mass.volume, mass.mass, centre.x, centre.y, centre.z, mass.inertia[0].x, mass.inertia[1].y,
              mass.inertia[2].z, mass.inertia[0].y, mass.inertia[0].z, mass.inertia[1].z}) {
            row += ",";
            append_17(row, value);
        }
        report.write(row + "\n");
    }
}

/// after.obj -> after.repro-7.obj
std::string reproduction_path(const std::string& out, std::size_t blast) {
    const std::filesystem::path path(out);
    return (path.parent_path() / fmt::format("{}.repro-{}.obj", path.stem().string(), blast)).string();
}

/// Writes what it takes to see a contradiction again. @return where, for people
std::string keep_reproduction(const std::string& out, std::size_t blast, const std::string& text) {
    if (is_standard_output(out)) return "with -o FILE what it takes to see this again would be kept";
    const std::string path = reproduction_path(out, blast);
    AtomicFile file(path);
    file.write(text);
    file.commit();
    return "to see this again: " + path;
}

void tell_refusal(const CarveArguments& arguments, std::size_t blast, const CarveResult& result) {
    std::string text =
        fmt::format("firma: {}:{}: blast {} refused: {}", arguments.blasts, blast + 2, blast, result.error.text());
    if (!result.reproduction.empty()) text += "; " + keep_reproduction(arguments.out, blast, result.reproduction);
    std::fputs((text + "\n").c_str(), stderr);
}

/// A blast as it is, or as the next command of a log: quantised, and with a number of its own.
Fired fire(World& world, const Blast& blast, FireOptions options, EditLog* log) {
    if (!log) return fire_blast(world, blast, options);
    options.carve.from = blast.from;
    const EditCommand command =
        crater_command(log->next_number(), {blast.shape, blast.seed}, blast.position, blast.radius, options.carve);
    options.carve = command.options;
    options.carve.edit = command.number;
    Fired fired = fire_cut(world, cutter_of(blast), command.pose, options);
    if (!fired.result.done()) return fired;
    if (const std::optional<Error> error = log->append(command)) throw Failure(*error);
    if (log->commands().size() % kCheckpointEvery == 0) log->add_checkpoint(world);
    return fired;
}

/// What is written on the way; null: not asked for.
struct Reports {
    AtomicFile* blasts = nullptr;
    AtomicFile* chunks = nullptr;
};

Tally fire_all(World& world, const std::vector<Blast>& blasts, const FireOptions& options,
               const CarveArguments& arguments, const Reports& reports, EditLog* log) {
    Progress progress("carving", blasts.size());
    Tally tally;
    tally.faces_before = world.face_count();
    if (reports.blasts) reports.blasts->write(kReportHeader);
    if (reports.chunks) reports.chunks->write(kChunkHeader);
    for (std::size_t k = 0; k < blasts.size(); ++k) {
        const Fired fired = fire(world, blasts[k], options, log);
        const CarveResult& result = fired.result;
        tally.done += result.done();
        tally.nothing += result.status == CarveStatus::kNothing;
        if (met_only_castable(result)) {
            ++tally.nothing_castable_only;
            tally.faces_met += result.report.faces_castable_only;
        }
        tally.refused += result.status == CarveStatus::kRefused;
        tally.retries += std::uint64_t(result.report.retries);
        tally.longest_slice = std::max(tally.longest_slice, fired.longest_slice);
        tally.longest = std::max(tally.longest, fired.seconds);
        if (result.done()) {
            tally.seconds.push_back(fired.seconds);
            tally.volume += result.report.volume;
            tally.open_trimmed += result.report.open_trimmed;
            tally.open_removed += result.report.open_removed;
            tally.panes += result.report.panes;
            tally.chunks += result.report.chunks;
            tally.chunk_volume += result.report.chunk_volume;
            for (const Chunk& chunk : result.chunks) tally.chunk_mass += chunk.mass.mass;
            tally.crumbs += result.report.crumbs;
            tally.crumb_volume += result.report.crumb_volume;
        }
        if (reports.blasts) write_row(*reports.blasts, k, fired, world);
        if (reports.chunks) write_chunks(*reports.chunks, k, result.chunks);
        if (result.status == CarveStatus::kRefused) tell_refusal(arguments, k, result);
        progress.add(1);
    }
    tally.faces_after = world.face_count();
    return tally;
}

Json json_of(const CarveArguments& arguments, const LoadedLevel& loaded, Tally& tally, const World& world) {
    Json json;
    json["level"] = arguments.level.path;
    json["blasts"] = tally.done + tally.nothing + tally.refused;
    json["done"] = tally.done;
    json["nothing"] = tally.nothing;
    json["nothing_castable_only"] = tally.nothing_castable_only;
    json["refused"] = tally.refused;
    json["faces_before"] = tally.faces_before;
    json["faces_after"] = tally.faces_after;
    json["castable_only"] = castable_only(world);
    json["median_ms"] = 1e3 * percentile(tally.seconds, 0.5);
    json["p99_ms"] = 1e3 * percentile(tally.seconds, 0.99);
    json["longest_ms"] = 1e3 * tally.longest;
    json["longest_slice_ms"] = 1e3 * tally.longest_slice;
    json["retries"] = tally.retries;
    json["volume"] = tally.volume;
    const auto of_chunks = [&](const auto& value) { return arguments.chunks ? Json(value) : Json(); };
    json["chunks"] = of_chunks(tally.chunks);
    json["chunk_volume"] = of_chunks(tally.chunk_volume);
    json["chunk_mass"] = of_chunks(tally.chunk_mass);
    json["crumbs"] = of_chunks(tally.crumbs);
    json["crumb_volume"] = of_chunks(tally.crumb_volume);
    json["anchors"] = of_chunks(anchors_json(world));
    json["merge_share"] = merge_share_of(world);
    json["hash"] = hash_text(world);
    json["read_seconds"] = loaded.read_seconds;
    json["build_seconds"] = loaded.build_seconds;
    json["out"] = arguments.out;
    json["report"] = arguments.report.empty() ? Json() : Json(arguments.report);
    json["chunk_report"] = arguments.chunk_report.empty() ? Json() : Json(arguments.chunk_report);
    json["log"] = arguments.log.empty() ? Json() : Json(arguments.log);
    return json;
}

std::string text_for_people(const CarveArguments& arguments, const LoadedLevel& loaded, Tally& tally,
                            const World& world) {
    std::string text = fmt::format("{}: {}: {} done, {} nothing, {} refused\n", arguments.out,
                                   counted(tally.done + tally.nothing + tally.refused, "blast"), grouped(tally.done),
                                   grouped(tally.nothing), grouped(tally.refused));
    const auto row = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<12} {}\n", what, value);
    };
    if (tally.nothing_castable_only > 0)
        row("nothing",
            fmt::format("{} met only faces that stay ({}), {} met only air", grouped(tally.nothing_castable_only),
                        grouped(tally.faces_met), grouped(tally.nothing - tally.nothing_castable_only)));
    row("faces", fmt::format("{} before, {} after", grouped(tally.faces_before), grouped(tally.faces_after)));
    if (const std::size_t faces = castable_only(world); faces > 0)
        row("castable", fmt::format("{} of the faces bound no closed solid{}", grouped(faces),
                                    leaves_out(loaded, arguments) ? ": not written (--castable writes them)" : ""));
    if (tally.open_trimmed + tally.open_removed > 0)
        row("", fmt::format("{} of such trimmed, {} removed, {} among these", grouped(tally.open_trimmed),
                            grouped(tally.open_removed), counted(tally.panes, "pane")));
    row("volume", fmt::format("{:.6g} cubic metres taken", tally.volume));
    if (arguments.chunks)
        row("chunks", fmt::format("{} came loose, {:.6g} cubic metres, {:.6g} kg; {} of {:.3g} cubic metres",
                                  grouped(tally.chunks), tally.chunk_volume, tally.chunk_mass,
                                  counted(tally.crumbs, "crumb"), tally.crumb_volume));
    if (arguments.chunks && !anchors_text(world).empty()) row("anchors", anchors_text(world));
    if (!tally.seconds.empty())
        row("an edit", fmt::format("median {}, 99th percentile {}", seconds_text(percentile(tally.seconds, 0.5)),
                                   seconds_text(percentile(tally.seconds, 0.99))));
    if (!arguments.slices.empty()) row("a slice", "longest " + seconds_text(tally.longest_slice));
    row("hash", hash_text(world));
    if (!arguments.report.empty()) row("report", arguments.report);
    if (!arguments.chunk_report.empty()) row("chunk report", arguments.chunk_report);
    if (!arguments.log.empty()) row("log", arguments.log);
    return text;
}

/// Outputs must differ from each other, and from what is read, and be of a format that is written.
void judge_outputs(const CarveArguments& arguments) {
    for (const std::string& out : {arguments.out, arguments.report, arguments.log, arguments.chunk_report}) {
        refuse_overwriting(out, arguments.level.path);
        refuse_overwriting(out, arguments.blasts);
    }
    judge_level_output(arguments);
    refuse_json_beside(arguments.json, arguments.out);
    refuse_json_beside(arguments.json, arguments.report);
    if (is_standard_output(arguments.out) && is_standard_output(arguments.report))
        throw Failure("--report", "and --out both want standard output; name a file");
    std::error_code none;
    const auto same = [&](const std::string& a, const std::string& b) {
        return !a.empty() && std::filesystem::absolute(a, none).lexically_normal() ==
                                 std::filesystem::absolute(b, none).lexically_normal();
    };
    if (same(arguments.report, arguments.out)) throw Failure("--report", "and --out name one file");
    if (same(arguments.log, arguments.out)) throw Failure("--log", "and --out name one file");
    if (same(arguments.log, arguments.report)) throw Failure("--log", "and --report name one file");
    if (is_standard_output(arguments.log)) throw Failure("--log", "a log is bytes; name a file");
    if (is_standard_output(arguments.chunk_report)) throw Failure("--chunk-report", "goes to a file; name one");
    for (const auto& [name, other] : {std::pair("--out", arguments.out), std::pair("--report", arguments.report),
                                      std::pair("--log", arguments.log)})
        if (same(arguments.chunk_report, other))
            throw Failure("--chunk-report", std::string("and ") + name + " name one file");
    refuse_overwriting(arguments.report, arguments.out);
    refuse_overwriting(arguments.log, arguments.out);
    refuse_other_endings(arguments.out);
    refuse_overwriting(arguments.chunk_report, arguments.out);
}

/// Of options that say nothing without it.
void judge_chunk_arguments(const CarveArguments& arguments) {
    if (arguments.chunks) return;
    const std::pair<const char*, bool> given[] = {{"--min-volume", !arguments.min_volume.empty()},
                                                  {"--density", !arguments.density.empty()},
                                                  {"--anchors", !arguments.anchors.materials.empty()},
                                                  {"--no-hanging", arguments.anchors.no_hanging},
                                                  {"--chunk-report", !arguments.chunk_report.empty()}};
    for (const auto& [name, is_given] : given)
        if (is_given) throw Failure(name, "is for --chunks");
}

std::optional<ChunkOptions> chunk_options(const CarveArguments& arguments) {
    judge_chunk_arguments(arguments);
    if (!arguments.chunks) return {};
    ChunkOptions options;
    if (!arguments.min_volume.empty())
        options.min_volume = number_option("--min-volume", arguments.min_volume, 0, 1e12);
    if (!arguments.density.empty()) options.density = number_option("--density", arguments.density, 1e-9, 1e12);
    return options;
}

int run(const CarveArguments& arguments) {
    FireOptions options;
    options.carve.material = arguments.material;
    options.carve.chunks = chunk_options(arguments);
    if (!arguments.slices.empty()) options.slice = number_option("--slices", arguments.slices, 0, 1e12);
    judge_outputs(arguments);
    LoadedLevel loaded = load_level(arguments.level);
    loaded.world = with_merge_share(loaded.world, arguments.merge_share);
    if (arguments.chunks) loaded.world = anchored(loaded, arguments.anchors);
    const std::vector<Blast> blasts = read_blasts(arguments.blasts);
    // Blasts mostly add faces: what is too large already should not take hours to be so.
    if (names_glb(arguments.out)) judge_glb_size(GlbParts(loaded.world).file_bytes(), arguments.out);

    AtomicFile out(arguments.out);
    std::optional<AtomicFile> report;
    if (!arguments.report.empty()) report.emplace(arguments.report);
    std::optional<AtomicFile> chunk_report;
    if (!arguments.chunk_report.empty()) chunk_report.emplace(arguments.chunk_report);
    std::optional<AtomicFile> log_file;
    std::optional<EditLog> log;
    if (!arguments.log.empty()) {
        log_file.emplace(arguments.log);
        log.emplace(loaded.world);
    }
    // Once for all blasts, so that it is not within the time of the first.
    World world = arguments.chunks ? with_usual_anchors(loaded.world) : loaded.world;
    const Reports reports{report ? &*report : nullptr, chunk_report ? &*chunk_report : nullptr};
    Tally tally = fire_all(world, blasts, options, arguments, reports, log ? &*log : nullptr);
    if (tally.done == 0) world = loaded.world;  // as a replay of no command gives it
    write_level(world, loaded, arguments, out);
    out.finish();
    if (log) {
        log->add_checkpoint(world);
        write_edit_log(*log, *log_file);
        log_file->finish();
    }
    if (report) report->commit();
    if (chunk_report) chunk_report->commit();
    if (log_file) log_file->commit();
    out.commit();
    tell_if_empty(arguments, world);
    if (arguments.json) {
        print(json_text(json_of(arguments, loaded, tally, world)));
    } else if (may_print_beside(arguments.out) && may_print_beside(arguments.report)) {
        print(text_for_people(arguments, loaded, tally, world));
    }
    return 0;
}

}  // namespace

Verb add_carve(CLI::App& app) {
    Command command(app, "carve", "Carves craters from a csv file out of a level and writes what is left");
    const auto arguments = std::make_shared<CarveArguments>();
    add_level_arguments(command, arguments->level);
    add_rooms_option(command, arguments->level);
    add_matter_option(command, arguments->level);
    command.add_option("--blasts", arguments->blasts, "FILE", "csv of blasts, see below", true);
    add_level_output(command, *arguments, ".obj, .firma or .glb to write: the level after all blasts", true);
    command.add_option("--report", arguments->report, "FILE", "csv to write: a row a blast, see below");
    command.add_option("--log", arguments->log, "FILE",
                       "edit log to write: the blasts that were done, for `firma log`; see below");
    command.add_option("--material", arguments->material, "NAME", "material of the faces that blasts leave");
    command.add_option(
        "--slices", arguments->slices, "US",
        "run each edit in slices of so many microseconds, 0: as short as they can be; the result is the same");
    add_merge_option(command, arguments->merge_share);
    command.add_flag("--chunks", arguments->chunks, "pieces that blasts leave loose leave the level; see below");
    command.add_option("--min-volume", arguments->min_volume, "V",
                       "smaller pieces are crumbs, cubic metres (default 0.001)");
    command.add_option("--density", arguments->density, "D",
                       "of chunks, kilograms a cubic metre (default: of each matter its own)");
    add_anchor_options(command, arguments->anchors);
    command.add_option("--chunk-report", arguments->chunk_report, "FILE", "csv to write: a row a chunk, see below");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kCarveFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli

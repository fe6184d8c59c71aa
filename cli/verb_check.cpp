// SPDX-License-Identifier: MIT
// Judges the file by its own numbers, then the world that is made of it.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/atomic_file.h"
#include "cli/brush_level.h"
#include "cli/edit_log_file.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/saved_world.h"
#include "firma/mesh.h"
#include "firma/rooms.h"
#include "firma/solid.h"

namespace firma::cli {

namespace {

struct CheckArguments {
    LevelArguments level;
    bool all = false;
    bool json = false;
    std::string pts;
};

constexpr std::size_t kShownFaults = 20;

constexpr const char* kCheckFooter =
    R"(The file is judged exactly, by its own numbers, before they are snapped to the grid of 1/4096 m; then the world
is made and its invariants are checked. Coordinates are metres, as the file has them; faces count from 0, lines
from 1.

Faults: open_edge (an edge that fewer faces use one way than the other), reversed_face (wound against its
neighbours), a broken world. Notes: no_area, dropped (by the snap), bent, turned (by the snap), divided.

Then it says which faces bound solids, which can be carved. A piece of the surface, joined by edges, that cannot be
is castable only, which is no fault: open_edge, folded_edge (faces around it lie on each other), two_sided, off_grid,
crossing (it crosses or touches itself or another piece), wrong_way (a solid in a solid, a hollow in the air),
too_complex (too much lies too close around it to be tested).

--json: level, sound, faces, vertices, fault_count, faults [{what, face, line, from, to, t_joint}], note_count,
notes [{what, face, line, at}], world_fault or null, solid_faces, rock_outside, castable_only_count, castable_only
[{what, faces, face, other (crossing: the face it meets, else null), at, to}]; lists hold the first 20 unless --all
is given; left_out [{what, count, first}], as of info. `faces` of a piece, and solid_faces, count faces as divided.

glTF is judged as it was snapped to the grid, since nodes place its vertices by rounded products; a face is a triangle,
numbered by node, primitive and triangle, without a line. Notes in addition: idle_portal (one room on both sides of the
whole or a part of it), portals that divide nothing, and what the reader says. --json: in addition rooms, portals,
idle_portals [names], undivided or null (why there is one room though the file has portals), reader_notes [texts].

Of a level of brushes (.map, .bsp without --surfaces) the world is judged, its solid, and what became of the brushes.
Faults: a broken world or solid; a leak, that is a way to the void from an info_player... entity, or in a level that has
none, from any entity with an origin. Notes: not_joined (a brush that is castable only), no_volume, idle_portal (a
portal with one room on both sides), a firma_room that names no room, a firma_anchor that has no brush, or one that no
solid reaches into, and what the reader says. --json: level, sound, brushes (of the file), faces, rooms, portals,
anchor_volumes (of firma_anchor: what they hold, no cut leaves loose), world_fault or null, solid_fault or null, leak
{entity, points [metres]} or null, left_out, note_count, notes [{what, brush, line, reason}], entity_notes [{entity, line,
reason}], reader_notes [texts].

--pts writes the way of the leak, for an editor to show. Where nothing leaks, or the way is too narrow to be shown, the
file is empty; one that was there before is replaced. Bad input leaves it as it was.

A .firma file is judged whole when it is read: damage, or a world or solid that is not sound, is bad input. What is
read is checked once more. --json: level, sound, faces, rooms, portals, world_fault or null, solid_fault or null,
solid_faces, exact_faces, rock_outside, version, edits, anchors (what holds loose pieces: {materials, sources, edits,
hanging, volumes}, how many of each; null where nothing was said).

An edit log, .firmalog, is read: damage is bad input. Whether its checkpoints hold needs its level: firma log verify.
--json: as of firma log show, without commands and checkpoints; sound.

Exit codes: 0 sound, notes or not; 1 faults were found; 2 a bad call or bad input, with `firma: place: reason` on
stderr.
)";

struct Findings {
    MeshCheck mesh;
    std::optional<WorldFault> world_fault;
    LevelSolidity solidity;
    std::size_t level_faces = 0;  ///< as divided
    std::size_t rooms = 1, portals = 0;
    std::vector<std::string> idle;  ///< of glTF: names of portals, in whole or part, with one room on both sides
    std::string undivided;          ///< of glTF: why its portals divide nothing; or empty
    std::vector<std::string> reader_notes;  ///< of glTF
    std::vector<Omission> left_out;
    bool is_gltf = false;
    bool sound() const { return mesh.closed() && !world_fault; }
    std::size_t notes() const { return mesh.notes.size() + idle.size() + !undivided.empty() + reader_notes.size(); }
};

const char* fault_name(MeshFault what) {
    return what == MeshFault::kOpenEdge ? "open_edge" : "reversed_face";
}

const char* note_name(MeshNote what) {
    switch (what) {
        case MeshNote::kNoArea:
            return "no_area";
        case MeshNote::kDropped:
            return "dropped";
        case MeshNote::kBent:
            return "bent";
        case MeshNote::kTurned:
            return "turned";
        case MeshNote::kDivided:
            return "divided";
    }
    return "";
}

const char* note_sentence(MeshNote what) {
    switch (what) {
        case MeshNote::kNoArea:
            return "has no area; dropped";
        case MeshNote::kDropped:
            return "loses its area by the snap; dropped";
        case MeshNote::kBent:
            return "is flat in the file but not on the grid; divided";
        case MeshNote::kTurned:
            return "is turned over by the snap";
        case MeshNote::kDivided:
            return "is not flat or not convex; divided";
    }
    return "";
}

const char* solid_note_name(SolidNoteKind what) {
    switch (what) {
        case SolidNoteKind::kOpenEdge:
            return "open_edge";
        case SolidNoteKind::kFoldedEdge:
            return "folded_edge";
        case SolidNoteKind::kTwoSided:
            return "two_sided";
        case SolidNoteKind::kOffGrid:
            return "off_grid";
        case SolidNoteKind::kCrossing:
            return "crossing";
        case SolidNoteKind::kWrongWay:
            return "wrong_way";
        case SolidNoteKind::kTooComplex:
            return "too_complex";
    }
    return "";
}

std::string place_text(const std::string& path, std::uint32_t line, std::uint32_t face) {
    return line > 0 ? fmt::format("{}:{}: face {}", path, line, face) : fmt::format("{}: face {}", path, face);
}

std::string fault_text(const std::string& path, const MeshFaultPlace& fault) {
    const std::string edge = point_text(fault.from) + " to " + point_text(fault.to);
    const std::string what =
        fault.what == MeshFault::kOpenEdge ? "open edge " + edge : "wound against its neighbours, see the edge " + edge;
    return fmt::format("{}: {}{}\n", place_text(path, fault.line, fault.source), what,
                       fault.t_joint ? "; another vertex lies on it (T-joint)" : "");
}

std::string note_text(const std::string& path, const MeshNotePlace& note) {
    return fmt::format("{}: {}, at {}\n", place_text(path, note.line, note.source), note_sentence(note.what),
                       point_text(note.at));
}

std::string solid_note_sentence(const SolidNote& note) {
    const std::string edge = point_text(note.at) + " to " + point_text(note.to), at = " at " + point_text(note.at);
    switch (note.what) {
        case SolidNoteKind::kOpenEdge:
            return "the edge " + edge + " is open";
        case SolidNoteKind::kFoldedEdge:
            return "faces lie on each other, or do not alternate, around the edge " + edge;
        case SolidNoteKind::kTwoSided:
            return "a two-sided face" + at;
        case SolidNoteKind::kOffGrid:
            return "a vertex off the grid" + at;
        case SolidNoteKind::kCrossing:
            return fmt::format("crosses or touches face {}{}", note.other, at);
        case SolidNoteKind::kWrongWay:
            return "turned the wrong way for where it lies" + at;
        case SolidNoteKind::kTooComplex:
            return "too much lies too close around it to be tested" + at;
    }
    return "";
}

std::size_t shown(std::size_t count, bool all) {
    return all ? count : std::min(count, kShownFaults);
}

std::string solid_note_text(const std::string& path, const SolidNote& note) {
    return fmt::format("{}: piece of {}: {}\n", place_text(path, 0, note.source), counted(note.faces, "face"),
                       solid_note_sentence(note));
}

/// What the last line says of solids.
std::string solid_text(const Findings& found) {
    const std::size_t solid = found.solidity.solid_faces;
    const char* outside = found.solidity.rock_outside ? ", rock outside" : "";
    if (solid == found.level_faces) return fmt::format("solid{}", outside);
    return fmt::format("{} of {} bound solids{}", grouped(solid), counted(found.level_faces, "face"), outside);
}

/// "; 2 rooms, 1 portal"
std::string rooms_clause(const Findings& found) {
    if (!found.is_gltf) return "";
    return fmt::format("; {}, {}", counted(found.rooms, "room"), counted(found.portals, "portal"));
}

std::string idle_text(const std::string& path, const std::string& portal) {
    return fmt::format("{}: portal '{}': one room on both sides of it, or of a part of it\n", path, portal);
}

std::string text_for_people(const std::string& path, const Findings& found, bool all) {
    const auto& [faults, places, faces, vertices] = found.mesh;
    const std::vector<SolidNote>& castable = found.solidity.notes;
    std::string text;
    const auto list = [&](const auto& all_of, auto line_of) {
        for (std::size_t k = 0; k < shown(all_of.size(), all); ++k) text += line_of(path, all_of[k]);
        if (const std::size_t more = all_of.size() - shown(all_of.size(), all); more > 0)
            text += fmt::format("  and {} more (--all shows them)\n", grouped(more));
    };
    if (!faults.empty()) text += counted(faults.size(), "fault") + ":\n";
    list(faults, fault_text);
    if (found.notes() > 0) text += counted(found.notes(), "note") + ":\n";
    list(places, note_text);
    list(found.idle, idle_text);
    if (!found.undivided.empty()) text += fmt::format("{}: its portals divide nothing: {}\n", path, found.undivided);
    list(found.reader_notes,
         [](const std::string& where, const std::string& note) { return where + ": " + note + "\n"; });
    if (found.world_fault)
        text += fmt::format("{}: the world is broken: {} (face id {})\n", path, found.world_fault->what,
                            found.world_fault->face.value);
    if (!castable.empty()) text += counted(castable.size(), "piece") + " castable only:\n";
    list(castable, solid_note_text);
    if (!found.left_out.empty()) text += fmt::format("{}: left out: {}\n", path, left_out_text(found.left_out));
    text += fmt::format("{}: {}; {}, {} different positions{}; {}, {}; {}\n", path, found.sound() ? "sound" : "faulty",
                        counted(faces, "face"), grouped(vertices), rooms_clause(found),
                        counted(faults.size() + (found.world_fault ? 1 : 0), "fault"), counted(found.notes(), "note"),
                        solid_text(found));
    return text;
}

Json texts_json(const std::vector<std::string>& texts, bool all) {
    return std::span(texts).first(shown(texts.size(), all));
}

Json line_json(std::uint32_t line) {
    return line > 0 ? Json(line) : Json();
}

void add_rooms(Json& json, const Findings& found, bool all) {
    if (!found.is_gltf) return;
    json["rooms"] = found.rooms;
    json["portals"] = found.portals;
    json["idle_portals"] = texts_json(found.idle, all);
    json["undivided"] = found.undivided.empty() ? Json() : Json(found.undivided);
    json["reader_notes"] = texts_json(found.reader_notes, all);
}

void add_solidity(Json& json, const LevelSolidity& solidity, bool all) {
    json["solid_faces"] = solidity.solid_faces;
    json["rock_outside"] = solidity.rock_outside;
    json["castable_only_count"] = solidity.notes.size();
    json["castable_only"] = Json::array();
    for (std::size_t k = 0; k < shown(solidity.notes.size(), all); ++k) {
        const SolidNote& note = solidity.notes[k];
        json["castable_only"].push_back({{"what", solid_note_name(note.what)},
                                         {"faces", note.faces},
                                         {"face", note.source},
                                         {"other", note.what == SolidNoteKind::kCrossing ? Json(note.other) : Json()},
                                         {"at", note.at},
                                         {"to", note.to}});
    }
}

Json json_of(const std::string& path, const Findings& found, bool all) {
    Json json;
    json["level"] = path;
    json["sound"] = found.sound();
    json["faces"] = found.mesh.faces;
    json["vertices"] = found.mesh.vertices;
    json["fault_count"] = found.mesh.faults.size() + (found.world_fault ? 1 : 0);
    json["faults"] = Json::array();
    for (std::size_t k = 0; k < shown(found.mesh.faults.size(), all); ++k) {
        const MeshFaultPlace& fault = found.mesh.faults[k];
        json["faults"].push_back({{"what", fault_name(fault.what)},
                                  {"face", fault.source},
                                  {"line", line_json(fault.line)},
                                  {"from", fault.from},
                                  {"to", fault.to},
                                  {"t_joint", fault.t_joint}});
    }
    json["note_count"] = found.notes();
    json["notes"] = Json::array();
    for (std::size_t k = 0; k < shown(found.mesh.notes.size(), all); ++k) {
        const MeshNotePlace& note = found.mesh.notes[k];
        json["notes"].push_back(
            {{"what", note_name(note.what)}, {"face", note.source}, {"line", line_json(note.line)}, {"at", note.at}});
    }
    json["world_fault"] = found.world_fault ? Json(found.world_fault->what) : Json();
    add_solidity(json, found.solidity, all);
    add_left_out(json, found.left_out);
    add_rooms(json, found, all);
    return json;
}

MeshCheck mesh_check(const LevelArguments& level) {
    if (names_gltf(level.path)) return take(check_gltf(take(read_gltf(level.path, gltf_options(level)))));
    return take(check_mesh(level.path, read_options(level)));
}

void add_gltf(const LoadedGltf& gltf, Findings& found) {
    found.is_gltf = true;
    for (const std::uint32_t portal : gltf.rooms.idle) found.idle.push_back(gltf.portals[portal].name);
    found.undivided = gltf.rooms.undivided;
    found.reader_notes = gltf.notes;
}

void judge_pts(const CheckArguments& arguments) {
    if (arguments.pts.empty()) return;
    if (!names_brushes(arguments.level))
        throw Failure("--pts", "only of levels of brushes is it known where they leak");
    if (is_standard_output(arguments.pts)) throw Failure("--pts", "standard output has the findings; name a file");
    refuse_overwriting(arguments.pts, arguments.level.path);
}

int run(CheckArguments& arguments) {
    arguments.level.tells_left_out = true;
    if (names_edit_log(arguments.level.path)) return check_edit_log(arguments.level.path, arguments.json);
    refuse_unknown_ending(arguments.level.path);
    judge_pts(arguments);
    if (names_saved_world(arguments.level.path)) return check_saved_world(load_level(arguments.level), arguments.json);
    if (names_brushes(arguments.level))
        return check_brushes(load_level(arguments.level), {arguments.json, arguments.all, arguments.pts});
    Findings found;
    found.mesh = mesh_check(arguments.level);
    const LoadedLevel loaded = load_level(arguments.level);
    found.world_fault = check_world(loaded.world);
    found.solidity = level_solidity(loaded.level);
    found.level_faces = loaded.level.faces.size();
    found.left_out = left_out(loaded);
    found.rooms = loaded.world.room_count();
    found.portals = portal_count(loaded.world);
    if (loaded.gltf) add_gltf(*loaded.gltf, found);
    const std::string& path = arguments.level.path;
    print(arguments.json ? json_text(json_of(path, found, arguments.all))
                         : text_for_people(path, found, arguments.all));
    return found.sound() ? 0 : 1;
}

}  // namespace

Verb add_check(CLI::App& app) {
    Command command(app, "check", "Tells whether a level is sound: closed, wound one way, well built");
    const auto arguments = std::make_shared<CheckArguments>();
    add_level_arguments(command, arguments->level);
    add_rooms_option(command, arguments->level);
    command.add_flag("--all", arguments->all, "every fault and note, not only the first 20 of each");
    command.add_option("--pts", arguments->pts, "FILE",
                       "of brushes: where the level leaks, a line of points in the file's units; empty if nowhere");
    add_json_flag(command, arguments->json);
    command.set_footer(kCheckFooter);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli

// SPDX-License-Identifier: MIT
// Judges the file by its own numbers, then the world that is made of it.
#include "cli/verb_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "firma/check_mesh.h"

namespace firma::cli {

namespace {

struct CheckArguments {
    LevelArguments level;
    bool all = false;
    bool json = false;
};

constexpr std::size_t kShown = 20;

constexpr const char* kFooter =
    R"(The file is judged exactly, by its own numbers, before they are snapped to the grid of 1/4096 m; then the world
is made and its invariants are checked. Coordinates are metres, as the file has them; faces count from 0, lines
from 1.

Faults: open_edge (an edge that fewer faces use one way than the other), reversed_face (wound against its
neighbours), a broken world. Notes: no_area, dropped (by the snap), bent, turned (by the snap), divided.

--json: level, sound, faces, vertices, fault_count, faults [{what, face, line, from, to, t_joint}], note_count,
notes [{what, face, line, at}], world_fault or null; lists hold the first 20 unless --all is given.

Exit codes: 0 sound, notes or not; 1 faults were found; 2 a bad call or bad input, with `firma: place: reason` on
stderr.
)";

struct Findings {
    MeshCheck mesh;
    std::optional<WorldFault> world_fault;
    bool sound() const { return mesh.closed() && !world_fault; }
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

std::string point_text(const Vec3& p) {
    return fmt::format("({}, {}, {})", p.x, p.y, p.z);
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

std::size_t shown(std::size_t count, bool all) {
    return all ? count : std::min(count, kShown);
}

std::string counted(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", grouped(count), what, count == 1 ? "" : "s");
}

std::string text_for_people(const std::string& path, const Findings& found, bool all) {
    const auto& [faults, notes, faces, vertices] = found.mesh;
    std::string text;
    const auto list = [&](const auto& places, auto line_of) {
        for (std::size_t k = 0; k < shown(places.size(), all); ++k) text += line_of(path, places[k]);
        if (const std::size_t more = places.size() - shown(places.size(), all); more > 0)
            text += fmt::format("  and {} more (--all shows them)\n", grouped(more));
    };
    if (!faults.empty()) text += counted(faults.size(), "fault") + ":\n";
    list(faults, fault_text);
    if (!notes.empty()) text += counted(notes.size(), "note") + ":\n";
    list(notes, note_text);
    if (found.world_fault)
        text += fmt::format("{}: the world is broken: {} (face id {})\n", path, found.world_fault->what,
                            found.world_fault->face.value);
    text += fmt::format("{}: {}; {}, {} different positions; {}, {}\n", path, found.sound() ? "sound" : "faulty",
                        counted(faces, "face"), grouped(vertices),
                        counted(faults.size() + (found.world_fault ? 1 : 0), "fault"), counted(notes.size(), "note"));
    return text;
}

void add_line(JsonWriter& json, std::uint32_t line) {
    if (line > 0) {
        json.add("line", line);
    } else {
        json.add_null("line");
    }
}

std::string json_text(const std::string& path, const Findings& found, bool all) {
    JsonWriter json;
    json.open_object();
    json.add("level", path);
    json.add("sound", found.sound());
    json.add("faces", found.mesh.faces);
    json.add("vertices", found.mesh.vertices);
    json.add("fault_count", found.mesh.faults.size() + (found.world_fault ? 1 : 0));
    json.open_array("faults");
    for (std::size_t k = 0; k < shown(found.mesh.faults.size(), all); ++k) {
        const MeshFaultPlace& fault = found.mesh.faults[k];
        json.open_object();
        json.add("what", fault_name(fault.what));
        json.add("face", fault.source);
        add_line(json, fault.line);
        json.add("from", fault.from);
        json.add("to", fault.to);
        json.add("t_joint", fault.t_joint);
        json.close();
    }
    json.close();
    json.add("note_count", found.mesh.notes.size());
    json.open_array("notes");
    for (std::size_t k = 0; k < shown(found.mesh.notes.size(), all); ++k) {
        const MeshNotePlace& note = found.mesh.notes[k];
        json.open_object();
        json.add("what", note_name(note.what));
        json.add("face", note.source);
        add_line(json, note.line);
        json.add("at", note.at);
        json.close();
    }
    json.close();
    if (found.world_fault) {
        json.add("world_fault", found.world_fault->what);
    } else {
        json.add_null("world_fault");
    }
    json.close();
    return json.text();
}

int run(const CheckArguments& arguments) {
    Findings found;
    found.mesh = take(check_mesh(arguments.level.path, read_options(arguments.level)));
    found.world_fault = check_world(load_level(arguments.level).world);
    const std::string& path = arguments.level.path;
    print(arguments.json ? json_text(path, found, arguments.all) : text_for_people(path, found, arguments.all));
    return found.sound() ? 0 : 1;
}

}  // namespace

Verb add_check(CLI::App& app) {
    Command command(app, "check", "Tells whether a level is sound: closed, wound one way, well built");
    const auto arguments = std::make_shared<CheckArguments>();
    add_level_arguments(command, arguments->level);
    command.add_flag("--all", arguments->all, "every fault and note, not only the first 20 of each");
    add_json_flag(command, arguments->json);
    command.set_footer(kFooter);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli

// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of a level of brushes.
#include "cli/brush_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "cli/atomic_file.h"
#include "cli/describe_world.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/numbers.h"
#include "cli/verb.h"
#include "firma/brush_level.h"
#include "firma/brush_world.h"
#include "firma/rooms.h"
#include "firma/solid.h"

namespace firma::cli {

namespace {

constexpr std::size_t kShown = 20;
constexpr std::array<const char*, 8> kKinds = {"solid",     "sky",    "glass",  "player_clip",
                                               "shot_clip", "liquid", "portal", "data"};

/// Without the portals that --rooms auto added, which come last.
std::span<const Brush> brushes_of_file(const LoadedBrushes& loaded) {
    const std::size_t added = loaded.divided ? loaded.divided->portals : 0;
    return std::span(loaded.level.brushes).first(loaded.level.brushes.size() - added);
}

std::array<std::size_t, kKinds.size()> count_kinds(std::span<const Brush> brushes) {
    std::array<std::size_t, kKinds.size()> counts{};
    for (const Brush& brush : brushes) ++counts[std::size_t(brush.kind)];
    return counts;
}

std::size_t count_notes(const BrushWorldReport& report, BrushNote::What what) {
    return std::size_t(std::count_if(report.notes.begin(), report.notes.end(),
                                     [&](const BrushNote& note) { return note.what == what; }));
}

/// Without the empty one that stands for none.
std::vector<std::string> material_names(const BrushLevel& level) {
    std::vector<std::string> names;
    for (const auto* list : {&level.materials, &level.surfaces.materials})
        for (const std::string& name : *list)
            if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

void add_divided(JsonWriter& json, const std::optional<DivideReport>& divided) {
    if (!divided) {
        json.add_null("divided");
        return;
    }
    json.open_object("divided");
    json.add("cells", divided->cells);
    json.add("narrows", divided->narrows);
    json.add("untried", divided->untried);
    json.add("idle", divided->idle);
    json.add("portals", divided->portals);
    json.close();
}

std::string info_json(const LoadedLevel& loaded) {
    const auto& [level, report, divided] = *loaded.brushes;
    const std::size_t solid = measure_solid(loaded.world).facets, total = loaded.world.face_count();
    JsonWriter json;
    json.open_object();
    json.add("level", level.name);
    json.add("entities", level.entities.size());
    json.open_object("brushes");
    const std::span<const Brush> brushes = brushes_of_file(*loaded.brushes);
    json.add("total", brushes.size());
    const auto kinds = count_kinds(brushes);
    for (std::size_t k = 0; k < kinds.size(); ++k) json.add(kKinds[k], kinds[k]);
    json.add("not_joined", count_notes(report, BrushNote::What::kNotJoined));
    json.add("no_volume", count_notes(report, BrushNote::What::kNoVolume));
    json.close();
    json.open_object("faces");
    json.add("total", total);
    json.add("solid", solid);
    json.add("other", total - solid);
    json.close();
    json.open_array("materials");
    for (const std::string& name : material_names(level)) json.add({}, name);
    json.close();
    json.add("planes_moved", report.planes_moved);
    json.add("max_shift", level.max_shift);
    json.add("idle_portals", count_notes(report, BrushNote::What::kIdlePortal));
    add_divided(json, divided);
    add_left_out(json, left_out(loaded));
    add_world(json, loaded.world);
    json.add("read_seconds", loaded.read_seconds);
    json.add("build_seconds", loaded.build_seconds);
    json.close();
    return json.text();
}

std::string kinds_text(std::span<const Brush> brushes) {
    std::string text;
    const auto kinds = count_kinds(brushes);
    for (std::size_t k = 0; k < kinds.size(); ++k)
        if (kinds[k] > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(kinds[k]), kKinds[k]);
    return text.empty() ? "none" : text;
}

std::string info_text(const LoadedLevel& loaded) {
    const auto& [level, report, divided] = *loaded.brushes;
    const std::size_t solid = measure_solid(loaded.world).facets, total = loaded.world.face_count();
    std::string text;
    const auto row = [&](const char* what, const std::string& value) { text += info_row(what, value); };
    row("level", level.name);
    row("entities", grouped(level.entities.size()));
    const std::span<const Brush> brushes = brushes_of_file(*loaded.brushes);
    row("brushes", fmt::format("{} ({})", grouped(brushes.size()), kinds_text(brushes)));
    row("joined", fmt::format("{} of solid, {} castable only, {} without volume", grouped(report.solid_brushes),
                              grouped(count_notes(report, BrushNote::What::kNotJoined)),
                              grouped(count_notes(report, BrushNote::What::kNoVolume))));
    row("faces", fmt::format("{}: {} of the solid, {} others", grouped(total), grouped(solid), grouped(total - solid)));
    row("planes", fmt::format("{} moved a little; onto the grid by {:.2g} mm at most", grouped(report.planes_moved),
                              level.max_shift * 1000));
    row("materials", grouped(material_names(level).size()));
    row("left out", left_out_text(left_out(loaded)));
    if (divided)
        row("divided",
            fmt::format("{} added; {} tried that the air goes around", counted(divided->portals, "portal"),
                        grouped(divided->idle)) +
                (divided->untried > 0 ? fmt::format("; {} too many to be tried", grouped(divided->untried)) : ""));
    text += world_text(loaded.world);
    row("time", fmt::format("{} to read, {} to join and build", seconds_text(loaded.read_seconds),
                            seconds_text(loaded.build_seconds)));
    return text;
}

struct Leak {
    std::size_t entity = 0;
    std::vector<Vec3> points;  ///< empty where the way is too narrow to be found
};

/// The world as the author divided it: a portal that was added may hide that there is no wall.
World undivided(const LoadedLevel& loaded) {
    if (!loaded.brushes->divided) return loaded.world;
    BrushLevel level = loaded.brushes->level;
    level.brushes.resize(brushes_of_file(*loaded.brushes).size());
    return take(make_world(level));
}

/// Whether a room is the exterior, or a way leads there through portals.
bool is_open(const World& world, RoomId room) {
    for (std::uint32_t other = 0; other < world.room_count(); ++other)
        if (room_info(world, {other})->exterior && find_path(world, room, {other}, Doors::kAllOpen)) return true;
    return false;
}

/// From the first player's start that a way leads from to beyond all faces; in a level without players, from the first
/// entity that stands anywhere in the air.
std::optional<Leak> leak_of(const LoadedLevel& loaded) {
    const BrushLevel& level = loaded.brushes->level;
    const World world = undivided(loaded);
    const auto is_player = [](const Entity& entity) { return entity.value("classname").starts_with("info_player"); };
    const bool any_player = std::any_of(level.entities.begin(), level.entities.end(), is_player);
    for (std::size_t k = 0; k < level.entities.size(); ++k) {
        if (any_player && !is_player(level.entities[k])) continue;
        const std::optional<Vec3> origin = entity_origin(level, level.entities[k]);
        if (!origin) continue;
        const Location found = locate(world, *origin);
        if (found.where == Where::kAir && is_open(world, found.room)) return Leak{k, find_leak(world, *origin)};
    }
    return {};
}

void write_pts(const std::string& path, const BrushLevel& level, const Leak& leak) {
    std::string text;
    for (const Vec3& point : leak.points) {
        for (int axis = 0; axis < 3; ++axis) {
            append_17(text, point[axis] / level.metres_a_unit);
            text += axis < 2 ? ' ' : '\n';
        }
    }
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

const char* note_name(BrushNote::What what) {
    switch (what) {
        case BrushNote::What::kNotJoined:
            return "not_joined";
        case BrushNote::What::kNoVolume:
            return "no_volume";
        case BrushNote::What::kIdlePortal:
            return "idle_portal";
    }
    return "";
}

const char* note_sentence(BrushNote::What what) {
    switch (what) {
        case BrushNote::What::kNotJoined:
            return "castable only";
        case BrushNote::What::kNoVolume:
            return "left out";
        case BrushNote::What::kIdlePortal:
            return "a portal that divides nothing";
    }
    return "";
}

std::string brush_place(const BrushLevel& level, std::uint32_t brush) {
    const std::uint32_t line = level.brushes[brush].line;
    return line > 0 ? fmt::format("{}:{}: brush {}", level.name, line, brush)
                    : fmt::format("{}: brush {}", level.name, brush);
}

std::string entity_place(const BrushLevel& level, std::uint32_t entity) {
    const std::uint32_t line = level.entities[entity].line;
    const std::string where = line > 0 ? fmt::format("{}:{}", level.name, line) : level.name;
    return fmt::format("{}: entity {} ({})", where, entity, level.entities[entity].value("classname"));
}

/// All that is to be noted, a line each.
std::vector<std::string> note_lines(const BrushLevel& level, const BrushWorldReport& report) {
    std::vector<std::string> lines;
    for (const BrushNote& note : report.notes)
        lines.push_back(
            fmt::format("{}: {}: {}", brush_place(level, note.brush), note_sentence(note.what), note.reason));
    for (const EntityNote& note : report.entity_notes)
        lines.push_back(fmt::format("{}: names no room: {}", entity_place(level, note.entity), note.reason));
    lines.insert(lines.end(), level.notes.begin(), level.notes.end());
    return lines;
}

struct Judgement {
    std::optional<WorldFault> world;
    std::optional<SolidFault> solid;
    std::optional<Leak> leak;

    bool sound() const { return !world && !solid && !leak; }
};

std::string check_text(const LoadedLevel& loaded, const Judgement& found, bool all) {
    const BrushLevel& level = loaded.brushes->level;
    const BrushWorldReport& report = loaded.brushes->report;
    std::string text;
    if (found.world) text += fmt::format("{}: the world is broken: {}\n", level.name, found.world->what);
    if (found.solid) text += fmt::format("{}: the solid is broken: {}\n", level.name, found.solid->what);
    if (found.leak) {
        const Entity& entity = level.entities[found.leak->entity];
        text += fmt::format("{}: leak: {} (entity {}) is open to the void{}\n", level.name, entity.value("classname"),
                            found.leak->entity, found.leak->points.empty() ? ", by a way too narrow to be shown" : ":");
        for (const Vec3& p : found.leak->points) text += fmt::format("  ({:.2f}, {:.2f}, {:.2f}) m\n", p.x, p.y, p.z);
    }
    if (const auto omissions = left_out(loaded); !omissions.empty())
        text += fmt::format("{}: left out: {}\n", level.name, left_out_text(omissions));
    const std::vector<std::string> notes = note_lines(level, report);
    const std::size_t shown = all ? notes.size() : std::min(notes.size(), kShown);
    for (std::size_t k = 0; k < shown; ++k) text += notes[k] + "\n";
    if (shown < notes.size()) text += fmt::format("  and {} more (--all shows them)\n", grouped(notes.size() - shown));
    return text + fmt::format("{}: {}; {}, {}, {}, {}; {}\n", level.name, found.sound() ? "sound" : "faulty",
                              counted(brushes_of_file(*loaded.brushes).size(), "brush", "brushes"),
                              counted(loaded.world.face_count(), "face"), counted(loaded.world.room_count(), "room"),
                              counted(portal_count(loaded.world), "portal"), counted(notes.size(), "note"));
}

std::string check_json(const LoadedLevel& loaded, const Judgement& found, bool all) {
    const BrushLevel& level = loaded.brushes->level;
    const BrushWorldReport& report = loaded.brushes->report;
    JsonWriter json;
    const auto add = [&](const char* key, const auto& fault) {
        if (fault)
            json.add(key, fault->what);
        else
            json.add_null(key);
    };
    json.open_object();
    json.add("level", level.name);
    json.add("sound", found.sound());
    json.add("brushes", brushes_of_file(*loaded.brushes).size());
    json.add("faces", loaded.world.face_count());
    json.add("rooms", loaded.world.room_count());
    json.add("portals", portal_count(loaded.world));
    add("world_fault", found.world);
    add("solid_fault", found.solid);
    if (found.leak) {
        json.open_object("leak");
        json.add("entity", found.leak->entity);
        json.open_array("points");
        for (const Vec3& point : found.leak->points) json.add({}, point);
        json.close();
        json.close();
    } else {
        json.add_null("leak");
    }
    add_left_out(json, left_out(loaded));
    json.add("note_count", report.notes.size() + report.entity_notes.size() + level.notes.size());
    json.open_array("notes");
    for (std::size_t k = 0; k < (all ? report.notes.size() : std::min(report.notes.size(), kShown)); ++k) {
        const BrushNote& note = report.notes[k];
        json.open_object();
        json.add("what", note_name(note.what));
        json.add("brush", note.brush);
        json.add("line", level.brushes[note.brush].line);
        json.add("reason", note.reason);
        json.close();
    }
    json.close();
    json.open_array("entity_notes");
    for (std::size_t k = 0; k < (all ? report.entity_notes.size() : std::min(report.entity_notes.size(), kShown));
         ++k) {
        const EntityNote& note = report.entity_notes[k];
        json.open_object();
        json.add("entity", note.entity);
        json.add("line", level.entities[note.entity].line);
        json.add("reason", note.reason);
        json.close();
    }
    json.close();
    json.open_array("reader_notes");
    for (std::size_t k = 0; k < (all ? level.notes.size() : std::min(level.notes.size(), kShown)); ++k)
        json.add({}, level.notes[k]);
    json.close();
    json.close();
    return json.text();
}

}  // namespace

int tell_brushes(const LoadedLevel& loaded, bool json) {
    print(json ? info_json(loaded) : info_text(loaded));
    return 0;
}

int check_brushes(const LoadedLevel& loaded, const CheckBrushes& how) {
    const Judgement found{check_world(loaded.world), check_solid(loaded.world), leak_of(loaded)};
    if (!how.pts.empty()) {
        if (found.leak)
            write_pts(how.pts, loaded.brushes->level, *found.leak);
        else
            write_pts(how.pts, loaded.brushes->level, {});
    }
    print(how.json ? check_json(loaded, found, how.all) : check_text(loaded, found, how.all));
    return found.sound() ? 0 : 1;
}

}  // namespace firma::cli

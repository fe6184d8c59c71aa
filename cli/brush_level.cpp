// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of a level of brushes.
#include "cli/brush_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cli/anchor_brushes.h"
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

void add_divided(Json& json, const std::optional<DivideReport>& divided) {
    if (!divided) {
        json["divided"] = nullptr;
        return;
    }
    json["divided"] = {{"cells", divided->cells},
                       {"narrows", divided->narrows},
                       {"untried", divided->untried},
                       {"idle", divided->idle},
                       {"portals", divided->portals}};
}

Json info_json(const LoadedLevel& loaded) {
    const auto& [level, report, divided] = *loaded.brushes;
    const std::size_t solid = measure_solid(loaded.world).facets, total = loaded.world.face_count();
    Json json;
    json["level"] = level.name;
    json["entities"] = level.entities.size();
    const std::span<const Brush> brushes = brushes_of_file(*loaded.brushes);
    Json counts;
    counts["total"] = brushes.size();
    const auto kinds = count_kinds(brushes);
    for (std::size_t k = 0; k < kinds.size(); ++k) counts[kKinds[k]] = kinds[k];
    counts["not_joined"] = count_notes(report, BrushNote::What::kNotJoined);
    counts["no_volume"] = count_notes(report, BrushNote::What::kNoVolume);
    json["brushes"] = std::move(counts);
    json["faces"] = {{"total", total}, {"solid", solid}, {"other", total - solid}};
    json["materials"] = material_names(level);
    json["planes_moved"] = report.planes_moved;
    json["greatest_shift"] = level.max_shift;
    json["idle_portals"] = count_notes(report, BrushNote::What::kIdlePortal);
    json["anchor_volumes"] = anchor_volumes(level).size();
    add_divided(json, divided);
    add_left_out(json, left_out(loaded));
    add_world(json, loaded.world);
    json["read_seconds"] = loaded.read_seconds;
    json["build_seconds"] = loaded.build_seconds;
    return json;
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
    if (const std::size_t volumes = anchor_volumes(level).size(); volumes > 0)
        row("anchors", counted(volumes, "volume") + " of firma_anchor");
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
std::vector<std::string> note_lines(const BrushLevel& level, const BrushWorldReport& report,
                                    const AnchorBrushes& anchors) {
    std::vector<std::string> lines;
    for (const BrushNote& note : report.notes)
        lines.push_back(
            fmt::format("{}: {}: {}", brush_place(level, note.brush), note_sentence(note.what), note.reason));
    for (const EntityNote& note : report.entity_notes)
        lines.push_back(fmt::format("{}: names no room: {}", entity_place(level, note.entity), note.reason));
    for (const EntityNote& note : anchors.notes)
        lines.push_back(fmt::format("{}: holds nothing: {}", entity_place(level, note.entity), note.reason));
    lines.insert(lines.end(), level.notes.begin(), level.notes.end());
    return lines;
}

struct Judgement {
    std::optional<WorldFault> world;
    std::optional<SolidFault> solid;
    std::optional<Leak> leak;
    AnchorBrushes anchors;

    bool sound() const { return !world && !solid && !leak; }
};

/// ", 4 anchor volumes"
std::string volumes_clause(const AnchorBrushes& anchors) {
    return anchors.volumes > 0 ? ", " + counted(anchors.volumes, "anchor volume") : "";
}

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
    const std::vector<std::string> notes = note_lines(level, report, found.anchors);
    const std::size_t shown = all ? notes.size() : std::min(notes.size(), kShown);
    for (std::size_t k = 0; k < shown; ++k) text += notes[k] + "\n";
    if (shown < notes.size()) text += fmt::format("  and {} more (--all shows them)\n", grouped(notes.size() - shown));
    return text + fmt::format("{}: {}; {}, {}, {}, {}; {}\n", level.name, found.sound() ? "sound" : "faulty",
                              counted(brushes_of_file(*loaded.brushes).size(), "brush", "brushes"),
                              counted(loaded.world.face_count(), "face"), counted(loaded.world.room_count(), "room"),
                              counted(portal_count(loaded.world), "portal") + volumes_clause(found.anchors),
                              counted(notes.size(), "note"));
}

Json check_json(const LoadedLevel& loaded, const Judgement& found, bool all) {
    const BrushLevel& level = loaded.brushes->level;
    const BrushWorldReport& report = loaded.brushes->report;
    const auto shown = [&](const auto& notes) {
        return std::span(notes).first(all ? notes.size() : std::min(notes.size(), kShown));
    };
    const auto reason = [](const auto& fault) { return fault ? Json(fault->what) : Json(); };
    Json json;
    json["level"] = level.name;
    json["sound"] = found.sound();
    json["brushes"] = brushes_of_file(*loaded.brushes).size();
    json["faces"] = loaded.world.face_count();
    json["rooms"] = loaded.world.room_count();
    json["portals"] = portal_count(loaded.world);
    json["anchor_volumes"] = found.anchors.volumes;
    json["world_fault"] = reason(found.world);
    json["solid_fault"] = reason(found.solid);
    json["leak"] = nullptr;
    if (found.leak) json["leak"] = {{"entity", found.leak->entity}, {"points", found.leak->points}};
    add_left_out(json, left_out(loaded));
    std::vector<EntityNote> entity_notes = report.entity_notes;
    entity_notes.insert(entity_notes.end(), found.anchors.notes.begin(), found.anchors.notes.end());
    json["note_count"] = report.notes.size() + entity_notes.size() + level.notes.size();
    json["notes"] = Json::array();
    for (const BrushNote& note : shown(report.notes))
        json["notes"].push_back({{"what", note_name(note.what)},
                                 {"brush", note.brush},
                                 {"line", level.brushes[note.brush].line},
                                 {"reason", note.reason}});
    json["entity_notes"] = Json::array();
    for (const EntityNote& note : shown(entity_notes))
        json["entity_notes"].push_back(
            {{"entity", note.entity}, {"line", level.entities[note.entity].line}, {"reason", note.reason}});
    json["reader_notes"] = shown(level.notes);
    return json;
}

}  // namespace

int tell_brushes(const LoadedLevel& loaded, bool json) {
    print(json ? json_text(info_json(loaded)) : info_text(loaded));
    return 0;
}

int check_brushes(const LoadedLevel& loaded, const CheckBrushes& how) {
    const Judgement found{check_world(loaded.world), check_solid(loaded.world), leak_of(loaded),
                          judge_anchors(loaded.brushes->level, loaded.world)};
    if (!how.pts.empty()) {
        if (found.leak)
            write_pts(how.pts, loaded.brushes->level, *found.leak);
        else
            write_pts(how.pts, loaded.brushes->level, {});
    }
    print(how.json ? json_text(check_json(loaded, found, how.all)) : check_text(loaded, found, how.all));
    return found.sound() ? 0 : 1;
}

}  // namespace firma::cli

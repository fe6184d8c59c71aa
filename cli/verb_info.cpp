// SPDX-License-Identifier: MIT
// Reads a level, builds its tree, and tells about both.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "cli/brush_level.h"
#include "cli/describe_world.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/saved_world.h"

namespace firma::cli {

namespace {

struct InfoArguments {
    LevelArguments level;
    std::string split, max_depth, faces_per_leaf, min_node_volume;
    bool json = false;
};

constexpr const char* kInfoFooter = R"(Lengths are metres, volumes cubic metres, times seconds.

Faces are divided in two, and again, until they meet any of the three stop rules; more than 64 are halved all the same,
as blocks hold no more. Up to eight boxes make a node of the tree. `overlap` is what boxes of a node share by twos, as a
share of the node's surface, on average.

--json: level, faces {total, in_file, polygon, triangle_soup, patch, dropped, divided, crossing}, vertices,
corners, materials [names], groups, ignored_entries, left_out [{what, count, first}], bounds {low, high} or null, rooms [{id, name, exterior, faces,
bounds, portals [ids]}], portals [{id, name, rooms [ids], open, polygons, bounds}], tree {faces, blocks, bins,
leaf_bins, depth, largest_bin, overlap, bytes, bytes_per_face}, solid {faces, volume, area}, matter {pieces, protected,
rest, of [{name, pieces}]}, read_seconds, build_seconds. `solid` is of the faces that bound solids, which can be carved;
its volume is negative where rock reaches to infinity: then it is that of the air. `matter` counts the pieces that are
told apart by what they are made of, how many of them may not be carved, and names what lies in none.

`left_out` is what the file holds and casts do not meet: what Firma does not read, has no area or volume, or belongs to
entities that move; what, how many, and the place of the first, or "". Other verbs warn of it on stderr. A level of
which no face is left is bad input.

Of glTF --json has in addition: gltf {nodes, parts [{name, node, faces}], portals [{name, polygons, idle}], undivided or null, notes [texts]}; faces in
the file are its triangles, without those of portals. An idle portal, or a part of it, has one room on both sides;
`undivided` is why there is one room though the file has portals.

Of a level of brushes (.map, .bsp without --surfaces) --json has: level, entities, brushes {total, solid, sky, glass,
player_clip, shot_clip, liquid, portal, data, not_joined, no_volume}, faces {total, solid, other}, materials [names],
planes_moved, greatest_shift, idle_portals, anchor_volumes (of firma_anchor), divided, left_out, bounds, rooms, portals,
tree, solid, matter, read_seconds, build_seconds.
`brushes` counts those of the file, no portals that were added; `faces` counts convex facets; those of `solid` bound
the joined solid. `divided` is null, or with --rooms auto {cells, narrows, untried, idle, portals}: how many cells
were tested, how many places where the air narrows, how many of these were too many to be tried, how many were tried
in vain, as the air goes around by a way that the cells do not show, and how many portals were added.

Of a .firma file, which holds a world rather than a level, --json has: level, bytes, version (of the world: how many
edits were published), edits, exact (whether exact faces or faces that bound solids are there: without, it cannot be
carved), faces {total, solid, exact}, materials [names], bounds, rooms, portals, tree, solid, matter, rules {zones, hard_materials},
read_seconds.
)";

TreeOptions tree_options(const InfoArguments& arguments) {
    TreeOptions options;
    if (arguments.split == "longest-axis") {
        options.split = Split::kLongestAxis;
    } else if (!arguments.split.empty() && arguments.split != "surface-area") {
        throw Failure("--split", "'" + arguments.split + "' is neither longest-axis nor surface-area");
    }
    if (!arguments.max_depth.empty()) options.max_depth = int(count_option("--max-depth", arguments.max_depth, 0, 64));
    if (!arguments.faces_per_leaf.empty())
        options.faces_per_leaf = int(count_option("--faces-per-bin", arguments.faces_per_leaf, 1, 1000000000));
    if (!arguments.min_node_volume.empty())
        options.min_node_volume = number_option("--min-bin-volume", arguments.min_node_volume, 0, INFINITY);
    return options;
}

/// A saved world has its options with it.
void refuse_tree_options(const InfoArguments& arguments) {
    const auto refuse = [](const char* name, const std::string& value) {
        if (!value.empty())
            throw Failure(name, "a .firma file says how its tree is built; build another from what it was made of");
    };
    refuse("--split", arguments.split);
    refuse("--max-depth", arguments.max_depth);
    refuse("--faces-per-bin", arguments.faces_per_leaf);
    refuse("--min-bin-volume", arguments.min_node_volume);
}

struct KindCounts {
    std::size_t polygons = 0, soup = 0, patches = 0;
};

KindCounts count_kinds(const Level& level) {
    KindCounts counts;
    for (const LevelFace& face : level.faces) {
        counts.polygons += face.kind == FaceKind::kPolygon;
        counts.soup += face.kind == FaceKind::kTriangleSoup;
        counts.patches += face.kind == FaceKind::kPatch;
    }
    return counts;
}

/// Names of materials, without the empty one that stands for none.
std::vector<std::string> material_names(const Level& level) {
    std::vector<std::string> names;
    for (const std::string& name : level.materials) {
        if (!name.empty()) names.push_back(name);
    }
    return names;
}

Json gltf_json(const LoadedGltf& gltf) {
    const std::vector<std::uint32_t>& idle = gltf.rooms.idle;
    Json portals = Json::array();
    for (std::uint32_t k = 0; k < gltf.portals.size(); ++k)
        portals.push_back({{"name", gltf.portals[k].name},
                           {"polygons", gltf.portals[k].polygons.size()},
                           {"idle", std::find(idle.begin(), idle.end(), k) != idle.end()}});
    Json parts = Json::array();
    for (const GltfPart& part : gltf.parts)
        parts.push_back({{"name", part.name}, {"node", part.node}, {"faces", part.level.faces.size()}});
    return {{"nodes", gltf.nodes.size()},
            {"parts", parts},
            {"portals", std::move(portals)},
            {"undivided", gltf.rooms.undivided.empty() ? Json() : Json(gltf.rooms.undivided)},
            {"notes", gltf.notes}};
}

std::size_t divided_faces(const Level& level) {
    return level.count(FaceNote::kSplit) + level.count(FaceNote::kCrossing) + level.count(FaceNote::kTexture);
}

Json json_of(const LoadedLevel& loaded) {
    const Level& level = loaded.level;
    const KindCounts kinds = count_kinds(level);
    Json json;
    json["level"] = level.name;
    json["faces"] = {{"total", level.faces.size()},     {"in_file", level.source_faces},
                     {"polygon", kinds.polygons},       {"triangle_soup", kinds.soup},
                     {"patch", kinds.patches},          {"dropped", level.count(FaceNote::kNoArea)},
                     {"divided", divided_faces(level)}, {"crossing", level.count(FaceNote::kCrossing)}};
    json["vertices"] = level.vertices.size();
    json["corners"] = level.corners.size();
    json["materials"] = material_names(level);
    json["groups"] = level.groups.size();
    json["ignored_entries"] = level.ignored_entries;
    add_left_out(json, left_out(loaded));
    if (loaded.gltf) json["gltf"] = gltf_json(*loaded.gltf);
    add_world(json, loaded.world);
    json["read_seconds"] = loaded.read_seconds;
    json["build_seconds"] = loaded.build_seconds;
    return json;
}

std::string kinds_text(const KindCounts& kinds) {
    std::string text;
    const auto add = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        text += text.empty() ? "" : ", ";
        text += fmt::format("{} {}", grouped(count), what);
    };
    add(kinds.polygons, "of polygons");
    add(kinds.soup, "of triangle soups");
    add(kinds.patches, "of patches");
    return text.empty() ? "none" : text;
}

std::string use_of(const LoadedGltf& gltf) {
    if (!gltf.rooms.undivided.empty()) return ", of no use: " + gltf.rooms.undivided;
    if (gltf.rooms.idle.empty()) return "";
    return fmt::format(", {} of them in whole or part with one room on both sides", grouped(gltf.rooms.idle.size()));
}

std::string text_for_people(const LoadedLevel& loaded) {
    const Level& level = loaded.level;
    std::string text;
    const auto row = [&](const char* what, const std::string& value) { text += info_row(what, value); };
    row("level", level.name);
    row("faces", fmt::format("{} ({})", grouped(level.faces.size()), kinds_text(count_kinds(level))));
    row("faces in file", fmt::format("{}: {} dropped (no area), {} divided ({} of them cross themselves)",
                                     grouped(level.source_faces), grouped(level.count(FaceNote::kNoArea)),
                                     grouped(divided_faces(level)), grouped(level.count(FaceNote::kCrossing))));
    row("corners", fmt::format("{}, of {} vertices", grouped(level.corners.size()), grouped(level.vertices.size())));
    row("materials", grouped(material_names(level).size()));
    row("ignored", fmt::format("{} entries of the file that are not faces", grouped(level.ignored_entries)));
    row("left out", left_out_text(left_out(loaded)));
    if (loaded.gltf) {
        row("nodes", grouped(loaded.gltf->nodes.size()));
        if (const std::size_t parts = loaded.gltf->parts.size(); parts > 0)
            row("parts that move", grouped(parts) + ", whose faces are not counted");
        if (const std::size_t portals = loaded.gltf->portals.size(); portals > 0)
            row("portals in file", grouped(portals) + use_of(*loaded.gltf));
        for (const std::string& note : loaded.gltf->notes) row("note", note);
    }
    text += world_text(loaded.world);
    row("time",
        fmt::format("{} to read, {} to build", seconds_text(loaded.read_seconds), seconds_text(loaded.build_seconds)));
    return text;
}

int run(InfoArguments& arguments) {
    arguments.level.tells_left_out = true;
    WorldOptions options;
    options.tree = tree_options(arguments);
    if (names_saved_world(arguments.level.path)) {
        refuse_tree_options(arguments);
        return tell_saved_world(load_level(arguments.level), arguments.json);
    }
    const LoadedLevel loaded = load_level(arguments.level, options);
    if (loaded.brushes) return tell_brushes(loaded, arguments.json);
    print(arguments.json ? json_text(json_of(loaded)) : text_for_people(loaded));
    return 0;
}

}  // namespace

Verb add_info(CLI::App& app) {
    Command command(app, "info", "Tells what a level is: faces by kind, bounds, tree, bytes, times");
    const auto arguments = std::make_shared<InfoArguments>();
    add_level_arguments(command, arguments->level);
    add_rooms_option(command, arguments->level);
    add_matter_option(command, arguments->level);
    command.add_option("--split", arguments->split, "HOW", "how nodes divide: surface-area (default) or longest-axis");
    command.add_option("--max-depth", arguments->max_depth, "N",
                       "stop rule: divisions in two above a node, 0 .. 64 (default 48)");
    command.add_option("--faces-per-bin", arguments->faces_per_leaf, "N",
                       "stop rule: a node of at most this many triangles, rounded up to eights (default 4)");
    command.add_option("--min-bin-volume", arguments->min_node_volume, "V",
                       "stop rule: a node of less volume, cubic metres (default 0)");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kInfoFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli

// SPDX-License-Identifier: MIT
// Reads, builds, and keeps the time of both.
#include "cli/load_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "cli/failure.h"
#include "cli/numbers.h"
#include "firma/save.h"
#include "level/read_file.h"

namespace firma::cli {

void add_level_arguments(Command& command, LevelArguments& arguments, bool required) {
    command.add_argument(
        "LEVEL", arguments.path,
        "a Wavefront .obj, a glTF 2.0 .gltf or .glb, a Quake .map, a Quake 3 .bsp (version 46), or a saved "
        "world, .firma",
        required);
    command.add_option(
        "--scale", arguments.scale, "S",
        "metres a unit of the file (default: 1 for .obj and glTF, 1/32 for .map and .bsp); not for .firma");
    command.add_flag("--surfaces", arguments.surfaces,
                     "of a .bsp the drawn surfaces, rather than the brushes joined into one solid");
}

void add_rooms_option(Command& command, LevelArguments& arguments) {
    command.add_choice("--rooms", arguments.rooms, "auto",
                       "of a .map, or a .bsp's brushes: divide the air at doorways and where it narrows, beside the "
                       "author's portals");
}

void add_matter_option(Command& command, LevelArguments& arguments) {
    command.add_option("--matter", arguments.matter, "FILE",
                       "a table of what the level is made of, in place of the built-in one (docs/formats.md); not for "
                       ".firma");
}

ReadOptions read_options(const LevelArguments& arguments) {
    ReadOptions options;
    if (arguments.scale.empty()) return options;
    options.scale = number_option("--scale", arguments.scale);
    if (options.scale <= 0) throw Failure("--scale", arguments.scale + " is not more than 0");
    return options;
}

GltfOptions gltf_options(const LevelArguments& arguments) {
    GltfOptions options;
    if (const double scale = read_options(arguments).scale; scale > 0) options.scale = scale;
    return options;
}

bool has_ending(const std::string& path, std::string_view ending) {
    if (path.size() < ending.size()) return false;
    const auto alike = [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); };
    return std::equal(path.end() - std::ptrdiff_t(ending.size()), path.end(), ending.begin(), alike);
}

bool names_saved_world(const std::string& path) {
    return has_ending(path, ".firma");
}

bool names_gltf(const std::string& path) {
    return has_ending(path, ".glb") || has_ending(path, ".gltf");
}

void refuse_unknown_ending(const std::string& path) {
    if (!names_saved_world(path) && !names_gltf(path) && !level_format(path))
        throw Failure(path, "the name ends in none of " + level_endings() + ", .gltf, .glb, .firma");
}

bool names_brushes(const LevelArguments& arguments) {
    return has_ending(arguments.path, ".map") || (has_ending(arguments.path, ".bsp") && !arguments.surfaces);
}

namespace {

void load_brushes(const LevelArguments& arguments, const WorldOptions& options, LoadedLevel& loaded) {
    const auto start = std::chrono::steady_clock::now();
    LoadedBrushes& brushes = loaded.brushes.emplace();
    brushes.level = take(read_brush_level(arguments.path, read_options(arguments)));
    loaded.level.name = arguments.path;
    loaded.read_seconds = seconds_since(start);
    const auto read = std::chrono::steady_clock::now();
    if (!arguments.rooms.empty()) brushes.level = take(divide_rooms(brushes.level, {}, &brushes.divided.emplace()));
    loaded.world = take(make_world(brushes.level, options, &brushes.report));
    loaded.build_seconds = seconds_since(read);
}

void refuse_rooms(const LevelArguments& arguments) {
    if (arguments.rooms.empty()) return;
    if (arguments.rooms != "auto") throw Failure("--rooms", "is auto or not given, and not " + arguments.rooms);
    if (!names_brushes(arguments))
        throw Failure("--rooms", "auto divides levels of brushes: a .map, or a .bsp without --surfaces");
}

void load_gltf(const LevelArguments& arguments, const WorldOptions& options, LoadedLevel& loaded) {
    const auto start = std::chrono::steady_clock::now();
    GltfLevel read = take(read_gltf(arguments.path, gltf_options(arguments)));
    loaded.read_seconds = seconds_since(start);
    LoadedGltf& gltf = loaded.gltf.emplace();
    const auto built = std::chrono::steady_clock::now();
    loaded.world = take(make_world(read, options, &gltf.rooms));
    loaded.build_seconds = seconds_since(built);
    gltf.nodes = std::move(read.nodes);
    gltf.parts = std::move(read.parts);
    gltf.portals = std::move(read.portals);
    gltf.notes = std::move(read.notes);
    loaded.level = std::move(read.level);
}

}  // namespace

std::vector<Omission> left_out(const LoadedLevel& loaded) {
    std::vector<Omission> all = loaded.level.omissions;
    if (!loaded.brushes) return all;
    const BrushLevel& level = loaded.brushes->level;
    for (const auto* omissions : {&level.omissions, &level.surfaces.omissions})
        all.insert(all.end(), omissions->begin(), omissions->end());
    Omission empty{"brushes without volume", 0, ""};
    for (const BrushNote& note : loaded.brushes->report.notes) {
        if (note.what != BrushNote::What::kNoVolume) continue;
        if (empty.count++ > 0) continue;
        const std::uint32_t line = level.brushes[note.brush].line;
        empty.first =
            line > 0 ? fmt::format("{}:{}", level.name, line) : fmt::format("{}: brush {}", level.name, note.brush);
    }
    if (empty.count > 0) all.push_back(empty);
    return all;
}

std::string left_out_text(const std::vector<Omission>& omissions) {
    std::string text;
    for (const Omission& omission : omissions)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", omission.what, grouped(omission.count));
    return text.empty() ? "nothing" : text;
}

void add_left_out(Json& json, const std::vector<Omission>& omissions) {
    json["left_out"] = Json::array();
    for (const Omission& omission : omissions)
        json["left_out"].push_back({{"what", omission.what}, {"count", omission.count}, {"first", omission.first}});
}

namespace {

LoadedLevel load_quietly(const LevelArguments& arguments, const WorldOptions& options) {
    LoadedLevel loaded;
    const auto start = std::chrono::steady_clock::now();
    refuse_rooms(arguments);
    if (names_saved_world(arguments.path)) {
        if (!arguments.scale.empty()) throw Failure("--scale", "a .firma file is in metres; scale what it was made of");
        loaded.world = take(load_world(arguments.path));
        loaded.saved = true;
        loaded.level.name = arguments.path;
        loaded.read_seconds = seconds_since(start);
        return loaded;
    }
    refuse_unknown_ending(arguments.path);
    if (arguments.surfaces && !has_ending(arguments.path, ".bsp"))
        throw Failure("--surfaces", "only a .bsp has drawn surfaces beside its brushes");
    if (names_brushes(arguments)) {
        load_brushes(arguments, options, loaded);
        return loaded;
    }
    if (names_gltf(arguments.path)) {
        load_gltf(arguments, options, loaded);
        return loaded;
    }
    loaded.level = take(read_level(arguments.path, read_options(arguments)));
    loaded.read_seconds = seconds_since(start);
    const auto read = std::chrono::steady_clock::now();
    loaded.world = take(make_world(loaded.level, options));
    loaded.build_seconds = seconds_since(read);
    return loaded;
}

}  // namespace

LoadedLevel load_level(const LevelArguments& arguments, const WorldOptions& given) {
    WorldOptions options = given;
    if (!arguments.matter.empty()) {
        if (names_saved_world(arguments.path)) throw Failure("--matter", "a .firma file has its own table with it");
        options.matters = take(read_matter_file(arguments.matter));
    }
    LoadedLevel loaded = load_quietly(arguments, options);
    const std::vector<Omission> omissions = left_out(loaded);
    if (!omissions.empty() && !arguments.tells_left_out)
        std::fputs(fmt::format("firma: warning: {}: left out: {} (firma info --json says where)\n", arguments.path,
                               left_out_text(omissions))
                       .c_str(),
                   stderr);
    return loaded;
}

std::string short_name(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

}  // namespace firma::cli

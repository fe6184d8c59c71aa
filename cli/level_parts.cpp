// SPDX-License-Identifier: MIT
// Parts of a level: their worlds, names, and how they go.
#include "cli/level_parts.h"

#include <string>
#include <utility>

#include "cli/failure.h"
#include "cli/json_fields.h"
#include "cli/script_parts.h"
#include "firma/brush_parts.h"

namespace firma::cli {

namespace {

WorldOptions options_of(const LevelArguments& arguments) {
    WorldOptions options;
    if (!arguments.matter.empty()) options.matters = take(read_matter_file(arguments.matter));
    return options;
}

std::string numbered_name(const GameState& game) {
    return "part_" + std::to_string(game.parts.size());
}

void add_brush_parts(const BrushLevel& level, const WorldOptions& options, GameState& game) {
    const BrushParts parts = take(make_brush_parts(level, options));
    for (const BrushPart& part : parts.parts) {
        MovingPart moving(part.world);
        moving.name = numbered_name(game);
        moving.entity = part.entity;
        PartDrive drive;
        drive.path = part.path;
        drive.waits = part.waits_for_trigger;
        drive.when_blocked = part.when_blocked;
        add_part(game, std::move(moving), std::move(drive));
    }
}

std::string name_of(const GltfPart& part, const GameState& game) {
    bool taken = part.name.empty();
    for (const MovingPart& other : game.parts) taken |= other.name == part.name;
    return taken ? numbered_name(game) : part.name;
}

/// What the node's extra `firma_motion` or `motion` says, an object or a text of one; else it stands.
PartDrive drive_of_node(const GltfPart& part, const GltfNode& node, const std::string& place) {
    Pose stands;
    stands.position = part.position;
    stands.rotation = part.rotation;
    for (const char* key : {"firma_motion", "motion"}) {
        const std::string text(node.value(key));
        if (text.empty()) continue;
        const std::string where = place + ": " + key;
        const Json json = parse_json(text, where);
        JsonFields fields(json, where);
        PartDrive drive = drive_of(fields, stands);
        fields.finish();
        return drive;
    }
    PartDrive drive;
    drive.path.rotation = part.rotation;
    drive.path.stops.push_back({part.position, 0, 0, 0});
    return drive;
}

void add_gltf_part(const GltfPart& part, const LoadedGltf& gltf, const WorldOptions& options, const std::string& file,
                   GameState& game) {
    const std::string place = file + ": node " + std::to_string(part.node);
    const Result<World> world = make_world(part.level, options);
    if (!world) throw Failure(place, world.error().reason);
    MovingPart moving(world.value());
    moving.name = name_of(part, game);
    for (const GltfNode& node : gltf.nodes)
        if (node.index == part.node) add_part(game, std::move(moving), drive_of_node(part, node, place));
}

}  // namespace

void add_level_parts(const LevelArguments& arguments, const LoadedLevel& loaded, GameState& game) {
    const WorldOptions options = options_of(arguments);
    if (loaded.brushes) add_brush_parts(loaded.brushes->level, options, game);
    if (!loaded.gltf) return;
    for (const GltfPart& part : loaded.gltf->parts) add_gltf_part(part, *loaded.gltf, options, arguments.path, game);
}

}  // namespace firma::cli

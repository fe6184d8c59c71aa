// SPDX-License-Identifier: MIT
// The level or saved world that nearly every verb begins with: its arguments, and reading it into a world.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/json.h"
#include "firma/brush_world.h"
#include "firma/level.h"
#include "firma/read_gltf.h"
#include "firma/world.h"

namespace firma::cli {

struct LevelArguments {
    std::string path;
    std::string scale;      ///< as typed; empty for the format's own
    std::string rooms;      ///< "auto": the air is divided where it narrows; empty: as the author's portals do
    std::string matter;     ///< a file with a table of matters; empty: the built-in one
    bool surfaces = false;  ///< of a .bsp the drawn surfaces rather than the brushes
    /// The verb tells on standard output what was left out: then nothing of it is said on stderr.
    bool tells_left_out = false;
};

/// Adds LEVEL (required unless told otherwise), --scale and --surfaces.
void add_level_arguments(Command& command, LevelArguments& arguments, bool required = true);
/// Adds --rooms.
void add_rooms_option(Command& command, LevelArguments& arguments);

/// Adds --matter.
void add_matter_option(Command& command, LevelArguments& arguments);

ReadOptions read_options(const LevelArguments& arguments);
/// The same for glTF, where y points up and becomes z.
GltfOptions gltf_options(const LevelArguments& arguments);

/// What a .map or the brushes of a .bsp came to.
struct LoadedBrushes {
    BrushLevel level;
    BrushWorldReport report;
    std::optional<DivideReport> divided;  ///< with --rooms auto; the level has the portals
};

/// What a .gltf or .glb has beside its faces.
struct LoadedGltf {
    std::vector<GltfNode> nodes;
    std::vector<GltfPart> parts;
    std::vector<GltfPortal> portals;
    GltfRooms rooms;
    std::vector<std::string> notes;
};

struct LoadedLevel {
    Level level;  ///< only its name, of a .firma file or a level of brushes
    std::optional<LoadedBrushes> brushes;
    std::optional<LoadedGltf> gltf;
    World world;
    bool saved = false;  ///< whether it came from a .firma file, which has a world as it was saved, not a level
    double read_seconds = 0, build_seconds = 0;
};

/// Whether a name ends so (".glb"), capitals or not.
bool has_ending(const std::string& path, std::string_view ending);
/// @throws Failure that lists the endings that are read, for a name with none of them
void refuse_unknown_ending(const std::string& path);
/// Whether a level's brushes are read, rather than faces.
bool names_brushes(const LevelArguments& arguments);
/// Whether a name ends in .gltf or .glb, capitals or not.
bool names_gltf(const std::string& path);
/// Whether a name ends in .firma, capitals or not.
bool names_saved_world(const std::string& path);

/// All that the file holds and the world does not.
std::vector<Omission> left_out(const LoadedLevel& loaded);
/// "lines (l): 3; faces without area: 2"; "nothing".
std::string left_out_text(const std::vector<Omission>& omissions);
/// left_out [{what, count, first}]
void add_left_out(Json& json, const std::vector<Omission>& omissions);

/// Says on stderr what was left out, in one line, unless the verb tells it.
///
/// @param options  of no use to a .firma file, which has its own
/// @throws Failure with the reader's place and reason; for a level of which no face is left; for --scale with a .firma
/// file, for --rooms with what has no
///         brushes
LoadedLevel load_level(const LevelArguments& arguments, const WorldOptions& options = {});

/// The file's own name, without folders.
std::string short_name(const std::string& path);

}  // namespace firma::cli

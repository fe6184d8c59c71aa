// SPDX-License-Identifier: MIT
// The format goes by the ending of the name.
#include "cli/write_level.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vector>

#include "cli/failure.h"
#include "cli/glb_parts.h"
#include "cli/numbers.h"
#include "cli/verb.h"
#include "cli/write_glb.h"
#include "firma/save.h"

namespace firma::cli {

void add_level_output(Command& command, LevelOutput& output, const char* help, bool required) {
    add_out_option(command, output.out, help, required);
    command.add_flag("--castable", output.castable,
                     "of brushes: write into an .obj what is castable only, too, so that it is not closed");
    command.add_option("--up", output.up, "AXIS", "of a .glb: the level's axis that points up: x, y or z (default z)");
}

void judge_level_output(const LevelOutput& output) {
    if (has_ending(output.out, ".gltf"))
        throw Failure(output.out, "glTF is written as one binary file; let its name end in .glb");
    if (!output.up.empty() && !names_glb(output.out)) throw Failure("--up", "is for a .glb");
    if (output.castable && (names_glb(output.out) || names_saved_world(output.out)))
        throw Failure("--castable", "is for an .obj; a .glb or .firma has such faces anyway");
    axis_option("--up", output.up);
}

void refuse_other_endings(const std::string& out) {
    const std::string ending = std::filesystem::path(out).extension().string();
    if (ending.empty() || has_ending(out, ".obj") || names_glb(out) || names_saved_world(out)) return;
    throw Failure(out, "a level is written as .obj, .glb or .firma, not as " + ending);
}

bool names_glb(const std::string& path) {
    return has_ending(path, ".glb");
}

bool leaves_out(const LoadedLevel& loaded, const LevelOutput& output) {
    if (output.castable || names_glb(output.out) || names_saved_world(output.out)) return false;
    return loaded.brushes || (loaded.saved && loaded.world.room_count() > 1);
}

void write_level(const World& world, const LoadedLevel& loaded, const LevelOutput& output, AtomicFile& file) {
    if (names_saved_world(output.out)) {
        const std::vector<std::byte> bytes = pack_world(world);
        return file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    if (names_glb(output.out)) {
        const GlbParts parts(world);
        judge_glb_size(parts.file_bytes(), output.out);
        return write_glb(world, parts, axis_option("--up", output.up),
                         [&](std::string_view bytes) { file.write(bytes); });
    }
    const auto put = [&](std::string_view text) {
        file.write(text);  // throws where that is not possible
        return true;
    };
    take(write_obj(world, put, leaves_out(loaded, output) ? ObjFaces::kSolid : ObjFaces::kAll));
}

void tell_if_empty(const LevelOutput& output, const World& world) {
    if (world.face_count() > 0 || names_saved_world(output.out)) return;
    std::fputs(
        fmt::format("firma: {}: the blasts left no face: {}\n",
                    is_standard_output(output.out) ? "standard output" : output.out,
                    names_glb(output.out) ? "its scene is empty" : "it holds none, and `firma check` will not take it")
            .c_str(),
        stderr);
}

}  // namespace firma::cli

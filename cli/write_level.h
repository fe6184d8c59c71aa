// SPDX-License-Identifier: MIT
// The level that `firma carve` and `firma log replay` write: .obj, .firma or .glb.
#pragma once

#include <string>

#include "cli/atomic_file.h"
#include "cli/load_level.h"
#include "firma/world.h"

namespace firma::cli {

struct LevelOutput {
    std::string out;
    std::string up;         ///< of a .glb, as typed
    bool castable = false;  ///< of an .obj of brushes: what is castable only, too
};

/// Adds -o, --castable and --up.
void add_level_output(Command& command, LevelOutput& output, const char* help, bool required);

/// @throws Failure for options that are not for what is written
void judge_level_output(const LevelOutput& output);
/// Once the name is known to be no input's. Whoever writes after.map expects a .map.
/// @throws Failure for an ending that is not written
void refuse_other_endings(const std::string& out);

bool names_glb(const std::string& path);

/// Whether an .obj is to have the solid alone: of brushes much is castable only by intent (glass, clips, liquids,
/// patches), and would leave the file open.
bool leaves_out(const LoadedLevel& loaded, const LevelOutput& output);

/// @param loaded  the level before
void write_level(const World& world, const LoadedLevel& loaded, const LevelOutput& output, AtomicFile& file);

/// Says so on stderr where an .obj without faces is what is left, which is no level to anyone who reads it.
void tell_if_empty(const LevelOutput& output, const World& world);

}  // namespace firma::cli

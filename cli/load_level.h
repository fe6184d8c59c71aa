// SPDX-License-Identifier: MIT
// The level that nearly every verb begins with: its arguments, and reading it into a world.
#pragma once

#include <string>

#include "cli/command.h"
#include "firma/level.h"
#include "firma/world.h"

namespace firma::cli {

struct LevelArguments {
    std::string path;
    std::string scale;  ///< as typed; empty for the format's own
};

/// Adds LEVEL (required unless told otherwise) and --scale.
void add_level_arguments(Command& command, LevelArguments& arguments, bool required = true);

ReadOptions read_options(const LevelArguments& arguments);

struct LoadedLevel {
    Level level;
    World world;
    double read_seconds = 0, build_seconds = 0;
};

/// @throws Failure with the reader's place and reason
LoadedLevel load_level(const LevelArguments& arguments, const WorldOptions& options = {});

/// The file's own name, without folders.
std::string short_name(const std::string& path);

}  // namespace firma::cli

// SPDX-License-Identifier: MIT
// Reads, builds, and keeps the time of both.
#include "cli/load_level.h"

#include <chrono>
#include <cmath>

#include "cli/failure.h"
#include "cli/numbers.h"

namespace firma::cli {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void add_level_arguments(Command& command, LevelArguments& arguments, bool required) {
    command.add_argument("LEVEL", arguments.path, "a Wavefront .obj, or a Quake 3 .bsp (version 46)", required);
    command.add_option("--scale", arguments.scale, "S",
                       "metres a unit of the file (default: 1 for .obj, 1/32 for .bsp)");
}

ReadOptions read_options(const LevelArguments& arguments) {
    ReadOptions options;
    if (arguments.scale.empty()) return options;
    options.scale = number_option("--scale", arguments.scale);
    if (options.scale <= 0) throw Failure("--scale", arguments.scale + " is not more than 0");
    return options;
}

LoadedLevel load_level(const LevelArguments& arguments, const WorldOptions& options) {
    LoadedLevel loaded;
    const auto start = std::chrono::steady_clock::now();
    loaded.level = take(read_level(arguments.path, read_options(arguments)));
    loaded.read_seconds = seconds_since(start);
    const auto read = std::chrono::steady_clock::now();
    loaded.world = take(make_world(loaded.level, options));
    loaded.build_seconds = seconds_since(read);
    return loaded;
}

std::string short_name(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

}  // namespace firma::cli

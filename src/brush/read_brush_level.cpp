// SPDX-License-Identifier: MIT
// Reads a level of brushes, or makes a world, by the file's ending.
#include <string_view>

#include "firma/brush_level.h"
#include "firma/brush_world.h"
#include "firma/save.h"
#include "level/read_file.h"

namespace firma {

Result<BrushLevel> read_brush_level(const std::string& path, const ReadOptions& options) {
    const Result<LevelFormat> format = level_format(path);
    if (!format) return format.error();
    if (format.value() == LevelFormat::kObj)
        return Error{ErrorCode::kUnsupported, path, "an .obj has no brushes: read_level() reads it"};
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    if (format.value() == LevelFormat::kMap) return read_map(bytes.value(), path, options);
    return read_bsp_brushes(std::as_bytes(std::span(bytes.value())), path, options);
}

Result<World> read_world(const std::string& path, const WorldOptions& options, const ReadOptions& read) {
    if (std::string_view(path).ends_with(".firma")) return load_world(path);
    const Result<LevelFormat> format = level_format(path);
    if (!format) return format.error();
    if (format.value() == LevelFormat::kObj) {
        const Result<Level> level = read_level(path, read);
        if (!level) return level.error();
        return make_world(level.value(), options);
    }
    const Result<BrushLevel> level = read_brush_level(path, read);
    if (!level) return level.error();
    return make_world(level.value(), options);
}

}  // namespace firma

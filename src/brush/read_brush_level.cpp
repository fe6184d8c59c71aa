// SPDX-License-Identifier: MIT
// Reads a level of brushes by its file's ending.
#include "firma/brush_level.h"
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

}  // namespace firma

// SPDX-License-Identifier: MIT
// Reads a level by its file's ending.
#include "firma/level.h"
#include "level/read_file.h"

namespace firma {

Result<Level> read_level(const std::string& path, const ReadOptions& options) {
    const Result<LevelFormat> format = level_format(path);
    if (!format) return format.error();
    if (format.value() == LevelFormat::kMap)
        return Error{ErrorCode::kUnsupported, path, "a .map is a level of brushes: read_brush_level() reads it"};
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    if (format.value() == LevelFormat::kBsp) return read_bsp(std::as_bytes(std::span(bytes.value())), path, options);
    return read_obj(bytes.value(), path, options);
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// Checks a mesh by its file's ending.
#include "firma/mesh.h"

#include "level/read_file.h"

namespace firma {

Result<MeshCheck> check_mesh(const std::string& path, const ReadOptions& options) {
    const Result<LevelFormat> format = level_format(path);
    if (!format) return format.error();
    if (format.value() == LevelFormat::kMap)
        return Error{ErrorCode::kUnsupported, path, "a .map has brushes, which are joined, rather than a mesh"};
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    if (format.value() == LevelFormat::kBsp) return check_bsp(std::as_bytes(std::span(bytes.value())), path, options);
    return check_obj(bytes.value(), path, options);
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// The bytes of a file, and what reads or checks them by its ending. By <cstdio>, as it says why something failed and
// exists wherever C does.
#include "level/read_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include "base/open_file.h"
#include "firma/level.h"
#include "firma/mesh.h"

namespace firma {
namespace {

/// No format goes beyond it, and a device that never ends is noticed.
constexpr std::uint64_t kLargestFile = std::uint64_t(1) << 32;

Error cannot_read(const std::string& path, int reason) {
    const std::string words = reason ? std::generic_category().message(reason) : "the read broke off";
    return {ErrorCode::kCannotRead, path, "cannot be read: " + words};
}

/// What is read, by what its name ends in: small letters.
struct Ending {
    std::string_view text;
    LevelFormat format;
};
constexpr Ending kEndings[] = {{".obj", LevelFormat::kObj}, {".map", LevelFormat::kMap}, {".bsp", LevelFormat::kBsp}};

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

Result<std::string> read_file(const std::string& path) {
    errno = 0;
    const std::unique_ptr<std::FILE, Closer> file(open_stream(path));
    if (!file) return cannot_read(path, errno);
    std::string bytes;
    for (std::size_t chunk = std::size_t(1) << 16;; chunk += chunk < (std::size_t(1) << 26) ? chunk : 0) {
        const std::size_t before = bytes.size();
        bytes.resize(before + chunk);
        errno = 0;
        const std::size_t count = std::fread(bytes.data() + before, 1, chunk, file.get());
        bytes.resize(before + count);
        if (bytes.size() > kLargestFile) return Error{ErrorCode::kTooLarge, path, "more than 4 GiB"};
        if (count == chunk) continue;
        if (std::ferror(file.get())) return cannot_read(path, errno);
        return bytes;
    }
}

Result<LevelFormat> level_format(const std::string& path) {
    const std::size_t point = path.find_last_of("./\\");
    std::string ending = point != std::string::npos && path[point] == '.' ? path.substr(point) : "";
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    for (const Ending& known : kEndings)
        if (ending == known.text) return known.format;
    if (ending == ".gltf" || ending == ".glb")
        return Error{ErrorCode::kUnsupported, path, "a glTF file: read_gltf() reads it (firma/read_gltf.h)"};
    return Error{ErrorCode::kUnsupported, path, "the name ends in none of " + level_endings()};
}

std::string level_endings() {
    std::string list;
    for (const Ending& known : kEndings) list.append(list.empty() ? "" : ", ").append(known.text);
    return list;
}

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

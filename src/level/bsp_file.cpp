// SPDX-License-Identifier: MIT
// Opens a .bsp: magic, version and directory are judged here, records are decoded here.
#include "level/bsp_file.h"

#include <bit>
#include <utility>

namespace firma {
namespace {

constexpr std::int32_t kVersion = 46;
constexpr std::size_t kDirectory = 8;  // bytes before it: magic and version
constexpr std::size_t kHeader = kDirectory + 8 * kBspLumps;

struct LumpKind {
    std::string_view name;
    std::size_t record;  // bytes
};

constexpr std::array<LumpKind, kBspLumps> kLumpKinds = {{
    {"entities", 1},
    {"shaders", BspShader::kBytes},
    {"planes", BspPlane::kBytes},
    {"nodes", 36},
    {"leafs", 48},
    {"leaf faces", 4},
    {"leaf brushes", 4},
    {"models", BspModel::kBytes},
    {"brushes", BspBrush::kBytes},
    {"brush sides", BspBrushSide::kBytes},
    {"vertices", BspVertex::kBytes},
    {"mesh vertices", BspMeshVertex::kBytes},
    {"effects", 72},
    {"faces", BspFace::kBytes},
    {"lightmaps", 128 * 128 * 3},
    {"light grid", 8},
    {"visibility", 1},
}};

std::uint32_t read_u32(const std::byte* at) {
    std::uint32_t value = 0;
    for (int k = 3; k >= 0; --k) value = value << 8 | std::to_integer<std::uint32_t>(at[k]);
    return value;
}

std::int32_t read_i32(const std::byte* at) {
    return std::int32_t(read_u32(at));
}

std::array<float, 3> read_floats(const std::byte* at) {
    return {std::bit_cast<float>(read_u32(at)), std::bit_cast<float>(read_u32(at + 4)),
            std::bit_cast<float>(read_u32(at + 8))};
}

std::string lump_place(const std::string& name, BspLump which) {
    const auto number = std::size_t(which);
    return name + ": lump " + std::to_string(number) + " (" + std::string(kLumpKinds[number].name) + ")";
}

// Relatives of the format are named: their users should not look for a broken file.
std::optional<Error> judge_magic(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.size() < kHeader) {
        return Error{
            ErrorCode::kMalformed, name,
            "ends within the header: " + std::to_string(bytes.size()) + " of " + std::to_string(kHeader) + " bytes"};
    }
    std::string magic(4, ' ');
    for (std::size_t k = 0; k < 4; ++k) magic[k] = std::to_integer<char>(bytes[k]);
    for (const std::string_view relative : {"RBSP", "FBSP", "VBSP"}) {
        if (magic == relative)
            return Error{ErrorCode::kUnsupported, name,
                         "is of kind " + magic + "; only IBSP version 46 (Quake 3) is read"};
    }
    if (magic != "IBSP")
        return Error{ErrorCode::kMalformed, name, "is no .bsp of Quake 3: it does not begin with IBSP"};
    const std::int32_t version = read_i32(bytes.data() + 4);
    if (version != kVersion) {
        return Error{ErrorCode::kUnsupported, name,
                     "is IBSP version " + std::to_string(version) + "; only version 46 (Quake 3) is read"};
    }
    return std::nullopt;
}

}  // namespace

BspShader BspShader::read(const std::byte* at) {
    std::size_t length = 0;
    while (length < 64 && at[length] != std::byte{0}) ++length;
    // Looking at bytes as char is what the language allows.
    return {std::string_view(reinterpret_cast<const char*>(at), length), read_i32(at + 64), read_i32(at + 68)};
}

BspModel BspModel::read(const std::byte* at) {
    return {read_i32(at + 24), read_i32(at + 28), read_i32(at + 32), read_i32(at + 36)};
}

BspPlane BspPlane::read(const std::byte* at) {
    return {read_floats(at), std::bit_cast<float>(read_u32(at + 12))};
}

BspBrush BspBrush::read(const std::byte* at) {
    return {read_i32(at), read_i32(at + 4), read_i32(at + 8)};
}

BspBrushSide BspBrushSide::read(const std::byte* at) {
    return {read_i32(at), read_i32(at + 4)};
}

// Between position and normal: texture and lightmap coordinates.
BspVertex BspVertex::read(const std::byte* at) {
    const auto [u, v, lightmap_u] = read_floats(at + 12);
    return {read_floats(at), {u, v}, read_floats(at + 28)};
}

BspMeshVertex BspMeshVertex::read(const std::byte* at) {
    return {read_i32(at)};
}

// Left out: effect, and what places the lightmap.
BspFace BspFace::read(const std::byte* at) {
    BspFace face;
    face.shader = read_i32(at);
    face.type = read_i32(at + 8);
    face.first_vertex = read_i32(at + 12);
    face.vertex_count = read_i32(at + 16);
    face.first_mesh_vertex = read_i32(at + 20);
    face.mesh_vertex_count = read_i32(at + 24);
    face.normal = read_floats(at + 84);
    face.patch_width = read_i32(at + 96);
    face.patch_height = read_i32(at + 100);
    return face;
}

Error BspFile::fault(ErrorCode code, BspLump which, std::string reason) const {
    return {code, lump_place(name_, which), std::move(reason)};
}

Error BspFile::fault(ErrorCode code, BspLump which, std::size_t entry, std::string reason) const {
    return {code, lump_place(name_, which) + ", entry " + std::to_string(entry), std::move(reason)};
}

std::optional<std::string> bad_range(std::string_view things, std::int32_t first, std::int32_t count,
                                     std::size_t size) {
    if (count == 0) return std::nullopt;
    if (count < 0) return std::to_string(count) + " " + std::string(things);
    if (first >= 0 && std::size_t(first) <= size && std::size_t(count) <= size - std::size_t(first))
        return std::nullopt;
    return std::to_string(count) + " " + std::string(things) + " from number " + std::to_string(first) + " on, of " +
           std::to_string(size);
}

Result<BspFile> BspFile::open(std::span<const std::byte> bytes, std::string name) {
    if (std::optional<Error> error = judge_magic(bytes, name)) return *std::move(error);
    BspFile file;
    file.name_ = std::move(name);
    for (std::size_t k = 0; k < kBspLumps; ++k) {
        const auto which = BspLump(k);
        const std::int32_t offset = read_i32(bytes.data() + kDirectory + 8 * k);
        const std::int32_t length = read_i32(bytes.data() + kDirectory + 8 * k + 4);
        if (const auto bad = bad_range("bytes", offset, length, bytes.size())) {
            return file.fault(ErrorCode::kMalformed, which, *bad);
        }
        if (std::size_t(length) % kLumpKinds[k].record != 0) {
            return file.fault(
                ErrorCode::kMalformed, which,
                std::to_string(length) + " bytes are not whole records of " + std::to_string(kLumpKinds[k].record));
        }
        if (length != 0) file.lumps_[k] = bytes.subspan(std::size_t(offset), std::size_t(length));
    }
    return file;
}

}  // namespace firma

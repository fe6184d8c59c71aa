// SPDX-License-Identifier: MIT
// The lumps of a Quake 3 .bsp (version 46): checked, typed views on the file's bytes.
//
// Bytes are read one by one, little end first: nothing is cast, aligned or assumed of the machine.
// Source: id Software, Quake III Arena source code, 2005, code/qcommon/qfiles.h (dheader_t and what follows).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "firma/result.h"

namespace firma {

/// What the seventeen entries of the directory hold, in the file's order.
enum class BspLump : std::uint8_t {
    kEntities,
    kShaders,
    kPlanes,
    kNodes,
    kLeafs,
    kLeafFaces,
    kLeafBrushes,
    kModels,
    kBrushes,
    kBrushSides,
    kVertices,
    kMeshVertices,
    kEffects,
    kFaces,
    kLightmaps,
    kLightGrid,
    kVisibility,
};
inline constexpr std::size_t kBspLumps = 17;

/// A name as the engine reads it: up to the first NUL, or all 64 bytes.
struct BspShader {
    static constexpr BspLump kLump = BspLump::kShaders;
    static constexpr std::size_t kBytes = 72;

    std::string_view name;  ///< in the file's bytes
    std::int32_t surface_flags = 0;
    std::int32_t content_flags = 0;

    static BspShader read(const std::byte* at);
};

/// Number 0 is the world; the others are doors and movers.
struct BspModel {
    static constexpr BspLump kLump = BspLump::kModels;
    static constexpr std::size_t kBytes = 40;

    std::int32_t first_face = 0;
    std::int32_t face_count = 0;
    std::int32_t first_brush = 0;
    std::int32_t brush_count = 0;

    static BspModel read(const std::byte* at);
};

/// In front of it, where normal . p > distance, lies the outside of a brush.
struct BspPlane {
    static constexpr BspLump kLump = BspLump::kPlanes;
    static constexpr std::size_t kBytes = 16;

    std::array<float, 3> normal{};
    float distance = 0;

    static BspPlane read(const std::byte* at);
};

struct BspBrush {
    static constexpr BspLump kLump = BspLump::kBrushes;
    static constexpr std::size_t kBytes = 12;

    std::int32_t first_side = 0;
    std::int32_t side_count = 0;
    std::int32_t shader = 0;  ///< what its contents are

    static BspBrush read(const std::byte* at);
};

struct BspBrushSide {
    static constexpr BspLump kLump = BspLump::kBrushSides;
    static constexpr std::size_t kBytes = 8;

    std::int32_t plane = 0;
    std::int32_t shader = 0;

    static BspBrushSide read(const std::byte* at);
};

struct BspVertex {
    static constexpr BspLump kLump = BspLump::kVertices;
    static constexpr std::size_t kBytes = 44;

    std::array<float, 3> position{};
    std::array<float, 2> uv{};  ///< of the texture, in repeats
    std::array<float, 3> normal{};

    static BspVertex read(const std::byte* at);
};

/// A corner of a triangle: counted from its face's first vertex.
struct BspMeshVertex {
    static constexpr BspLump kLump = BspLump::kMeshVertices;
    static constexpr std::size_t kBytes = 4;

    std::int32_t vertex = 0;

    static BspMeshVertex read(const std::byte* at);
};

/// A drawn surface.
struct BspFace {
    static constexpr BspLump kLump = BspLump::kFaces;
    static constexpr std::size_t kBytes = 104;
    static constexpr std::int32_t kPlanar = 1, kPatch = 2, kSoup = 3, kFlare = 4;

    std::int32_t shader = 0;
    std::int32_t type = 0;
    std::int32_t first_vertex = 0;
    std::int32_t vertex_count = 0;
    std::int32_t first_mesh_vertex = 0;
    std::int32_t mesh_vertex_count = 0;
    std::array<float, 3> normal{};  ///< of a planar face
    std::int32_t patch_width = 0;   ///< control points of a patch
    std::int32_t patch_height = 0;

    static BspFace read(const std::byte* at);
};

/// The records of one lump, each decoded when asked for.
template <class Record>
class BspRecords {
public:
    explicit BspRecords(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::size_t size() const { return bytes_.size() / Record::kBytes; }
    Record operator[](std::size_t entry) const { return Record::read(bytes_.data() + entry * Record::kBytes); }

private:
    std::span<const std::byte> bytes_;
};

/// A file whose directory is sound: every lump lies within the file and holds whole records. The bytes stay the
/// caller's.
class BspFile {
public:
    /// @return kMalformed for what is no .bsp or has a bad directory; kUnsupported for a relative of the format, naming
    /// it
    static Result<BspFile> open(std::span<const std::byte> bytes, std::string name);

    std::span<const std::byte> lump(BspLump which) const { return lumps_[std::size_t(which)]; }

    template <class Record>
    BspRecords<Record> records() const {
        return BspRecords<Record>(lump(Record::kLump));
    }

    const std::string& name() const { return name_; }

    /// An error at an entry of a lump: "map.bsp: lump 13 (faces), entry 17".
    Error fault(ErrorCode code, BspLump which, std::size_t entry, std::string reason) const;
    /// An error of a lump as a whole.
    Error fault(ErrorCode code, BspLump which, std::string reason) const;

private:
    std::string name_;
    std::array<std::span<const std::byte>, kBspLumps> lumps_;
};

/// What is wrong with the range first .. first + count of things of which there are `size`, as
/// "3 vertices from number 10 on, of 12"; nothing when it lies within. An empty range lies anywhere.
std::optional<std::string> bad_range(std::string_view things, std::int32_t first, std::int32_t count, std::size_t size);

}  // namespace firma

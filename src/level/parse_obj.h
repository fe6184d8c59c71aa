// SPDX-License-Identifier: MIT
// Reads the entries of an .obj and hands them on: what every reader of the format shares, errors included.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "firma/level.h"
#include "firma/result.h"

namespace firma {

struct ObjVertex {
    std::array<std::string_view, 3> text;  ///< x, y, z as the file has them
    Vec3 position;                         ///< nearest doubles, in the file's units
    Vec3 metres;                           ///< position, scaled
    std::uint32_t line = 0;
};

struct ObjFace {
    /// Vertices, from 0 [3 <= count <= kMaxOutlineCorners]; all have been handed on before.
    std::span<const std::uint32_t> corners;
    /// Of each corner, in repeats, v down; none where a corner has none.
    std::span<const TexturePoint> uvs;
    std::uint32_t source = 0;  ///< index of the face in the file, from 0
    std::uint32_t line = 0;
};

/// What a file is handed to.
class ObjVisitor {
public:
    /// A coordinate of the next vertex, as the file has it.
    /// @return an error to stop with
    virtual std::optional<Error> number(std::string_view /*word*/, std::size_t /*axis*/, std::uint32_t /*line*/) {
        return std::nullopt;
    }
    /// @return false when the vertex lies outside the world: parse_obj() then says so
    virtual bool vertex(const ObjVertex& vertex) = 0;
    /// @return an error to stop with
    virtual std::optional<Error> face(const ObjFace& face) = 0;
    virtual void material(std::string_view /*name*/) {}
    virtual void group(std::string_view /*name*/) {}

protected:
    ~ObjVisitor() = default;
};

struct ObjCounts {
    std::uint32_t faces = 0;
    std::uint64_t ignored_entries = 0;
    std::vector<Omission> omissions;  ///< of those the ones that have a shape: points, lines, curves, surfaces, calls
};

/// Reads a whole file, in order, up to its end or the first error. A face may name only vertices that come before it.
/// @return kMalformed, kOutOfRange or kTooLarge with name and line; kInvalid for a scale that is not finite or negative
Result<ObjCounts> parse_obj(std::string_view text, std::string_view name, const ReadOptions& options,
                            ObjVisitor& visitor);

}  // namespace firma

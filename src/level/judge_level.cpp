// SPDX-License-Identifier: MIT
// Looks at every face of a level.
#include "level/judge_level.h"

#include "firma/polygon.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

/// "its material 7 is none of 2"
std::string missing(const char* what, std::size_t index, std::size_t count) {
    return std::string("its ") + what + " " + std::to_string(index) + " is not there: there are " +
           std::to_string(count);
}

/// Why a face cannot be used; empty when it can.
std::string fault_of(const Level& level, const LevelFace& face) {
    if (face.corner_count < 3 || face.corner_count > std::uint32_t(kMaxCorners))
        return "it does not have 3 to 64 corners";
    if (std::size_t(face.first_corner) + face.corner_count > level.corners.size()) return "its corners are not there";
    if (face.material >= name_count(level.materials))
        return missing("material", face.material, name_count(level.materials));
    if (face.group >= name_count(level.groups)) return missing("group", face.group, name_count(level.groups));
    if (face.texture != kNoTexture && face.texture >= level.textures.size())
        return missing("texture", face.texture, level.textures.size());
    Vec3 corners[kMaxCorners];
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
        const std::uint32_t vertex = level.corners[face.first_corner + c];
        if (vertex >= level.vertices.size()) return "a corner names no vertex";
        corners[c] = to_metres(level.vertices[vertex]);
    }
    if (check_polygon({corners, face.corner_count}) != PolygonFault::kNone)
        return "it is not convex and planar, with area";
    return "";
}

}  // namespace

std::optional<Error> judge_textures(std::span<const TextureProjection> textures, const std::string& name,
                                    const std::string& what) {
    for (std::size_t k = 0; k < textures.size(); ++k) {
        if (is_usable(textures[k])) continue;
        const std::string place = what + "texture " + std::to_string(k);
        return Error{ErrorCode::kInvalid, name.empty() ? place : name + ": " + place,
                     "its numbers are not finite, or too large"};
    }
    return std::nullopt;
}

std::optional<Error> judge_level(const Level& level, const std::string& name, const std::string& what) {
    if (level.faces.size() >= (1u << 31) || level.corners.size() > 0xFFFFFFFFu)
        return Error{ErrorCode::kTooLarge, name, "a world holds fewer than 2^31 faces"};
    if (auto error = judge_textures(level.textures, name, what)) return error;
    for (const LevelFace& face : level.faces) {
        std::string reason = fault_of(level, face);
        if (reason.empty()) continue;
        const std::string place = what + "face " + std::to_string(face.source);
        return Error{ErrorCode::kInvalid, name.empty() ? place : name + ": " + place, std::move(reason)};
    }
    return std::nullopt;
}

}  // namespace firma

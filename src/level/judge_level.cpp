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

/// Whether three points are surely not on one line: of products that wrap around, what differs does differ.
bool have_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    std::uint64_t u[3], v[3];
    for (int axis = 0; axis < 3; ++axis) {
        u[axis] = std::uint64_t(std::int64_t(b[axis]) - a[axis]);
        v[axis] = std::uint64_t(std::int64_t(c[axis]) - a[axis]);
    }
    return u[1] * v[2] != u[2] * v[1] || u[2] * v[0] != u[0] * v[2] || u[0] * v[1] != u[1] * v[0];
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
    const std::uint32_t* const numbers = level.corners.data() + face.first_corner;
    for (std::uint32_t c = 0; c < face.corner_count; ++c)
        if (numbers[c] >= level.vertices.size()) return "a corner names no vertex";
    const auto corner = [&](std::uint32_t c) -> const GridPoint& { return level.vertices[numbers[c]]; };
    if (face.corner_count == 3 && have_area(corner(0), corner(1), corner(2))) return "";
    Vec3 corners[kMaxCorners];
    for (std::uint32_t c = 0; c < face.corner_count; ++c) corners[c] = to_metres(corner(c));
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

// SPDX-License-Identifier: MIT
// From a level to a world: one room, its faces in a tree.
#include <cmath>
#include <string>

#include "firma/level.h"
#include "firma/world.h"
#include "geometry/polygon_shape.h"
#include "level/find_solids.h"
#include "solid/append_faces.h"
#include "solid/solid_data.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

Error face_error(const Level& level, std::size_t face, const char* reason) {
    const std::string which = "face " + std::to_string(level.faces[face].source);
    return {ErrorCode::kInvalid, level.name.empty() ? which : level.name + ": " + which, reason};
}

/// Why a face cannot enter a world, or null.
const char* refusal(const Level& level, const LevelFace& face) {
    if (face.corner_count < 3 || face.corner_count > std::uint32_t(kMaxCorners))
        return "it does not have 3 to 64 corners";
    if (std::size_t(face.first_corner) + face.corner_count > level.corners.size()) return "its corners are not there";
    Vec3 corners[kMaxCorners];
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
        const std::uint32_t vertex = level.corners[face.first_corner + c];
        if (vertex >= level.vertices.size()) return "a corner names no vertex";
        corners[c] = to_metres(level.vertices[vertex]);
    }
    if (check_polygon({corners, face.corner_count}) != PolygonFault::kNone)
        return "it is not convex and planar, with area";
    return nullptr;
}

FaceSet face_set(const Level& level, const LevelSolids& solids) {
    FaceSet set;
    set.vertices = level.vertices;
    set.corners = level.corners;
    set.faces.reserve(level.faces.size());
    for (std::uint32_t k = 0; k < level.faces.size(); ++k) {
        const LevelFace& face = level.faces[k];
        set.faces.push_back({.id = {k},
                             .source = face.source,
                             .material = face.material,
                             .mask = face.mask,
                             .first_corner = face.first_corner,
                             .corner_count = face.corner_count,
                             .two_sided = face.two_sided,
                             .solid = solids.solid[k]});
    }
    for (const auto& [face, exact] : solids.stored) {
        set.faces[face].owner = exact.get();
        set.owners.emplace_back(exact.get());
    }
    return set;
}

/// Why a level cannot enter a world or a solid.
std::optional<Error> refusal(const Level& level) {
    if (level.faces.size() >= (1u << 31) || level.corners.size() > 0xFFFFFFFFu)
        return Error{ErrorCode::kTooLarge, level.name, "a world holds fewer than 2^31 faces"};
    for (std::size_t k = 0; k < level.faces.size(); ++k)
        if (const char* reason = refusal(level, level.faces[k])) return face_error(level, k, reason);
    return {};
}

}  // namespace

Result<Solid> make_solid(const Level& level, const TreeOptions& tree) {
    if (std::optional<Error> error = refusal(level)) return *error;
    const LevelSolids solids = find_solids(level);
    const FaceSet all = face_set(level, solids);
    FaceSet faces;
    faces.owners = all.owners;
    for (const FaceSet::Entry& face : all.faces)
        if (face.solid) append_face(all, face, faces);
    return solid_of(build_store(faces, tree).store, solids.rock_outside, std::uint32_t(all.faces.size()), 0, tree);
}

Result<World> make_world(const Level& level, const WorldOptions& options) {
    if (const double skin = options.tolerance.skin; !(skin >= 0) || !is_finite(skin))
        return Error{ErrorCode::kInvalid, level.name, "the skin must be a finite number, not below zero"};
    if (std::optional<Error> error = refusal(level)) return *error;
    const LevelSolids solids = find_solids(level);
    WorldParts parts;
    parts.name = level.name;
    parts.rooms.push_back({face_set(level, solids), {}, false});
    parts.materials = level.materials;
    parts.rock_outside = solids.rock_outside;
    parts.options = options;
    return assemble_world(std::move(parts));
}

}  // namespace firma

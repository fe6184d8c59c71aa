// SPDX-License-Identifier: MIT
// From a level to a world: one room, its faces in a tree.
#include <algorithm>

#include "firma/level.h"
#include "firma/world.h"
#include "level/find_solids.h"
#include "level/judge_level.h"
#include "level/level_matters.h"
#include "level/level_textures.h"
#include "level/message.h"
#include "solid/append_faces.h"
#include "solid/solid_data.h"
#include "world/assemble_world.h"
#include "world/judge_options.h"

namespace firma {
namespace {

/// What find_solids() says but for its notes: of faces that are all two-sided none bounds a solid.
LevelSolids solids_of(const Level& level) {
    const auto two_sided = [](const LevelFace& face) { return face.two_sided; };
    if (!std::all_of(level.faces.begin(), level.faces.end(), two_sided)) return find_solids(level);
    LevelSolids none;
    none.solid.resize(level.faces.size());
    return none;
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

}  // namespace

Result<Solid> make_solid(const Level& level, const TreeOptions& tree) {
    if (auto error = judge_level(level, level.name)) return *std::move(error);
    if (level.faces.empty()) return nothing_left(level.name, "", level.omissions);
    const LevelSolids solids = find_solids(level);
    const FaceSet all = face_set(level, solids);
    FaceSet faces;
    faces.owners = all.owners;
    for (const FaceSet::Entry& face : all.faces)
        if (face.solid) append_face(all, face, faces);
    return solid_of(build_store(faces, tree).store, solids.rock_outside, std::uint32_t(all.faces.size()), 0, tree);
}

Result<World> make_world(const Level& level, const WorldOptions& options) {
    if (auto error = judge_level(level, level.name)) return *std::move(error);
    if (auto error = judge_options(options, level.name)) return *std::move(error);
    if (level.faces.empty()) return nothing_left(level.name, "", level.omissions);
    WorldParts parts;
    std::optional<LongWork> work;  // finding what is solid counts once, what stands in face_store.h three times
    if (LongWork::asked(options.work)) parts.work = &work.emplace(options.work, 4 * level.faces.size());
    const LevelSolids solids = solids_of(level);
    if (work) work->add(level.faces.size());
    if (work && work->stopped()) return *stopped(*work, level.name);
    parts.name = level.name;
    parts.rooms.push_back({face_set(level, solids), {}, false});
    parts.materials = level.materials;
    if (parts.materials.empty()) parts.materials.emplace_back();  // what a cut names comes behind it
    parts.rock_outside = solids.rock_outside;
    parts.options = options;
    parts.textures = textures_of(level);
    parts.matters = matters_of_level(level, solids, options.matters ? *options.matters : default_matters());
    return assemble_world(std::move(parts));
}

}  // namespace firma

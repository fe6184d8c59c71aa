// SPDX-License-Identifier: MIT
// Checks a level read from glTF by what it came to on the grid.

#include "firma/read_gltf.h"
#include "level/check_mesh_core.h"
#include "level/judge_level.h"

namespace firma {
namespace {

ExactMesh snapped_mesh(const Level& level) {
    ExactMesh mesh;
    mesh.base = 2;
    mesh.snapped = level.vertices;
    for (const GridPoint& point : level.vertices) {
        const Vec3 p = to_metres(point);
        mesh.nearest.push_back(p);
        mesh.exact.push_back({exact_binary(p.x), exact_binary(p.y), exact_binary(p.z)});
    }
    // Those of faces alone: nobody has judged others.
    for (const LevelFace& face : level.faces) {
        mesh.faces.push_back({std::uint32_t(mesh.corners.size()), face.corner_count, face.source, 0});
        const auto first = level.corners.begin() + std::ptrdiff_t(face.first_corner);
        mesh.corners.insert(mesh.corners.end(), first, first + std::ptrdiff_t(face.corner_count));
    }
    return mesh;
}

}  // namespace

Result<MeshCheck> check_gltf(const GltfLevel& gltf) {
    const std::string& name = gltf.level.name;
    if (auto error = judge_level(gltf.level, name)) return *std::move(error);
    if (gltf.note_places.size() != gltf.level.notes.size())
        return Error{ErrorCode::kInvalid, name,
                     "there are " + std::to_string(gltf.level.notes.size()) + " notes, and places for " +
                         std::to_string(gltf.note_places.size())};
    std::uint64_t corners = 0;
    for (const LevelFace& face : gltf.level.faces) corners += face.corner_count;
    if (corners > 0xFFFFFFFFu) return Error{ErrorCode::kTooLarge, name, "its faces have more than 2^32 - 1 corners"};
    MeshCheck check = check_exact_mesh(snapped_mesh(gltf.level));
    check.faces = gltf.level.source_faces;  // not the pieces that they were judged in
    check.notes.clear();                    // of the level's faces, which are flat and convex by now
    for (std::size_t k = 0; k < gltf.level.notes.size(); ++k) {
        const LevelNote& note = gltf.level.notes[k];
        check.notes.push_back({note.what == FaceNote::kNoArea ? MeshNote::kDropped : MeshNote::kDivided, note.source, 0,
                               gltf.note_places[k]});
    }
    return check;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// Checks a level read from glTF by what it came to on the grid.

#include "firma/read_gltf.h"
#include "level/check_mesh_core.h"

namespace firma {
namespace {

ExactMesh snapped_mesh(const Level& level) {
    ExactMesh mesh;
    mesh.base = 2;
    mesh.snapped = level.vertices;
    mesh.corners = level.corners;
    for (const GridPoint& point : level.vertices) {
        const Vec3 p = to_metres(point);
        mesh.nearest.push_back(p);
        mesh.exact.push_back({exact_binary(p.x), exact_binary(p.y), exact_binary(p.z)});
    }
    for (const LevelFace& face : level.faces)
        mesh.faces.push_back({face.first_corner, face.corner_count, face.source, 0});
    return mesh;
}

}  // namespace

MeshCheck check_gltf(const GltfLevel& gltf) {
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

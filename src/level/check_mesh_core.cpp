// SPDX-License-Identifier: MIT
// Checks a mesh whose positions are known exactly.
#include "level/check_mesh_core.h"

#include "level/check_mesh_parts.h"
#include "level/weld_positions.h"

namespace firma {

MeshCheck check_exact_mesh(const ExactMesh& mesh) {
    const WeldedPositions welded = weld_positions(mesh);
    MeshCheck check;
    check.faces = std::uint32_t(mesh.faces.size());
    check.vertices = welded.size();
    check.faults = check_edges(mesh, welded);
    check.notes = check_faces(mesh, welded);
    return check;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// What becomes of each face of a mesh once it is snapped.
#pragma once

#include <vector>

#include "level/weld_positions.h"

namespace firma {

/// Notes in order of face; a face has at most one on its shape, and one that it is turned.
std::vector<MeshNotePlace> check_faces(const ExactMesh& mesh, const WeldedPositions& welded);

}  // namespace firma

// SPDX-License-Identifier: MIT
// The parts of check_exact_mesh(): whether each edge is used as often one way as the other, and what becomes of each
// face once it is snapped.
#pragma once

#include <vector>

#include "level/weld_positions.h"

namespace firma {

/// The faults of a mesh, in order of face; of a face first that it is reversed, then its open edges in order of corner.
///
/// A face is called reversed when it and a neighbour use an edge the same way, the two alone: of all faces that hang
/// together by edges of two faces, the fewer are to blame (of two halves the one without the first face). Then edges
/// are counted as if those faces were turned over. Of an edge with too many sides one way the last ones in the file are
/// called open.
std::vector<MeshFaultPlace> check_edges(const ExactMesh& mesh, const WeldedPositions& welded);

/// Notes in order of face; a face has at most one on its shape, and one that it is turned.
std::vector<MeshNotePlace> check_faces(const ExactMesh& mesh, const WeldedPositions& welded);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Checks a mesh whose positions are known exactly: the part of check_mesh() that no format matters to.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/grid.h"
#include "firma/mesh.h"
#include "level/exact_number.h"

namespace firma {

/// What a reader hands over. The three lists of vertices go in step.
struct ExactMesh {
    struct Face {
        std::uint32_t first_corner = 0;
        std::uint32_t corner_count = 0;
        std::uint32_t source = 0;  ///< index in the file; several faces in a row may share one
        std::uint32_t line = 0;
    };

    int base = 10;                                  ///< of the exact numbers: 10, or 2 for a format of floats
    std::vector<std::array<ExactNumber, 3>> exact;  ///< of a vertex of the file, in the file's units
    std::vector<Vec3> nearest;                      ///< the same, as doubles
    std::vector<GridPoint> snapped;                 ///< the same, scaled and snapped
    std::vector<std::string> long_digits;           ///< ExactDecimals::take_long_digits()
    std::vector<std::uint32_t> corners;             ///< of faces, indices of vertices
    std::vector<Face> faces;                        ///< in order of source
};

/// Faults are judged by the exact positions alone, notes by comparing them with the snapped ones.
/// Time grows as n log n with the corners of the mesh.
MeshCheck check_exact_mesh(const ExactMesh& mesh);

}  // namespace firma

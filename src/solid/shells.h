// SPDX-License-Identifier: MIT
// BoundaryShells: the closed pieces that a boundary falls into, by edges that faces share. One that looks outward
// bounds a body, one that looks inward a hollow, or rock around air.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/double_double.h"
#include "solid/boundary.h"

namespace firma {

struct BoundaryShells {
    std::vector<std::uint32_t> of_face;             ///< the shell of each face of the patch
    std::vector<std::vector<std::uint32_t>> faces;  ///< of each shell, ascending; shells in order of their first
    std::vector<GridBox> boxes;                     ///< of each
    std::vector<DoubleDouble> volumes;              ///< of each, cubic input steps: below 0 for one that looks inward
};

/// Costs all faces and their edges.
BoundaryShells find_shells(const Boundary& boundary);

}  // namespace firma

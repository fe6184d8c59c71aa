// SPDX-License-Identifier: MIT
// BoundaryShells: the closed pieces that a boundary falls into, by edges that faces share. One that looks outward
// bounds a body, one that looks inward a hollow, or rock around air.
#pragma once

#include <cstdint>
#include <vector>

#include "solid/boundary.h"
#include "solid/moment_sum.h"

namespace firma {

struct BoundaryShells {
    std::vector<std::uint32_t> of_face;             ///< the shell of each face of the patch
    std::vector<std::vector<std::uint32_t>> faces;  ///< of each shell, ascending; shells in order of their first
    std::vector<GridBox> boxes;                     ///< of each
    std::vector<DoubleDouble> volumes;              ///< of each, cubic input steps: below 0 for one that looks inward
};

/// Costs all faces and their edges.
BoundaryShells find_shells(const Boundary& boundary);

/// Adds a face of a patch to a sum.
inline void add_face(const SolidPatch& patch, const PatchFace& face, MomentSum& sum) {
    const auto uses = patch.uses(face);
    sum.add_face(face.plane->plane, patch.ends(face),
                 [&](std::uint32_t k) -> const ExactPoint& { return patch.vertices[patch.from(uses[k])].point; });
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// The closed pieces that a boundary falls into.
#include "solid/shells.h"

#include "base/disjoint_sets.h"
#include "solid/measure_boundary.h"
#include "solid/moment_sum.h"

namespace firma {

BoundaryShells find_shells(const Boundary& boundary) {
    const SolidPatch& patch = boundary.patch;
    DisjointSets joined(patch.faces.size());
    for (const PatchEdge& edge : patch.edges)
        if (edge.face[0] != ~0u && edge.face[1] != ~0u) joined.join(edge.face[0], edge.face[1]);
    BoundaryShells shells;
    shells.of_face.resize(patch.faces.size());
    for (std::uint32_t face = 0; face < patch.faces.size(); ++face) {
        const std::uint32_t root = joined.find(face);  // the lowest: comes first
        if (root == face) {
            shells.of_face[face] = std::uint32_t(shells.faces.size());
            shells.faces.emplace_back();
            shells.boxes.emplace_back();
        }
        const std::uint32_t shell = shells.of_face[face] = shells.of_face[root];
        shells.faces[shell].push_back(face);
        shells.boxes[shell].add(patch.faces[face].box);
    }
    for (std::size_t shell = 0; shell < shells.faces.size(); ++shell) {
        MomentSum sum(middle_of(shells.boxes[shell]));
        for (const std::uint32_t number : shells.faces[shell]) {
            const PatchFace& face = patch.faces[number];
            const auto uses = patch.uses(face);
            const auto arm = [&](std::uint32_t k) {
                return arm_of(patch.vertices[patch.from(uses[k])].point, sum.apex());
            };
            sum.add_volume(face.plane->plane, patch.ends(face), arm);
        }
        shells.volumes.push_back(sum.sums().volume);
    }
    return shells;
}

}  // namespace firma

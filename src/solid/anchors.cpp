// SPDX-License-Identifier: MIT
// What hangs free in a solid.
#include "solid/anchors.h"

#include <iterator>

#include "solid/shells.h"

namespace firma {

std::vector<std::uint64_t> find_hanging(const Node* root) {
    const Boundary boundary = take_boundary(root);
    const BoundaryShells shells = find_shells(boundary);
    std::vector<std::uint64_t> hanging, others, alone;
    for (std::uint32_t face = 0; face < boundary.patch.faces.size(); ++face) {
        const bool hangs = shells.volumes[shells.of_face[face]].high > 0;
        (hangs ? hanging : others).push_back(Anchors::key_of(boundary.patch.faces[face].facet.record()));
    }
    for (std::vector<std::uint64_t>* keys : {&hanging, &others}) {
        std::sort(keys->begin(), keys->end());
        keys->erase(std::unique(keys->begin(), keys->end()), keys->end());
    }
    std::set_difference(hanging.begin(), hanging.end(), others.begin(), others.end(), std::back_inserter(alone));
    return alone;
}

}  // namespace firma

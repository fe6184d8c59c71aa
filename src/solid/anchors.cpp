// SPDX-License-Identifier: MIT
// What hangs free in a solid.
#include "solid/anchors.h"

#include <iterator>

#include "solid/shells.h"

namespace firma {

std::vector<std::uint64_t> find_hanging(const Node* root, std::uint32_t edit) {
    const Boundary boundary = take_boundary(root);
    const SolidPatch& patch = boundary.patch;
    BoundaryShells shells = find_shells(boundary);
    for (std::uint32_t face = 0; face < patch.faces.size(); ++face) {
        bool held = edit != 0 && patch.faces[face].facet.record().edit != edit;
        for (const PatchUse& use : patch.uses(patch.faces[face]))
            held |= patch.edges[use.edge].face[!use.reversed] == ~0u;
        if (held) shells.volumes[shells.of_face[face]] = {};
    }
    std::vector<std::uint64_t> hanging, others, alone;
    for (std::uint32_t face = 0; face < patch.faces.size(); ++face) {
        const bool hangs = shells.volumes[shells.of_face[face]].high > 0;
        (hangs ? hanging : others).push_back(Anchors::key_of(patch.faces[face].facet.record()));
    }
    for (std::vector<std::uint64_t>* keys : {&hanging, &others}) {
        std::sort(keys->begin(), keys->end());
        keys->erase(std::unique(keys->begin(), keys->end()), keys->end());
    }
    std::set_difference(hanging.begin(), hanging.end(), others.begin(), others.end(), std::back_inserter(alone));
    return alone;
}

}  // namespace firma

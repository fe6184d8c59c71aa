// SPDX-License-Identifier: MIT
// The whole boundary of the solid in some blocks: every face that is marked as bounding it.
#include "solid/boundary.h"

#include "tree/visit.h"

namespace firma {

Boundary take_boundary(std::span<const Block* const> roots) {
    Boundary boundary;
    std::vector<FacetPlace> found;
    std::vector<std::uint32_t> face_of;
    std::size_t solid = 0;
    for (const Block* root : roots) {
        if (!root) continue;
        for_each_face_block(*root, [&](const Block& block) {
            for (const FaceRecord& face : block.faces) solid += face.solid;
        });
    }
    found.reserve(solid);
    face_of.reserve(solid);
    boundary.patch.reserve(solid);
    for (const Block* root : roots) {
        if (!root) continue;
        for_each_face_block(*root, [&](const Block& block) {
            for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) {
                if (!block.faces[slot].solid) continue;
                found.push_back({&block, slot});
                face_of.push_back(boundary.patch.add(found.back()));
            }
        });
    }
    std::vector<std::uint32_t>& first = boundary.first_facet;
    first.assign(boundary.patch.faces.size() + 1, 0);
    for (const std::uint32_t face : face_of) ++first[face + 1];
    for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    boundary.facets.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) boundary.facets[next[face_of[k]]++] = found[k];
    return boundary;
}

}  // namespace firma

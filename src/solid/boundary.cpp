// SPDX-License-Identifier: MIT
// The whole boundary of a solid.
#include "solid/boundary.h"

#include <utility>

#include "base/sort.h"

namespace firma {

Boundary take_boundary(const Node* root) {
    std::vector<FacetPlace> found;
    if (root) {
        found.reserve(root->facets_below);
        for_each_block(*root, [&](const Block& block) {
            for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) found.push_back({&block, slot});
        });
    }
    return boundary_of(std::move(found));
}

Boundary boundary_of(std::vector<FacetPlace> found) {
    Boundary boundary;
    sort_range(found, [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
    boundary.patch.reserve(found.size());
    std::vector<std::uint32_t> face_of;
    face_of.reserve(found.size());
    for (const FacetPlace& facet : found) face_of.push_back(boundary.patch.add(facet));
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

// SPDX-License-Identifier: MIT
// Triangles of a mesh in one plane that hang together by edges.
#include "carve/mesh_polygons.h"

namespace firma {

void MeshPolygons::clear() {
    of_.clear();
    first_.clear();
    members_.clear();
}

void MeshPolygons::set(DisjointSets& sets, std::size_t triangles) {
    const auto count = std::uint32_t(triangles);
    of_.resize(count);
    first_.assign(count + 1, 0);
    members_.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) ++first_[(of_[t] = sets.find(t)) + 1];
    for (std::uint32_t k = 0; k < count; ++k) first_[k + 1] += first_[k];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < count; ++t) members_[next[of_[t]]++] = t;
}

}  // namespace firma

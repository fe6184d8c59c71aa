// SPDX-License-Identifier: MIT
// Gathers the sides of faces by edge: a counting sort by one end, a sort by the other.
#include "level/shared_edges.h"

#include "base/sort.h"

namespace firma {

SharedEdges::SharedEdges(const ExactMesh& mesh, const WeldedPositions& welded) : first_(welded.size() + 1) {
    const auto for_each_side = [&](auto&& visit) {
        for (const ExactMesh::Face& face : mesh.faces)
            for (std::uint32_t corner = face.first_corner; corner < face.first_corner + face.corner_count; ++corner) {
                const std::uint32_t from = welded.of_corner[corner];
                const std::uint32_t to = welded.of_corner[corner_after(face, corner)];
                if (from != to) visit(corner, std::min(from, to), std::max(from, to), from < to);
            }
    };
    for_each_side([&](std::uint32_t, std::uint32_t low, std::uint32_t, bool) { ++first_[low + 1]; });
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];

    sides_.resize(first_.back());
    std::vector<std::uint32_t> free(first_.begin(), first_.end());
    for_each_side([&](std::uint32_t corner, std::uint32_t low, std::uint32_t high, bool up) {
        sides_[free[low]++] = {high, corner, up};
    });
    for (std::size_t low = 0; low + 1 < first_.size(); ++low)
        sort_range(std::span(sides_).subspan(first_[low], first_[low + 1] - first_[low]),
                   [](const FaceSide& a, const FaceSide& b) {
                       return a.high != b.high ? a.high < b.high : a.corner < b.corner;
                   });
}

}  // namespace firma

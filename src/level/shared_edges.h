// SPDX-License-Identifier: MIT
// The directed sides of all faces of a mesh, gathered by the edge that they run along.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "level/weld_positions.h"

namespace firma {

/// A side of a face: it begins at a corner and leads to the next one of its face.
struct FaceSide {
    std::uint32_t high = 0;    ///< the larger of its two positions
    std::uint32_t corner = 0;  ///< where it begins
    bool up = false;           ///< it leads from the smaller position to the larger
};

class SharedEdges {
public:
    SharedEdges(const ExactMesh& mesh, const WeldedPositions& welded);

    /// Calls visit(std::span<const FaceSide>) for each edge with its sides, in order of their corners. A side without
    /// length belongs to none.
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (std::size_t low = 0; low + 1 < first_.size(); ++low)
            for (std::size_t begin = first_[low], end = begin; begin < first_[low + 1]; begin = end) {
                while (end < first_[low + 1] && sides_[end].high == sides_[begin].high) ++end;
                visit(std::span(sides_).subspan(begin, end - begin));
            }
    }

private:
    std::vector<FaceSide> sides_;       ///< by smaller position, larger position, corner
    std::vector<std::uint32_t> first_;  ///< of a smaller position, into sides_; one more at the end
};

/// The corner after another one of the same face.
inline std::uint32_t corner_after(const ExactMesh::Face& face, std::uint32_t corner) {
    return corner + 1 < face.first_corner + face.corner_count ? corner + 1 : face.first_corner;
}

}  // namespace firma

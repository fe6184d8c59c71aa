// SPDX-License-Identifier: MIT
// Which faces share an edge.
#include "level/find_neighbours.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace firma {
namespace {

/// For each vertex, the first one at the same position.
std::vector<std::uint32_t> first_at_position(std::span<const GridPoint> vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return vertices[a] != vertices[b] ? vertices[a] < vertices[b] : a < b;
    });
    std::vector<std::uint32_t> first(vertices.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && vertices[order[k]] == vertices[order[k - 1]];
        first[order[k]] = same ? first[order[k - 1]] : order[k];
    }
    return first;
}

/// One use of an edge: by which corner of which face, and whether from the lower vertex to the higher.
struct EdgeUse {
    std::uint32_t low, high;
    std::uint32_t face, corner;
    bool upward;
};

std::vector<EdgeUse> edge_uses(const Level& level) {
    const std::vector<std::uint32_t> first = first_at_position(level.vertices);
    std::vector<EdgeUse> uses;
    uses.reserve(level.corners.size());
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) {
        const LevelFace& face = level.faces[f];
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            const std::uint32_t next = c + 1 < face.corner_count ? c + 1 : 0;
            const std::uint32_t a = first[level.corners[face.first_corner + c]];
            const std::uint32_t b = first[level.corners[face.first_corner + next]];
            uses.push_back({std::min(a, b), std::max(a, b), f, face.first_corner + c, a < b});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
    });
    return uses;
}

}  // namespace

std::vector<FaceId> find_neighbours(const Level& level) {
    std::vector<FaceId> neighbours(level.corners.size());
    const std::vector<EdgeUse> uses = edge_uses(level);
    for (std::size_t k = 0; k < uses.size();) {
        std::size_t end = k + 1;
        while (end < uses.size() && uses[end].low == uses[k].low && uses[end].high == uses[k].high) ++end;
        if (end - k == 2 && uses[k].upward != uses[k + 1].upward) {
            neighbours[uses[k].corner] = {uses[k + 1].face};
            neighbours[uses[k + 1].corner] = {uses[k].face};
        }
        k = end;
    }
    return neighbours;
}

}  // namespace firma

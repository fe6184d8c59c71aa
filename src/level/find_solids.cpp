// SPDX-License-Identifier: MIT
// Which faces of a level bound closed solids.
#include "level/find_solids.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/exact_plane.h"
#include "level/disjoint_sets.h"

namespace firma {
namespace {

/// The first vertex at each vertex's position.
std::vector<std::uint32_t> first_at_position(const std::vector<GridPoint>& vertices) {
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

struct EdgeUse {
    std::uint32_t low, high, face;
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
            uses.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return uses;
}

/// Six times the volume between a face and the origin, cubic metres: a sign and a size to compare are all that is
/// asked.
double signed_volume(const Level& level, const LevelFace& face) {
    const auto corner = [&](std::uint32_t c) {
        return to_metres(level.vertices[level.corners[face.first_corner + c]]);
    };
    double sum = 0;
    for (std::uint32_t c = 2; c < face.corner_count; ++c) sum += dot(corner(0), cross(corner(c - 1), corner(c)));
    return sum;
}

}  // namespace

LevelSolids find_solids(const Level& level) {
    DisjointSets pieces(level.faces.size());
    std::vector<bool> open(level.faces.size(), false);
    const std::vector<EdgeUse> uses = edge_uses(level);
    for (std::size_t k = 0; k < uses.size();) {
        std::size_t end = k;
        int balance = 0;
        while (end < uses.size() && uses[end].low == uses[k].low && uses[end].high == uses[k].high) {
            balance += uses[end].upward ? 1 : -1;
            pieces.join(uses[k].face, uses[end].face);
            ++end;
        }
        if (end - k != 2 || balance != 0) open[uses[k].face] = true;
        k = end;
    }
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) {
        const LevelFace& face = level.faces[f];
        if (face.two_sided) open[f] = true;
        for (std::uint32_t c = 0; c < face.corner_count; ++c)
            if (!on_input_grid(level.vertices[level.corners[face.first_corner + c]])) open[f] = true;
    }
    std::vector<bool> open_piece(level.faces.size(), false);
    std::vector<double> volume(level.faces.size(), 0);
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) {
        const std::uint32_t piece = pieces.find(f);
        if (open[f]) open_piece[piece] = true;
        volume[piece] += signed_volume(level, level.faces[f]);
    }
    LevelSolids found;
    found.solid.resize(level.faces.size());
    double largest = 0;
    for (std::uint32_t f = 0; f < level.faces.size(); ++f) {
        const std::uint32_t piece = pieces.find(f);
        found.solid[f] = !open_piece[piece];
        if (!open_piece[piece] && std::fabs(volume[piece]) > std::fabs(largest)) largest = volume[piece];
    }
    found.rock_outside = largest < 0;
    return found;
}

}  // namespace firma

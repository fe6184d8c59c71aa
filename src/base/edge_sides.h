// SPDX-License-Identifier: MIT
// The directed sides of a mesh's faces, gathered by the edge that they run along.
//
// For a mesh that is there as a whole. A SolidPatch finds edges one by one, while faces are added.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace firma {

/// A side of a face, between two points that are told apart by number.
struct EdgeSide {
    std::uint32_t low = 0, high = 0;  ///< its ends, low < high
    std::uint32_t owner = 0;          ///< whose it is, as the caller counts
    bool upward = false;              ///< it leads from low to high

    EdgeSide() = default;
    EdgeSide(std::uint32_t from, std::uint32_t to, std::uint32_t owner_of_it)
        : low(from < to ? from : to), high(from < to ? to : from), owner(owner_of_it), upward(from < to) {}
};

/// Sorts by both ends; sides of one edge stay in their order. In proportion to sides and points, for a fan of a million
/// triangles too.
void sort_sides(std::span<EdgeSide> sides, std::size_t point_count);

/// All sides of one edge.
/// @param sorted  by sort_sides()
/// @param first   its first side
std::span<const EdgeSide> edge_at(std::span<const EdgeSide> sorted, std::size_t first);

/// Calls `visit(sides)` for each edge.
template <class Visit>
void for_each_edge(std::span<const EdgeSide> sorted, const Visit& visit) {
    for (std::size_t first = 0; first < sorted.size();) {
        const std::span<const EdgeSide> edge = edge_at(sorted, first);
        visit(edge);
        first += edge.size();
    }
}

}  // namespace firma

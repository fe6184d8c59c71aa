// SPDX-License-Identifier: MIT
// Sorts triangles into islands that hang together by their edges, and walks each one's rim.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace firma {

/// Triangles that share edges, used the opposite way by each of two.
struct Island {
    std::vector<std::uint32_t> triangles;  ///< three corners each
    /// Corners around it, counter-clockwise as the triangles are; empty when the island is no disc, so that no one
    /// outline tells all of it.
    std::vector<std::uint32_t> outline;
    std::vector<std::uint32_t> inner;  ///< corners of a disc that are not on its outline
};

/// Looks at how triangles hang together, never at where they lie.
///
/// @param triangles  three corners each; those that name a corner twice are left out
/// @return the islands, in order of their first triangles. When an edge is used twice the same way, nobody can tell
/// which
///         triangle goes with which, and all are one island without an outline.
std::vector<Island> find_islands(std::span<const std::uint32_t> triangles);

}  // namespace firma

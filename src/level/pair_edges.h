// SPDX-License-Identifier: MIT
// Which faces of a mesh follow each other around an edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exact_plane.h"

namespace firma {

/// How a face uses an edge: `low` and `high` are numbers of points, low < high.
struct EdgeUse {
    std::uint32_t low = 0, high = 0, face = 0;
    bool upward = false;     ///< from low to high
    std::uint32_t apex = 0;  ///< some corner of the face off the edge's line
};

/// Sorts the uses of one edge by angle around it, exactly, and pairs them.
///
/// @param uses  all of one edge, as often upward as not
/// @return pairs of indices into `uses`, the upward one first: between the two lies air and no other face. Empty when
///         upward and downward ones do not alternate, or two faces lie on each other
std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_uses(std::span<const InputPoint> points,
                                                               std::span<const EdgeUse> uses);

}  // namespace firma

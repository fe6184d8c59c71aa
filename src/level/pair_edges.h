// SPDX-License-Identifier: MIT
// Which faces of a mesh on the input grid follow each other around an edge.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/edge_sides.h"
#include "geometry/exact_plane.h"

namespace firma {

/// Sorts the sides of one edge by angle around it, exactly, and pairs them.
///
/// @param sides   all of one edge, as often upward as not
/// @param apexes  of each side some corner of its face off the edge's line
/// @return pairs of indices into `sides`, the upward one first: between the two lies air and no other face. Empty when
///         upward and downward ones do not alternate, or two faces lie on each other
std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_sides(std::span<const InputPoint> points,
                                                                std::span<const EdgeSide> sides,
                                                                std::span<const std::uint32_t> apexes);

}  // namespace firma

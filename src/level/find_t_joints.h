// SPDX-License-Identifier: MIT
// Finds edges that a further position lies on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "level/weld_positions.h"

namespace firma {

using PositionPair = std::array<std::uint32_t, 2>;

/// For each edge, whether another position that faces use lies exactly on its inside.
/// Positions near an edge are found by a tree: an edge costs little, unless many positions lie within rounding of its
/// line, yet not on it.
std::vector<bool> find_t_joints(const ExactMesh& mesh, const WeldedPositions& welded,
                                std::span<const PositionPair> edges);

}  // namespace firma

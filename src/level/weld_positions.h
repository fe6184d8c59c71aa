// SPDX-License-Identifier: MIT
// Finds vertices of a mesh that are at the same position, exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "level/check_mesh_core.h"

namespace firma {

/// Positions that faces use, numbered from 0.
struct WeldedPositions {
    static constexpr std::uint32_t kUnused = ~0u;

    std::vector<std::uint32_t> of_vertex;  ///< position of a vertex; kUnused where no face uses it
    std::vector<std::uint32_t> vertex;     ///< one vertex of each position
    std::vector<std::uint32_t> of_corner;  ///< position of a corner

    std::size_t size() const { return vertex.size(); }
};

WeldedPositions weld_positions(const ExactMesh& mesh);

}  // namespace firma

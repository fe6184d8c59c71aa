// SPDX-License-Identifier: MIT
// Faces divided along their pieces: cells, each wholly inside, outside or on every other solid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/flat_edges.h"

namespace firma {

struct Cell {
    std::uint32_t face = 0;
    std::uint32_t first_use = 0, use_count = 0;    ///< of all loops in a row
    std::uint32_t first_loop = 0, loop_count = 0;  ///< ends, counted from first_use; the first loop is the outer one
};

struct CellSet {
    std::vector<Cell> cells;  ///< in order of faces
    std::vector<PieceUse> all_uses;
    std::vector<std::uint32_t> loop_ends;
    std::vector<std::uint32_t> first_of_face;  ///< and one more

    std::span<const PieceUse> uses(const Cell& cell) const {
        return {all_uses.data() + cell.first_use, cell.use_count};
    }
    std::span<const std::uint32_t> ends(const Cell& cell) const {
        return {loop_ends.data() + cell.first_loop, cell.loop_count};
    }
};

/// Adds the loops of one plane to cells, a cell an outline.
/// @return false when they do not group
bool add_cells(FlatEdges& flat, std::uint32_t face, std::span<const PieceUse> loops,
               std::span<const std::uint32_t> ends, CellSet& cells);

/// @return false when some face does not divide: it, or what it met, crosses itself
bool find_cells(Overlay& overlay, const SpanFinder& spans, const DividedLines& lines, CellSet& cells);

}  // namespace firma

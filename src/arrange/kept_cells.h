// SPDX-License-Identifier: MIT
// What is known of an arrangement's cells while faces are made of them, phase by phase.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/arranged.h"
#include "arrange/flat_edges.h"
#include "base/disjoint_sets.h"

namespace firma {

struct KeptCells {
    static constexpr std::uint32_t kNone = ~0u;

    KeptCells(Overlay& overlay_in, const DividedLines& lines_in, const CellSet& cells_in, const PieceUsers& users_in,
              const Selection& selection_in);

    Overlay& overlay;
    const DividedLines& lines;
    const CellSet& cells;
    const PieceUsers& users;
    const Selection& selection;
    FlatEdges flat;
    DisjointSets groups;                  ///< of cells that become one face
    std::vector<GridBox> box;             ///< of a group, by the cell that stands for it
    std::vector<Kept> kept;               ///< of each cell
    std::vector<PieceUse> uses;           ///< of all cells, as they are kept
    std::vector<std::uint8_t> dissolved;  ///< of each use: what lies beyond is the same face
    std::vector<std::uint32_t> across;    ///< of one that is dissolved: the use that lies beyond
    std::vector<std::uint8_t> contact;    ///< of each point: whether it lies where both solids are, or faces became one
    std::vector<std::uint32_t> partner;   ///< of each use: the one beyond the edge
    std::vector<std::uint8_t> crowded;    ///< of each use: there are other edges at its piece

    /// Looks out of the result.
    PlaneId plane_of(std::uint32_t cell) const {
        const PlaneId plane = overlay.faces[cells.cells[cell].face].plane;
        return kept[cell] == Kept::kTurned ? from_behind(plane) : plane;
    }
    bool is_kept(std::uint32_t use) const { return kept[users.cell_of(use)] != Kept::kNot; }
    std::uint32_t group_of(std::uint32_t use) { return groups.find(users.cell_of(use)); }
    /// The use beyond the edge that a use came with; none where its face is not here.
    std::uint32_t mate_of(std::uint32_t use) const {
        for (const std::uint32_t other : users.at(uses[use].piece))
            if (other != use && is_kept(other) && uses[other].edge == uses[use].edge &&
                uses[other].forward != uses[use].forward)
                return other;
        return kNone;
    }
};

}  // namespace firma

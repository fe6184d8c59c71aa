// SPDX-License-Identifier: MIT
// Faces divided along their pieces: cells, each wholly inside, outside or on every other solid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/flat_edges.h"
#include "arrange/phase_end.h"

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

class CellFinder {
public:
    CellFinder(Overlay& overlay, const SpanFinder& spans, const DividedLines& lines)
        : overlay_(overlay), spans_(spans), lines_(lines), flat_(overlay, lines) {}

    /// Broken when some face does not divide: it, or what it met, crosses itself.
    /// @param faces  how many of the overlay, from the first on
    PhaseEnd step(WorkSlice& slice, std::size_t faces);
    PhaseEnd step(WorkSlice& slice) { return step(slice, overlay_.faces.size()); }

    /// Of these faces, once it is done.
    const CellSet& cells() const { return cells_; }

private:
    bool divide_face(std::uint32_t face);
    void add_whole(std::uint32_t face, std::span<const FacePiece> pieces);
    bool add_cells(std::uint32_t face);
    bool comes_back();

    Overlay& overlay_;
    const SpanFinder& spans_;
    const DividedLines& lines_;
    CellSet cells_;
    std::uint32_t next_ = 0;  ///< face
    FlatEdges flat_;
    // Of the face at hand.
    std::vector<PieceUse> uses_, loops_;
    std::vector<std::uint32_t> ends_, points_;
    LoopsByOutline outlines_;
};

}  // namespace firma

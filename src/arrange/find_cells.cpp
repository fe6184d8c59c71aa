// SPDX-License-Identifier: MIT
// Faces divided along their pieces.
#include "arrange/find_cells.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {

/// A face that nothing meets: one cell, its edges divided where others divide them.
void CellFinder::add_whole(std::uint32_t index, std::span<const FacePiece> pieces) {
    const OverlayFace& face = overlay_.faces[index];
    Cell cell;
    cell.face = index;
    cell.first_use = std::uint32_t(cells_.all_uses.size());
    cell.first_loop = std::uint32_t(cells_.loop_ends.size());
    // Pieces come side by side, of each in the line's order.
    std::size_t at = 0;
    std::uint32_t side = 0;
    for (const std::uint32_t end : overlay_.ends(face)) {
        for (; side < end; ++side) {
            const OverlaySide& it = overlay_.sides(face)[side];
            std::size_t last = at;
            while (last < pieces.size() && pieces[last].edge == it.edge &&
                   (last == at || lines_.piece(pieces[last].piece).from == lines_.piece(pieces[last - 1].piece).to))
                ++last;
            const bool forward = pieces[at].covers == kCoversLeft;
            for (std::size_t k = at; k < last; ++k) {
                const FacePiece& piece = pieces[forward ? k : at + last - 1 - k];
                cells_.all_uses.push_back({piece.piece, forward, piece.reversed, piece.edge});
            }
            at = last;
        }
        cells_.loop_ends.push_back(std::uint32_t(cells_.all_uses.size()) - cell.first_use);
    }
    cell.use_count = std::uint32_t(cells_.all_uses.size()) - cell.first_use;
    cell.loop_count = face.loop_count;
    cells_.cells.push_back(cell);
}

/// Whether a face's loops, divided, come to a point twice: there its inside may hang together by that point alone, and
/// what lies on either side is not one cell.
bool CellFinder::comes_back() {
    points_.clear();
    for (const PieceUse& use : uses_) points_.push_back(flat_.from(use));
    sort_range(points_);
    return std::adjacent_find(points_.begin(), points_.end()) != points_.end();
}

/// A cell an outline.
bool CellFinder::add_cells(std::uint32_t face) {
    if (!flat_.group(loops_, ends_, outlines_)) return false;
    for (std::size_t k = 0; k < outlines_.outlines().size(); ++k) {
        Cell cell;
        cell.face = face;
        cell.first_use = std::uint32_t(cells_.all_uses.size());
        cell.first_loop = std::uint32_t(cells_.loop_ends.size());
        cell.loop_count = std::uint32_t(outlines_.loops(k).size());
        append_loops<PieceUse>(loops_, ends_, outlines_.loops(k), cell.first_use, cells_.all_uses, cells_.loop_ends);
        cell.use_count = std::uint32_t(cells_.all_uses.size()) - cell.first_use;
        cells_.cells.push_back(cell);
    }
    return true;
}

bool CellFinder::divide_face(std::uint32_t face) {
    cells_.first_of_face.push_back(std::uint32_t(cells_.cells.size()));
    const auto pieces = lines_.of_face(face);
    uses_.clear();
    for (const FacePiece& piece : pieces) {
        if (piece.covers & kCoversLeft) uses_.push_back({piece.piece, true, piece.reversed, piece.edge});
        if (piece.covers & kCoversRight) uses_.push_back({piece.piece, false, piece.reversed, piece.edge});
    }
    if (!spans_.touched(face) && !comes_back()) {
        add_whole(face, pieces);
        return true;
    }
    flat_.start(overlay_.faces[face].plane);
    return flat_.trace(uses_, loops_, ends_) && add_cells(face);
}

PhaseEnd CellFinder::step(WorkSlice& slice, std::size_t faces) {
    for (; next_ < faces; ++next_) {
        if (slice.used_up()) return PhaseEnd::kGoesOn;
        slice.take(1 + lines_.of_face(next_).size());
        if (!divide_face(next_)) return PhaseEnd::kBroken;
    }
    cells_.first_of_face.push_back(std::uint32_t(cells_.cells.size()));
    return PhaseEnd::kDone;
}

}  // namespace firma

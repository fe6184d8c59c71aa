// SPDX-License-Identifier: MIT
// Faces divided along their pieces.
#include "arrange/find_cells.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {
namespace {

/// A face that nothing meets: one cell, its edges divided where others divide them.
void add_whole(const Overlay& overlay, std::uint32_t index, std::span<const FacePiece> pieces,
               const DividedLines& lines, CellSet& cells) {
    const OverlayFace& face = overlay.faces[index];
    Cell cell;
    cell.face = index;
    cell.first_use = std::uint32_t(cells.all_uses.size());
    cell.first_loop = std::uint32_t(cells.loop_ends.size());
    // Pieces come side by side, of each in the line's order.
    std::size_t at = 0;
    std::uint32_t side = 0;
    for (const std::uint32_t end : overlay.ends(face)) {
        for (; side < end; ++side) {
            const OverlaySide& it = overlay.sides(face)[side];
            std::size_t last = at;
            while (last < pieces.size() && pieces[last].edge == it.edge &&
                   (last == at || lines.piece(pieces[last].piece).from == lines.piece(pieces[last - 1].piece).to))
                ++last;
            const bool forward = pieces[at].covers == kCoversLeft;
            for (std::size_t k = at; k < last; ++k) {
                const FacePiece& piece = pieces[forward ? k : at + last - 1 - k];
                cells.all_uses.push_back({piece.piece, forward, piece.reversed, piece.edge});
            }
            at = last;
        }
        cells.loop_ends.push_back(std::uint32_t(cells.all_uses.size()) - cell.first_use);
    }
    cell.use_count = std::uint32_t(cells.all_uses.size()) - cell.first_use;
    cell.loop_count = face.loop_count;
    cells.cells.push_back(cell);
}

/// Whether a face's loops, divided, come to a point twice: there its inside may hang together by that point alone, and
/// what lies on either side is not one cell.
bool comes_back(const FlatEdges& flat, std::span<const PieceUse> uses, std::vector<std::uint32_t>& points) {
    points.clear();
    for (const PieceUse& use : uses) points.push_back(flat.from(use));
    sort_range(points);
    return std::adjacent_find(points.begin(), points.end()) != points.end();
}

}  // namespace

bool add_cells(FlatEdges& flat, std::uint32_t face, std::span<const PieceUse> loops,
               std::span<const std::uint32_t> ends, CellSet& cells) {
    std::vector<std::uint32_t> outline_of;
    if (!flat.group(loops, ends, outline_of)) return false;
    for (std::uint32_t outline = 0; outline < ends.size(); ++outline) {
        if (outline_of[outline] != outline) continue;
        Cell cell;
        cell.face = face;
        cell.first_use = std::uint32_t(cells.all_uses.size());
        cell.first_loop = std::uint32_t(cells.loop_ends.size());
        cell.loop_count =
            append_outline<PieceUse>(loops, ends, outline_of, outline, cell.first_use, cells.all_uses, cells.loop_ends);
        cell.use_count = std::uint32_t(cells.all_uses.size()) - cell.first_use;
        cells.cells.push_back(cell);
    }
    return true;
}

bool find_cells(Overlay& overlay, const SpanFinder& spans, const DividedLines& lines, CellSet& cells) {
    cells = {};
    FlatEdges flat(overlay, lines);
    std::vector<PieceUse> uses, loops;
    std::vector<std::uint32_t> ends, points;
    for (std::uint32_t face = 0; face < overlay.faces.size(); ++face) {
        cells.first_of_face.push_back(std::uint32_t(cells.cells.size()));
        const auto pieces = lines.of_face(face);
        uses.clear();
        for (const FacePiece& piece : pieces) {
            if (piece.covers & kCoversLeft) uses.push_back({piece.piece, true, piece.reversed, piece.edge});
            if (piece.covers & kCoversRight) uses.push_back({piece.piece, false, piece.reversed, piece.edge});
        }
        if (!spans.touched(face) && !comes_back(flat, uses, points)) {
            add_whole(overlay, face, pieces, lines, cells);
            continue;
        }
        flat.start(overlay.faces[face].plane);
        if (!flat.trace(uses, loops, ends) || !add_cells(flat, face, loops, ends, cells)) return false;
    }
    cells.first_of_face.push_back(std::uint32_t(cells.cells.size()));
    return true;
}

}  // namespace firma

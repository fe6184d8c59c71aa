// SPDX-License-Identifier: MIT
// Lines divided at all points on them.
#include "arrange/divide_lines.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {

std::uint32_t DividedLines::place_of(std::uint32_t line, std::uint32_t point) const {
    const std::vector<std::uint32_t>& on = spans_.points_on()[line];
    const auto at = std::lower_bound(on.begin(), on.end(), point, [&](std::uint32_t a, std::uint32_t b) {
        return overlay_.lines.before(line, a, b);
    });
    return std::uint32_t(at - on.begin());
}

bool DividedLines::divide(WorkSlice& slice) {
    if (!lines_done_) {
        if (!go_on(next_, spans_.points_on().size(), slice, [&](std::uint32_t line) {
                slice.take(spans_.points_on()[line].size() / 4);
                divide_line(line);
            }))
            return false;
        whole_edge_.assign(overlay_.edges.size(), ~0u);
        first_.assign(1, 0);
        lines_done_ = true;
    }
    return go_on(next_, overlay_.faces.size(), slice, [&](std::uint32_t face) {
        add_face(face);
        slice.take((first_[face + 1] - first_[face]) / 4);
    });
}

void DividedLines::divide_line(std::uint32_t line) {
    std::vector<std::uint32_t>& on = spans_.points_on()[line];
    sort_range(on, [&](std::uint32_t a, std::uint32_t b) { return overlay_.lines.before(line, a, b); });
    on.erase(std::unique(on.begin(), on.end()), on.end());
    first_piece_.push_back(std::uint32_t(pieces_.size()));
    for (std::size_t k = 0; k + 1 < on.size(); ++k) pieces_.push_back({line, on[k], on[k + 1]});
}

void DividedLines::add_face(std::uint32_t face) {
    if (spans_.touched(face))
        add_touched(spans_.spans_of(face));
    else
        add_whole(face);
    first_.push_back(std::uint32_t(face_pieces_.size()));
}

/// Each piece once, in order; twice where two edges of the face run along it, one on each side.
void DividedLines::add_touched(std::span<const FaceSpan> spans) {
    const std::size_t first = face_pieces_.size();
    for (const FaceSpan& span : spans) {
        const std::uint32_t from = place_of(span.line, span.from), to = place_of(span.line, span.to);
        for (std::uint32_t k = from; k < to; ++k)
            face_pieces_.push_back({first_piece_[span.line] + k, span.covers, span.edge, span.reversed});
    }
    const auto mine = std::span(face_pieces_).subspan(first);
    sort_range(mine, [](const FacePiece& a, const FacePiece& b) {
        if (a.piece != b.piece) return a.piece < b.piece;
        return a.edge != b.edge ? a.edge < b.edge : a.covers < b.covers;  // its own edges first
    });
    std::size_t kept = first;
    std::uint8_t covered = kCoversNothing;  // of the piece at hand
    for (std::size_t k = first; k < face_pieces_.size(); ++k) {
        FacePiece it = face_pieces_[k];
        const bool again = kept > first && face_pieces_[kept - 1].piece == it.piece;
        if (!again) covered = kCoversNothing;
        it.covers &= std::uint8_t(~covered);
        covered |= it.covers;
        if (!again || (it.edge != FacePiece::kNoEdge && it.edge != face_pieces_[kept - 1].edge && it.covers != 0))
            face_pieces_[kept++] = it;
        else
            face_pieces_[kept - 1].covers |= it.covers;
    }
    face_pieces_.resize(kept);
}

/// Of a face that nothing meets the edges may be divided all the same, as a neighbour is met.
void DividedLines::add_whole(std::uint32_t index) {
    const OverlayFace& face = overlay_.faces[index];
    for (const OverlaySide& side : overlay_.sides(face)) {
        const std::uint32_t line = spans_.line_of(side.edge);
        if (line == SpanFinder::kNoLine) {
            std::uint32_t& piece = whole_edge_[side.edge];
            if (piece == ~0u) {
                piece = std::uint32_t(pieces_.size());
                pieces_.push_back({Piece::kNoLine, overlay_.edges[side.edge].from, overlay_.edges[side.edge].to});
            }
            face_pieces_.push_back({piece, std::uint8_t(side.reversed ? kCoversRight : kCoversLeft), side.edge, false});
            continue;
        }
        std::uint32_t from = place_of(line, overlay_.from(side)), to = place_of(line, overlay_.to(side));
        const bool along = from < to;
        if (!along) std::swap(from, to);
        for (std::uint32_t k = from; k < to; ++k)
            face_pieces_.push_back({first_piece_[line] + k, std::uint8_t(along ? kCoversLeft : kCoversRight), side.edge,
                                    along == side.reversed});
    }
}

}  // namespace firma

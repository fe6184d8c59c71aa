// SPDX-License-Identifier: MIT
// Lines divided at all points on them: pieces, and which of them each face has, on which side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/find_spans.h"

namespace firma {

/// Between two neighbours on a line; or a whole edge that nothing meets.
struct Piece {
    std::uint32_t line = kNoLine;
    std::uint32_t from = 0, to = 0;  ///< points: in the line's order, or as the edge runs
    static constexpr std::uint32_t kNoLine = ~0u;
};

/// A piece in a face's closure.
struct FacePiece {
    std::uint32_t piece = 0;
    std::uint8_t covers = 0;       ///< Cover: which sides of the piece the face covers
    std::uint32_t edge = kNoEdge;  ///< the face's own that it is a part of
    bool reversed = false;         ///< that edge runs against the piece
    static constexpr std::uint32_t kNoEdge = ~0u;
};

/// In order of lines, and along each.
class DividedLines {
public:
    /// @param spans  after finish(); its lists of points are sorted
    DividedLines(const Overlay& overlay, SpanFinder& spans) : overlay_(overlay), spans_(spans) {}

    /// @return whether all of it is done; else call it again
    bool divide(WorkSlice& slice);

    std::size_t size() const { return pieces_.size(); }
    const Piece& piece(std::uint32_t number) const { return pieces_[number]; }
    std::span<const FacePiece> of_face(std::uint32_t face) const {
        return {face_pieces_.data() + first_[face], first_[face + 1] - first_[face]};
    }

private:
    void divide_line(std::uint32_t line);
    void add_face(std::uint32_t face);
    void add_touched(std::span<const FaceSpan> spans);
    void add_whole(std::uint32_t face);
    std::uint32_t place_of(std::uint32_t line, std::uint32_t point) const;

    const Overlay& overlay_;
    SpanFinder& spans_;
    bool lines_done_ = false;
    std::uint32_t next_ = 0;  ///< line, then face
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> first_piece_;  ///< of each line
    std::vector<std::uint32_t> whole_edge_;   ///< the piece that is an edge; ~0: none yet
    std::vector<FacePiece> face_pieces_;
    std::vector<std::uint32_t> first_;  ///< in face_pieces_, of each face
};

}  // namespace firma

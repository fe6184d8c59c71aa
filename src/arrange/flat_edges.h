// SPDX-License-Identifier: MIT
// Directed pieces in one plane: which follows which around a point, what their loops enclose. Exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/divide_lines.h"
#include "arrange/loops_by_outline.h"
#include "index/box_tree.h"

namespace firma {

/// A piece as a loop runs along it, what the loop goes around to the left.
struct PieceUse {
    std::uint32_t piece = 0;
    bool forward = false;                     ///< as the piece runs
    bool reversed = false;                    ///< that edge runs against the piece
    std::uint32_t edge = FacePiece::kNoEdge;  ///< of the face that it came with, if any
    std::uint32_t id = 0;                     ///< the caller's

    /// The other way.
    PieceUse turned() const {
        PieceUse use = *this;
        use.forward = !forward;
        return use;
    }
};

/// Of one plane at a time. Keeps its scratch from call to call.
class FlatEdges {
public:
    FlatEdges(Overlay& overlay, const DividedLines& lines) : overlay_(overlay), lines_(lines) {}

    /// @param plane  as it is looked at from the front
    void start(PlaneId plane) { plane_ = plane; }

    std::uint32_t from(const PieceUse& use) const {
        const Piece& piece = lines_.piece(use.piece);
        return use.forward ? piece.from : piece.to;
    }
    std::uint32_t to(const PieceUse& use) const {
        const Piece& piece = lines_.piece(use.piece);
        return use.forward ? piece.to : piece.from;
    }

    /// Follows uses around: each turns, at its end, into the first one clockwise from the way back.
    /// @param loops  the uses, loop by loop; `ends` where each ends
    /// @return false when some use has none that follows
    bool trace(std::span<const PieceUse> uses, std::vector<PieceUse>& loops, std::vector<std::uint32_t>& ends);

    /// Which loops are outlines, and in which one each hole lies directly. Loops do not cross, but may touch.
    /// @return false when a hole lies in none
    bool group(std::span<const PieceUse> loops, std::span<const std::uint32_t> ends, LoopsByOutline& by_outline);

private:
    std::uint32_t line_of(const PieceUse& use) const;
    bool runs_with_line(const PieceUse& use) const;
    PlaneId across(const PieceUse& use) const;
    bool runs_with(const PieceUse& use) const;
    int turn(const PieceUse& a, const PieceUse& b) const;
    bool comes_before(const PieceUse& in, const PieceUse& a, const PieceUse& b) const;
    bool runs_left(std::span<const PieceUse> loop);
    bool encloses(std::span<const PieceUse> loop, const PieceUse& use);
    std::uint32_t meet(const PieceUse& use, PlaneId across);
    BoxTree boxes_of(std::span<const PieceUse> loops, std::span<const std::uint32_t> ends,
                     std::span<const std::uint32_t> listed) const;

    Overlay& overlay_;
    const DividedLines& lines_;
    PlaneId plane_ = kNoPlane;
    std::vector<std::uint32_t> order_, next_, outline_of_;
};

}  // namespace firma

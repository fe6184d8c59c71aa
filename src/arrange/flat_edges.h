// SPDX-License-Identifier: MIT
// Directed pieces in one plane: which follows which around a point, what their loops enclose. Exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/divide_lines.h"

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

/// Appends the loop that is an outline, and the holes in it.
/// @param outline_of  see FlatEdges::group()
/// @param first       in `uses_made`, where the uses of this outline begin: ends are counted from there
/// @return how many loops
template <class Use>
std::uint32_t append_outline(std::span<const Use> uses, std::span<const std::uint32_t> ends,
                             std::span<const std::uint32_t> outline_of, std::uint32_t outline, std::size_t first,
                             std::vector<Use>& uses_made, std::vector<std::uint32_t>& ends_made) {
    std::uint32_t count = 0;
    const auto add = [&](std::uint32_t loop) {
        const std::uint32_t begin = loop == 0 ? 0 : ends[loop - 1];
        uses_made.insert(uses_made.end(), uses.begin() + begin, uses.begin() + ends[loop]);
        ends_made.push_back(std::uint32_t(uses_made.size() - first));
        ++count;
    };
    add(outline);
    for (std::uint32_t hole = 0; hole < ends.size(); ++hole)
        if (hole != outline && outline_of[hole] == outline) add(hole);
    return count;
}

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

    /// Which loops are outlines, and in which one each hole lies directly.
    /// @param outline_of  of each loop: itself for an outline. Loops do not cross, but may touch
    /// @return false when a hole lies in none
    bool group(std::span<const PieceUse> loops, std::span<const std::uint32_t> ends,
               std::vector<std::uint32_t>& outline_of);

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

    Overlay& overlay_;
    const DividedLines& lines_;
    PlaneId plane_ = kNoPlane;
    std::vector<std::uint32_t> order_, next_;
};

}  // namespace firma

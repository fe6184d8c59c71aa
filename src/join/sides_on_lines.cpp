// SPDX-License-Identifier: MIT
// Which polygons have sides on a line: a list for each line.
#include "join/sides_on_lines.h"

#include <utility>

namespace firma {

LineSide SidesOnLines::make(std::uint32_t owner, const ConvexPiece& piece, std::size_t k) {
    LineSide side;
    side.owner = owner;
    side.from = piece.corner(k);
    side.to = piece.corner(piece.next(k));
    side.plane = piece.plane;
    side.across = piece.sides[k].plane;
    side.line = lines_.add(side.plane, side.across, side.from);
    side.forward = lines_.runs_along(side.line, side.plane, side.across);
    if (!side.forward) std::swap(side.from, side.to);
    return side;
}

std::uint32_t SidesOnLines::add(std::uint32_t owner, const ConvexPiece& piece) {
    const auto first = std::uint32_t(sides_.size());
    for (std::size_t k = 0; k < piece.sides.size(); ++k) {
        LineSide side = make(owner, piece, k);
        if (side.line >= first_.size()) first_.resize(side.line + 1, LineSide::kNone);
        side.next = first_[side.line];
        first_[side.line] = std::uint32_t(sides_.size());
        sides_.push_back(side);
    }
    return first;
}

void SidesOnLines::remove(std::uint32_t first, std::size_t count) {
    for (std::uint32_t k = first; k < first + count; ++k) {
        std::uint32_t* at = &first_[sides_[k].line];
        while (*at != k) at = &sides_[*at].next;
        *at = sides_[k].next;
    }
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// Pieces of one plane side by side become one, as long as that is convex.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "join/convex_piece.h"

namespace firma {

/// A polygon of the level that is joined, and what it says of itself.
struct JoinPiece {
    ConvexPiece piece;
    std::uint32_t source = 0;  ///< the brush side that it was cut from; of pieces that were merged the lowest
    std::uint32_t material = 0;
    std::uint32_t mask = 0;
};

/// Says whether the side between two corners, of pieces in a plane, has to stay.
using KeepSide = std::function<bool(std::uint32_t from, std::uint32_t to, PlaneId plane)>;

/// Merges greedily, longest sides first, what has one plane, material and mask; depends on the order of the pieces
/// alone.
/// @param pieces  no two in one plane overlap
void merge_pieces(const JoinTables& tables, std::vector<JoinPiece>& pieces, const KeepSide& keep);

}  // namespace firma

// SPDX-License-Identifier: MIT
// What debris keeps of a chunk.
#pragma once

#include "firma/debris.h"

namespace firma {

inline DebrisPiece piece_of_chunk(const Chunk& chunk) {
    DebrisPiece piece;
    piece.solid = chunk.solid;
    piece.matter = main_matter(chunk);
    piece.origin = chunk.origin;
    return piece;
}

}  // namespace firma

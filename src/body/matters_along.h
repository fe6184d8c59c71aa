// SPDX-License-Identifier: MIT
// Which matters a stretch of a path goes through.
#pragma once

#include <vector>

#include "body/path_crossings.h"
#include "firma/pierce.h"
#include "solid/matter_pieces.h"

namespace firma {

/// A stretch of the path that lies in a piece.
struct PieceStretch {
    double from = 0, to = 0;  ///< in the sweep's parameter
    bool soft = true;         ///< not: it may not be carved, and counts before all that may
    std::uint32_t number = 0, matter = 0;

    bool counts_before(const PieceStretch& other) const {
        return soft != other.soft ? other.soft : number < other.number;
    }
};

/// What is needed on the way; keeps its memory.
struct MatterScratch {
    std::vector<PieceStretch> pieces;
    std::vector<PathCrossing> crossings, far;
    std::vector<SolidStretch> inside;
};

/// Adds the matters between two parameters of a sweep, in order, without gaps.
/// @param pieces  null: all of the first matter
void add_matters_along(const MatterPieces* pieces, const CarveRules* rules, const Sweep& sweep, double from, double to,
                       MatterScratch& scratch, std::vector<MatterLength>& found);

}  // namespace firma

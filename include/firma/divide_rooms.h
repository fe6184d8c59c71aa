// SPDX-License-Identifier: MIT
// Portals for a level of brushes whose author placed none, or too few: at doorways and where the air is narrow.
#pragma once

#include <cstddef>

#include "firma/brush_level.h"
#include "firma/export.h"
#include "firma/result.h"

namespace firma {

struct DivideOptions {
    /// An opening divides two rooms when its area is less than so many times that of a square wall of the smaller one,
    /// were that a cube. 0: none does.
    double narrow = 0.4;
    double smallest_room = 8;            ///< cubic metres of air
    std::size_t most_cells = 6'000'000;  ///< looked at: 14 bytes each; where these are too few, small doors are missed
};

/// What dividing a level came to.
struct DivideReport {
    std::size_t cells = 0;    ///< looked at; 0 where the level has no solid brush, or too many and too large ones
    std::size_t narrows = 0;  ///< sections of the air that were narrower than what lies beyond
    std::size_t untried = 0;  ///< of these, the widest of more than 20,000: what they would divide is left undivided
    std::size_t idle = 0;     ///< of these, chosen in vain: the air goes around by a way that the cells do not show
    std::size_t portals = 0;  ///< added
};

/// Adds portals where the air of the level narrows: rectangles square to an axis, each a brush of BrushKind::kPortal at
/// the end of `brushes`, of entity 0 and material 0, with its portal as its first side. Each divides two rooms in the
/// world that make_world() makes of the level; none is idle. All else stays as it is, the author's portals too: what
/// these leave undivided is divided further. (Sources of BrushLevel::surfaces count on from the sides that there are
/// then.)
///
/// The air is looked at in cells, a sixteenth of a metre wide or more, as many as most_cells allow; a doorway at least
/// as deep as they are is found. What divides the cells is then put to the exact test. What lies outside of a closed
/// hull is not divided, if a player begins inside of it (entities `info_player...`).
///
/// @param report  filled, when given
/// @return the level with the portals, the same on every machine; as it was where nothing is narrow. kTooLarge and
///         kInvalid as of make_world(); kInvalid for an option that is no number or negative
/// Takes about as long as making the level's world, and a second or so for the cells: the brushes are joined once,
/// however many narrows are chosen in vain.
FIRMA_EXPORT Result<BrushLevel> divide_rooms(const BrushLevel& level, const DivideOptions& options = {},
                                             DivideReport* report = nullptr);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Portals for levels whose author placed none: where doorways and other narrow places are.
#pragma once

#include <cstddef>

#include "firma/brush_level.h"
#include "firma/result.h"

namespace firma {

struct DivideOptions {
    double cell = 0.25;                  ///< metres: the air is looked at in cells of at least this size
    std::size_t most_cells = 8'000'000;  ///< else in larger ones
    double narrow = 0.7;       ///< a place is narrow when its clearance is below this share of that on either side
    double smallest_room = 8;  ///< cubic metres: less becomes part of a neighbour
    double smallest_clearance = 0.5;  ///< metres: as does what has no place at least this far from all walls
};

/// Divides the air that the level's hull encloses at its narrow places: adds brushes of kPortal to the level, as if its
/// author had placed them. The clearance of the air (the distance to the nearest solid) is taken cell by cell; around
/// each of its peaks there is a basin; basins meet at saddles, and where a saddle is narrow, a portal is put across.
///
/// @return how many were added: none for a level that is open to the void, or has no narrow place; errors as
///         make_world() of the level
/// Source: for basins and saddles, L. Vincent, P. Soille, Watersheds in Digital Spaces, 1991.
Result<std::size_t> divide_rooms(BrushLevel& level, const DivideOptions& options = {});

}  // namespace firma

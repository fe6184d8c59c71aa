// SPDX-License-Identifier: MIT
// What the closed pieces of a level are made of.
#pragma once

#include "firma/level.h"
#include "firma/matter.h"
#include "level/find_solids.h"
#include "solid/matter_pieces.h"

namespace firma {

/// The matter of a closed piece is that of most of its faces (of equally many, the lower one), by Level::matters and
/// the names of materials; faces of the first of the table count only where there are no others.
///
/// Pieces are kept where they are not all of one matter: those that look out, the smaller boxes first, so of such
/// inside each other the innermost comes first. What is in none is rock around the air of those that look in: the rest
/// has their matter.
MatterPieces matters_of_level(const Level& level, const LevelSolids& solids, const MatterTable& table);

/// The faces of a piece as a solid of its own.
/// @param faces  of the level, ascending: closed, looking out
Solid solid_of_faces(const Level& level, const LevelSolids& solids, std::span<const std::uint32_t> faces);

}  // namespace firma

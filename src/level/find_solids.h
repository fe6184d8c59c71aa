// SPDX-License-Identifier: MIT
// Which faces of a level bound closed solids, and can be carved.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/ref.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "level/solid_pieces.h"
#include "solid/solid_face.h"

namespace firma {

struct LevelSolids {
    std::vector<bool> solid;           ///< a face each
    std::vector<std::uint32_t> piece;  ///< a face each: which piece of the surface it is in
    bool rock_outside = false;         ///< what no face separates from infinity is solid
    std::vector<SolidNote> notes;      ///< why some pieces are castable only, in order of their first faces
    /// The exact faces of those that have an edge where solids touch, with their numbers, ascending.
    std::vector<std::pair<std::uint32_t, Ref<const SolidFace>>> stored;
    SolidWork work;  ///< what it took
};

/// Pieces of the surface are what is joined by edges; where more than two faces meet in one, those on either side of
/// the same air are joined. A piece can be carved when
///  - every edge is used equally often each way, by faces that alternate around it,
///  - all its faces are one-sided, and its vertices lie on the input grid,
///  - it neither crosses nor touches itself or another such piece, but for edges and vertices that they share,
///  - and it is turned the right way for where it lies: the outermost piece says whether rock or air is outside.
/// All of it is decided exactly, within SolidLimits: pieces for which it would take more are castable only, too.
LevelSolids find_solids(const Level& level);

}  // namespace firma

// SPDX-License-Identifier: MIT
// Large faces are halved toward a cut before it is made, so that their loops stay short.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "carve/cutter_solid.h"
#include "solid/block.h"
#include "solid/solid_patch.h"

namespace firma {

/// A face that a cut touches is at most so many times as long as the cutter along any axis, or this long, metres; where
/// halving can make it so.
inline constexpr double kLargestInCutters = 4;
inline constexpr double kLargestTile = 8;

/// So long, metres: larger ones are halved.
double largest_face(const CutterSolid& cutter);

/// Halves large faces by axis planes, again and again, only the pieces that reach into the cutter's bevelled box. The
/// faces they are pieces of, and neighbours whose edges are split by it, become `replaced`; pieces name their `parent`.
/// A face that no plane tried cuts into just two is left whole.
///
/// @param root   of an index over the solid, where neighbours are looked for; null for no faces
/// @param steps  by which the cutter's boxes are grown first, surface steps
void tile_faces(const Node* root, const CutterSolid& cutter, std::int32_t steps, SolidPatch& patch);

/// What tiling alone makes of the solid, beside the cut.
struct KeptPieces {
    std::vector<std::uint32_t> pieces;    ///< that the cut left whole: they come
    std::vector<std::uint32_t> replaced;  ///< the faces that they and others are pieces of: they go
};

/// @param gone  faces of the patch that the cut took or replaced
KeptPieces keep_pieces(const SolidPatch& patch, std::span<const std::uint32_t> gone);

}  // namespace firma

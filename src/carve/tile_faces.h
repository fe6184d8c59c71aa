// SPDX-License-Identifier: MIT
// Large faces are halved toward a cut before it is made, so that their loops stay short.
#pragma once

#include "carve/cut_state.h"
#include "solid/block.h"

namespace firma {

/// A face that a cut touches is at most this long along any axis, where halving can make it so, metres.
inline constexpr double kLargestTile = 8;

/// Halves large faces by axis planes, again and again, only the pieces that reach into the cutter's bevelled box. The
/// faces they are pieces of, and neighbours whose edges are split by it, become `replaced`; pieces name their `parent`.
/// A face with holes, or one that a plane would cut into more than two, is left whole.
///
/// @param root   of an index over the solid, where neighbours are looked for; null for no faces
/// @param steps  how far the cutter may be moved yet along each axis, surface steps
void tile_faces(const Node* root, const CutterSolid& cutter, std::int32_t steps, SolidPatch& patch);

/// Adds to a traced cut what tiling alone makes: replaced faces go, and pieces that the cut left whole come.
void keep_pieces(Cut& cut);

}  // namespace firma

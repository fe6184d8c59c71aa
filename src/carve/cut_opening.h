// SPDX-License-Identifier: MIT
// What a carving opens to the air, and what leaves with it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "carve/find_pockets.h"
#include "geometry/grid_box.h"
#include "solid/block.h"
#include "solid/face_set.h"

namespace firma {

/// A piece that a cut left loose: all its facets go with SolidChange::removed, or do not come with `added`.
struct CutPiece {
    std::vector<FacetPlace> removed;  ///< of faces that the cut left alone: all of each, each with its part
    FaceSet made;                     ///< of faces that the cut made; ids are left open
    double volume = 0;                ///< cubic metres
    GridBox box;
};

/// What a carving opens: the pieces of faces that it took, and pockets of new air behind them.
struct CutOpening {
    std::uint32_t pockets = 0;            ///< 0: all that was added of the cutter bounds one air
    std::optional<std::uint32_t> air;     ///< the cutter took walls of this one alone: pockets are part of it
    FaceSet taken;                        ///< pieces of the solid's faces, and loose pieces' faces; facets in a row
    std::vector<std::uint32_t> of_taken;  ///< the pocket of each of `taken.faces`
    std::vector<std::uint32_t>
        of_added;  ///< of each of SolidChange::added.faces; Pockets::kNone: a piece of an old one
};

/// Which air faces of a part look into.
using AirOfPart = std::function<std::uint32_t(std::uint32_t part)>;

/// Whether not all faces of a list of parts look into one air.
bool several_airs(std::span<const std::uint32_t> parts, const AirOfPart& air_of);

/// Whether a mesh is more than one closed surface; a Solid may be.
bool has_several_shells(const CutterSolid& cutter);

/// All that a cutter leaves bounds one air.
Pockets one_pocket(const NewLoops& loops);

/// Pockets that a loose piece touches become one.
/// @param made_of_piece  of each piece: indices of `pockets.of_face`; what lies beyond it is of no pocket
/// @return the pocket of each piece
std::vector<std::uint32_t> join_pockets(std::span<const std::vector<std::uint32_t>> made_of_piece, Pockets& pockets);

/// The facets of a loose piece that looked into rooms, face by face, each with an exact one.
void append_walls(const CutPiece& piece, FaceSet& walls);

}  // namespace firma

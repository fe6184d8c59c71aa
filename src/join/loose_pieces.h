// SPDX-License-Identifier: MIT
// What casts meet and no solid is bounded by: glass, clips, liquids, patches, brushes that could not be joined.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/grid.h"
#include "join/merge_pieces.h"

namespace firma {

/// A convex, exactly planar polygon of the surface grid.
struct LooseFacet {
    std::vector<GridPoint> corners;
    std::uint32_t source = 0;  ///< a brush side; from their count on, a face of BrushLevel::surfaces
    std::uint32_t material = 0;
    std::uint32_t mask = 0;
    bool two_sided = false;
    std::uint32_t room = 0;
};

/// The facets of pieces, which take each other's corners into their outlines, so that nothing slips through between
/// them.
/// @param pieces  that do not overlap in one plane
/// @return without rooms; pieces too thin for the grid have none
std::vector<LooseFacet> make_loose_facets(const ExactTables& tables, const std::vector<JoinPiece>& pieces);

/// The polygon as a piece: in the plane of its corners, its sides in planes along the plane's dominant axis.
/// @param corners  on the input grid; convex, exactly planar, with area
ConvexPiece piece_of_corners(ExactTables& tables, const std::vector<InputPoint>& corners);

}  // namespace firma

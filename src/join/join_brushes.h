// SPDX-License-Identifier: MIT
// Many convex brushes become one closed solid: faces hidden in other brushes go, what is left is joined, and the air is
// divided into rooms by portals.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "firma/brush_level.h"
#include "join/arrangement.h"
#include "join/find_rooms.h"
#include "join/join_facets.h"
#include "join/loose_pieces.h"

namespace firma {

/// A portal that divides two rooms.
struct JoinPortal {
    std::uint32_t source = 0;  ///< the brush side
    std::vector<std::uint32_t>
        polygons;  ///< indices into JoinedLevel::portal_pieces; their fronts look into the first room
    std::uint32_t room[2] = {0, 0};
};

/// A brush that is not part of the solid though it should be, and why.
struct LeftOut {
    std::uint32_t brush = 0;
    std::string reason;      ///< a clause
    bool no_volume = false;  ///< it is none at all: castable neither
};

/// A side of which the plane was moved.
struct MovedSide {
    std::uint32_t side = 0;
    std::array<GridPoint, 3> points;  ///< of its plane as it is now, as BrushSide::points
};

/// A brush of the solid as a body, by the planes that bound it, fronts looking out.
struct JoinBody {
    std::uint32_t brush = 0;
    GridBox box;
    std::vector<PlaneId> planes;
};

/// How much one round of joining did: the first one does all, one after a repair what the repair touches.
struct JoinRound {
    bool whole = false;        ///< all brushes of the solid were cut
    std::size_t brushes = 0;   ///< of the solid, of which faces were cut
    std::size_t faces = 0;     ///< cut
    std::size_t pieces = 0;    ///< merged
    std::size_t lines = 0;     ///< arranged
    std::size_t polygons = 0;  ///< made into facets
};

struct JoinedLevel {
    ExactTables tables;
    std::vector<JoinPiece> faces;          ///< of the solid, fronts in the air
    std::vector<JoinPiece> portal_pieces;  ///< in the air; a material is the portal's brush side
    Arrangement arrangement;               ///< of faces and, after them, portal pieces
    JoinFacets facets;                     ///< likewise
    JoinRooms rooms;
    std::vector<JoinPortal> portals;
    std::vector<std::uint32_t> idle_portals;    ///< brush sides of portals with one room on both sides
    std::vector<std::uint32_t> hidden_portals;  ///< brushes of which no part of a portal is left to the air
    std::vector<LeftOut> left_out;
    std::size_t planes_moved = 0;        ///< so that no face is too thin for the grid
    std::vector<PlaneId> plane_of_side;  ///< by brush side: as the level has it, or as it was moved
    std::vector<MovedSide> moved_sides;  ///< by side
    std::vector<LooseFacet> loose;       ///< of kinds that are no solid, of brushes left out, of BrushLevel::surfaces;
                                         ///< materials are of the list that they come from
    std::vector<JoinRound> rounds;       ///< of joining
    std::vector<JoinBody> bodies;        ///< of the brushes that are in the solid, ascending; once it is finished
};

/// @return kTooLarge for more planes or polygons than can be numbered
Result<std::unique_ptr<JoinedLevel>> join_brushes(const BrushLevel& level);

}  // namespace firma

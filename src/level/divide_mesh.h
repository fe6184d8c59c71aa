// SPDX-License-Identifier: MIT
// Divides the air of a level of faces into rooms, by portals.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firma/rooms.h"
#include "join/arrangement.h"
#include "join/find_rooms.h"
#include "join/join_facets.h"
#include "join/loose_pieces.h"
#include "level/find_solids.h"

namespace firma {

struct DividedMesh {
    ExactTables tables;
    std::vector<JoinPiece> faces;    ///< of the solid; a source is an index into Level::faces
    std::vector<JoinPiece> portals;  ///< parts in the air; a source is an index into the portals
    Arrangement arrangement;         ///< of faces and, after them, portals
    JoinFacets facets;               ///< likewise
    JoinRooms rooms;
    std::vector<LooseFacet> loose;  ///< of faces that bound no solid; sources as of faces
    std::string fault;              ///< why it cannot be divided; then nothing of the above is of use
};

/// @param level    all corners on the input grid
/// @param portals  their polygons too, convex and planar
/// @param solids   of the level
/// @param plain    the level as one room
std::unique_ptr<DividedMesh> divide_mesh(const Level& level, std::span<const LevelPortal> portals,
                                         const LevelSolids& solids, const World& plain);

}  // namespace firma

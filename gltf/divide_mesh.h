// SPDX-License-Identifier: MIT
// Divides the air of a mesh into rooms, by the portals that its file has.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "firma/read_gltf.h"
#include "join/arrangement.h"
#include "join/find_rooms.h"
#include "join/join_facets.h"
#include "join/loose_pieces.h"
#include "level/find_solids.h"

namespace firma::gltf {

struct DividedMesh {
    JoinTables tables;
    std::vector<JoinPiece> faces;    ///< of the solid; a source is an index into Level::faces
    std::vector<JoinPiece> portals;  ///< parts in the air; a source is an index into GltfLevel::portals
    Arrangement arrangement;         ///< of faces and, after them, portals
    JoinFacets facets;               ///< likewise
    JoinRooms rooms;
    std::vector<LooseFacet> loose;  ///< of faces that bound no solid; sources as of faces
    std::string fault;              ///< why it cannot be divided; then nothing of the above is of use
};

/// @param solids  of gltf.level
/// @param plain   the level as one room
std::unique_ptr<DividedMesh> divide_mesh(const GltfLevel& gltf, const LevelSolids& solids, const World& plain);

}  // namespace firma::gltf

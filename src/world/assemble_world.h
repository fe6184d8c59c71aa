// SPDX-License-Identifier: MIT
// From rooms, portals and options to a World: what readers of levels end with.
#pragma once

#include <string>
#include <vector>

#include "firma/result.h"
#include "firma/world.h"
#include "tree/face_set.h"
#include "world/portal_set.h"

namespace firma {

struct RoomPart {
    FaceSet faces;  ///< of this room, ids set: no two faces of a world share one
    std::string name;
    bool exterior = false;  ///< reaches to infinity: of at most one room, and then there is no rock outside
};

/// Per room, the directed edges of solid faces, and of portal polygons as seen from that room, cancel exactly on the
/// surface grid. Nothing of that is looked at here: check_world() does.
struct WorldParts {
    std::string name;  ///< for messages
    std::vector<RoomPart> rooms;
    std::vector<PortalPart> portals;
    std::vector<std::string> materials;
    bool rock_outside = false;  ///< what no face separates from infinity is solid
    WorldOptions options;
};

/// @return the world, version 0; kTooLarge beyond 2^31 faces, rooms or portals; kInvalid, naming the portal, where
/// rooms
///         are not there or the same, or a polygon has not 3 to 64 corners; kInvalid for no room, or two that reach to
///         infinity
Result<World> assemble_world(WorldParts parts);

}  // namespace firma

// SPDX-License-Identifier: MIT
// From rooms, portals and options to a World: what readers of levels end with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/long_work.h"
#include "firma/result.h"
#include "firma/world.h"
#include "solid/face_set.h"
#include "world/cells.h"
#include "world/world_data.h"

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
    LongWork* work = nullptr;                      ///< what does it, already under way; null: by the options
    std::shared_ptr<const FaceTextures> textures;  ///< null: none
    MatterPieces matters;
};

/// A world whose faces are in blocks.
struct StoredWorld {
    BuiltStore solid, castable;
    std::vector<RoomRecord> records;  ///< at least one; lists of portals are made from `portals`
    std::vector<PortalPart> portals;  ///< sound ones
    bool known = false;               ///< Cells::known()
    bool rock_outside = false;
    std::uint32_t next_face = 0, edits = 0;
    std::uint64_t version = 0;
    std::shared_ptr<const std::vector<std::string>> materials;
    Tolerance tolerance;
    TreeOptions tree_options;
    std::shared_ptr<const CarveRules> rules;
    std::shared_ptr<const Anchors> anchors;
    std::shared_ptr<const FaceTextures> textures;
    std::shared_ptr<const MatterPieces> matters;  ///< null: they would say nothing
};
World world_of(StoredWorld stored);
/// Of records and portals, which are moved out.
Cells cells_of(StoredWorld& stored);

/// What a world keeps of it: null where it says nothing.
std::shared_ptr<const MatterPieces> kept_matters(MatterPieces matters);

/// Why work was stopped, if it was.
std::optional<Error> stopped(const LongWork& work, const std::string& name);

/// @return the world, version 0; why the work was stopped; kTooLarge beyond 2^31 faces, rooms or portals; kInvalid,
/// naming the portal, where rooms
///         are not there or the same, or a polygon has not 3 to 64 corners; kInvalid for no room, or two that reach to
///         infinity
Result<World> assemble_world(WorldParts parts);

}  // namespace firma

// SPDX-License-Identifier: MIT
// What changed between two versions of a world: for meshes to draw, maps to walk, caches to drop.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// A cell of a grid over space: from coordinate * size to (coordinate + 1) * size along each axis.
using Tile = std::array<std::int32_t, 3>;

/// Tiles of a smaller size are none.
inline constexpr double kLeastTile = 1.0 / 16;  // metres
/// More of them are not listed.
inline constexpr std::size_t kMostTiles = std::size_t(1) << 22;

struct WorldDiff {
    std::vector<FaceInfo> removed;  ///< faces of `before` only, in order of id, then room
    std::vector<FaceInfo> added;    ///< of `after` only, likewise; World::face() has their outlines

    // All ascending.
    std::vector<RoomId> rooms;  ///< that a face left or came to, that became part of another or ceased to be, or that
                                ///< only one of the worlds has
    std::vector<PortalId> opened, closed;   ///< doors, of portals in both worlds
    std::vector<PortalId> portals_removed;  ///< with polygons in `before` only
    std::vector<PortalId> portals_added;    ///< in `after` only
    std::vector<PortalId> portals_changed;  ///< in both, and yet not the same: other rooms (as edits joined some),
                                            ///< polygons or names

    Box bounds;                   ///< of all those faces and portals; empty when nothing changed
    std::vector<Tile> tiles;      ///< those that the box of such a face or portal touches, each once, in order
    bool too_many_tiles = false;  ///< there are more than kMostTiles: `tiles` is empty; go by `bounds`

    bool empty() const {
        return removed.empty() && added.empty() && rooms.empty() && opened.empty() && closed.empty() &&
               portals_removed.empty() && portals_added.empty() && portals_changed.empty();
    }
};

/// Compares two worlds. A face is the same when it has the same id and is alike in everything but its room: what an
/// edit only put into another room, as it joined two, did not change. Rooms and portals are compared by their ids. What
/// the worlds share is not looked at, so for versions a few edits apart the cost follows the edits.
///
/// @param tile_size  metres, for `tiles`, at least kLeastTile; anything smaller (0, say) or not finite leaves them out.
///                   A long face slanted across many tiles counts for each in its box, so a size far below the faces'
///                   makes a long list; one of more than kMostTiles is left out, and too_many_tiles is set.
FIRMA_EXPORT WorldDiff diff_worlds(const World& before, const World& after, double tile_size = 0);

}  // namespace firma

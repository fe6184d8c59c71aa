// SPDX-License-Identifier: MIT
// Rooms and portals: where a point is, what leads where, doors. docs/rooms.md tells how levels come to have them.
//
// A room is a volume of air. Faces bound it, and portals: polygons through which its air passes into that of another
// room. What lies behind faces is solid. A world from a level that knows no rooms has one, and no portals. Ids of rooms
// and portals stay what they are through edits: an edit that joins rooms leaves the higher ids empty, and questions
// asked with one of them are answered for the room that it became part of; portals that it swallows keep their ids, and
// have no polygons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// Where a point is.
struct Location {
    enum class Kind : std::uint8_t {
        kRoom,    ///< in the air of `room`
        kSolid,   ///< behind faces
        kUnsure,  ///< on a face, in a fold of the surface that rounding to the grid made, or no usable number; outside
                  ///< all of several rooms where none is the exterior; anywhere among several rooms without any face of
                  ///< a solid, as of a file saved without its exact part
    };
    Kind kind = Kind::kUnsure;
    RoomId room;  ///< with kRoom

    friend bool operator==(const Location&, const Location&) = default;
};

/// Finds the room that a point lies in, or that it lies in the solid: by what a ray from it meets first, a face of the
/// solid (Face::solid) or a portal, open or closed. A point on a portal lies in the first of its rooms; on several, of
/// the one with the lowest id. Beyond all faces lies the exterior room, where there is one, or the one room of a world
/// that has but one.
///
/// @param point  metres; may lie outside the world
/// Never allocates. Costs a cast or two.
FIRMA_EXPORT Location locate(const World& world, const Vec3& point);

struct RoomInfo {
    std::string name;       ///< "" where the level gives none
    Box bounds;             ///< of its faces and portals, metres; empty where it has none
    std::size_t faces = 0;  ///< in its tree
    bool exterior = false;  ///< reaches to infinity
    RoomId part_of;         ///< itself, unless an edit joined it to another room: then that one, and it is empty
    std::vector<PortalId> portals;  ///< ascending
};

/// @param room  below World::room_count(); else the caller's mistake
FIRMA_EXPORT RoomInfo room_info(const World& world, RoomId room);

struct PortalInfo {
    std::array<RoomId, 2> rooms;
    std::vector<std::vector<Vec3>> polygons;  ///< convex, metres, exact; counter-clockwise seen from rooms[0]. None: an
                                              ///< edit has joined the rooms or filled the portal, and it leads nowhere
    std::string name;                         ///< "" where the level gives none
    std::uint32_t material = 0;
    std::uint32_t mask = 0;  ///< what it stops while closed (masks.h)
    bool open = true;
    Box bounds;  ///< metres
};

/// How many portals there are, those without polygons counted.
FIRMA_EXPORT std::size_t portal_count(const World& world);

/// @param portal  below portal_count(); else the caller's mistake
FIRMA_EXPORT PortalInfo portal_info(const World& world, PortalId portal);

/// The rooms that portals, open or closed, join to a room, each once, ascending.
FIRMA_EXPORT std::vector<RoomId> neighbours(const World& world, RoomId room);

enum class Doors : std::uint8_t {
    kAsTheyAre,  ///< only open portals lead on
    kAllOpen,    ///< closed ones do, too
};

/// A way from room to room by the fewest portals; of several ways the one whose list of portals is first in order.
///
/// @return the portals passed, in order; none at all when both are one room; nothing when there is no way
FIRMA_EXPORT std::optional<std::vector<PortalId>> find_path(const World& world, RoomId from, RoomId to,
                                                            Doors doors = Doors::kAsTheyAre);

/// Opens or closes a portal. While closed it is a two-sided wall for what its mask stops.
///
/// @return the world with this one change, one version on, sharing all else; the same world when nothing changes. Costs
///         a few small copies, however many portals there are
FIRMA_EXPORT World set_portal_open(const World& world, PortalId portal, bool open);

}  // namespace firma

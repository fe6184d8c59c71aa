// SPDX-License-Identifier: MIT
// Rooms and portals: where a point is, what leads where, doors. docs/rooms.md tells how levels come to have them.
//
// A room is a volume of air. Faces bound it, and portals: polygons through which its air passes into that of another
// room. What lies behind faces is solid. A world from a level that knows no rooms has one, and no portals. Ids of rooms
// and portals stay what they are through edits. Rooms stay apart: what an edit opens between them are portals
// (docs/rooms.md). Of rooms that become one all the same, all but one are empty, and questions asked with one of them
// are answered for that one; portals that were removed keep their ids, and have no polygons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firma/export.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "firma/level.h"
#include "firma/result.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// Where a point is.
struct Location {
    /// kUnknown also outside all of several rooms where none is the exterior, and anywhere among several rooms without
    /// any face of a solid, as of a file saved without its exact part.
    Where where = Where::kUnknown;
    RoomId room;  ///< with kAir

    friend bool operator==(const Location&, const Location&) = default;
};

/// Finds the room that a point lies in, or that it lies in the solid: by what a ray from it meets first, a face of the
/// solid (Face::solid) or a portal, open or closed. A point on a portal lies in the first of its rooms; on several, of
/// the one with the lowest id. Beyond all faces lies the exterior room, where there is one, or the one room of a world
/// that has but one.
///
/// @param point  metres; may lie outside the world
/// Never allocates. Costs a cast or two, against faces and portals; up to eight, and a search of the faces around the
/// point, for one on the surface. For a point that sees nothing, among several rooms, also a look at each room.
[[nodiscard]] FIRMA_EXPORT Location locate(const World& world, const Vec3& point);

struct RoomInfo {
    std::string_view name;  ///< "" where the level gives none; good as long as the world
    Box bounds;             ///< of its faces and portals, metres; empty where it has none. Of faces rounded outward to
                            ///< float: up to a millimetre too large, never too small
    std::size_t faces = 0;
    bool exterior = false;  ///< reaches to infinity
    RoomId merged_into;     ///< itself, unless an edit made it part of another room: then that one, and it is empty
    std::span<const PortalId> portals;  ///< ascending; good as long as the world
};

/// @return nothing for a room that is not there.
/// Never allocates. Costs the same for every room, but for a few steps more where edits joined many rooms.
[[nodiscard]] FIRMA_EXPORT std::optional<RoomInfo> room_info(const World& world, RoomId room);

/// The room of a name, the first of several; of an edit that joined it to another, still its own id.
/// @return nothing where no room has it, and for "".
/// Never allocates. Costs a look at each room, up to the one found.
[[nodiscard]] FIRMA_EXPORT std::optional<RoomId> find_room(const World& world, std::string_view name);
/// The portal of a name, likewise; those without polygons keep theirs. Costs a look at each portal, up to the one
/// found.
[[nodiscard]] FIRMA_EXPORT std::optional<PortalId> find_portal(const World& world, std::string_view name);

/// The room that a hit is in: that its face looks into; of a closed portal the one on the side that was met.
/// @return invalid for a miss, and for a face or portal that this world does not have.
/// Never allocates. Of a face it costs World::face_info(), of a portal portal_info().
[[nodiscard]] FIRMA_EXPORT RoomId room_of(const World& world, const Hit& hit);

struct PortalInfo {
    std::array<RoomId, 2> rooms;
    std::string_view name;  ///< "" where the level gives none; good as long as the world
    std::uint32_t material = 0;
    std::uint32_t mask = 0;    ///< what it stops while closed (level.h)
    std::size_t polygons = 0;  ///< 0: an edit has made its rooms one or filled it, and it leads nowhere
    bool open = true;
    Box bounds;  ///< metres; empty where it has no polygons
};

/// How many portals there are, those without polygons counted. Costs the same for every world.
[[nodiscard]] FIRMA_EXPORT std::size_t portal_count(const World& world);

/// @return nothing for a portal that is not there.
/// Never allocates. Costs the same for every portal, but for a few steps more where edits joined many rooms.
[[nodiscard]] FIRMA_EXPORT std::optional<PortalInfo> portal_info(const World& world, PortalId portal);

/// Its polygons: convex, metres, exact; counter-clockwise seen from PortalInfo::rooms[0]. None for a portal that is not
/// there. Costs copying them: an allocation for each.
[[nodiscard]] FIRMA_EXPORT std::vector<std::vector<Vec3>> portal_polygons(const World& world, PortalId portal);

/// The rooms that portals, open or closed, join to a room, each once, ascending; none for a room that is not there.
/// Costs the room's portals, and sorting them.
[[nodiscard]] FIRMA_EXPORT std::vector<RoomId> neighbours(const World& world, RoomId room);

enum class Doors : std::uint8_t {
    kAsTheyAre,  ///< only open portals lead on
    kAllOpen,    ///< closed ones do, too
};

/// A way from room to room by the fewest portals; of several ways the one whose list of portals is first in order.
///
/// @return the portals passed, in order; none at all when both are one room; nothing when there is no way,
///         or no such room.
/// Goes through the rooms no farther from `to` than `from` is, and their portals, and takes memory for each room of the
/// world.
[[nodiscard]] FIRMA_EXPORT std::optional<std::vector<PortalId>> find_path(const World& world, RoomId from, RoomId to,
                                                                          Doors doors = Doors::kAsTheyAre);

/// Opens or closes a portal. While closed it is a two-sided wall for what its mask stops.
///
/// @return the world with this one change, one version on, sharing all else; the same world when nothing changes, and
///         for a portal without polygons, which leads nowhere; nothing for a portal that is not there.
/// Costs a few small copies, however many portals and faces there are, and the corners of this portal.
[[nodiscard]] FIRMA_EXPORT std::optional<World> set_portal_open(const World& world, PortalId portal, bool open);

/// Where the air of a level is divided. A portal is no face: open, until set_portal_open() closes it.
struct LevelPortal {
    std::string name;  ///< UTF-8, may be empty; two may share one
    /// Convex, exactly planar, 3 to 64 corners on the input grid (snap()), counter-clockwise seen from the front. What
    /// is not flat once it is snapped is given as triangles.
    std::vector<std::vector<GridPoint>> polygons;
};

/// What became of portals.
struct PortalReport {
    std::vector<std::uint32_t> idle;  ///< indices of portals, ascending: with one room on both sides, or parts of it
    std::string undivided;            ///< why there is one room, though there are portals; empty where they divide it
};

/// The level as a world, its air divided into rooms by portals. Only faces that bound closed solids divide air
/// (level_solidity() says which). A portal that does not close its opening, with them and other portals, is idle.
///
/// A portal may be larger than its opening: it is cut where faces cross its plane, and what lies in the solid is left
/// out. Of portals in one place the first counts, from whichever side. Faces are cut where portals meet them and stay
/// carvable; faces that bound no solid are cut likewise, and each part is put into the room that its front looks into.
/// Shells that stand free, as pillars, are in the room that they see. Rooms have no names, but for the last one where
/// the air reaches to infinity: "exterior". A portal with parts between several pairs of rooms becomes a portal for
/// each pair, of the same name; the first of its rooms is the one that its front looks into.
///
/// Without portals this is make_world(level, options). It is that too, and the report says why, where no face bounds a
/// solid, a corner of a face lies off the input grid, portals are cut into more than 2^14 parts, or faces, once cut,
/// are too thin for the grid or bound no solid.
///
/// @param portals  in any number; one without polygons is nothing
/// @param report   replaced, when given
/// @return the world; the errors of make_world(level, options); kInvalid, naming the portal by its index, for a polygon
///         that is not as LevelPortal says
/// Takes some four times as long as make_world() where there are portals, as faces are put in order around edges
/// exactly; parts of portals are compared in pairs. Without portals it costs what make_world() costs.
[[nodiscard]] FIRMA_EXPORT Result<World> make_divided_world(const Level& level, std::span<const LevelPortal> portals,
                                                            const WorldOptions& options = {},
                                                            PortalReport* report = nullptr);

}  // namespace firma

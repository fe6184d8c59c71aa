// SPDX-License-Identifier: MIT
// The portals of a world: polygons between rooms, ready for casts. Which of them are closed is kept apart, so that a
// door costs a few bytes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firma/hit.h"
#include "firma/masks.h"
#include "geometry/grid_box.h"
#include "geometry/polygon_shape.h"
#include "tree/box_tree.h"

namespace firma {

/// A portal on its way into a world: where the air of one room passes into that of another.
struct PortalPart {
    std::array<RoomId, 2> rooms;
    /// Convex, exactly planar, disjoint but for edges, on the surface grid, of 3 to 64 corners each, counter-clockwise
    /// seen from rooms[0]: normals point into it. None at all: a portal that is gone, whose id stays.
    std::vector<std::vector<GridPoint>> polygons;
    std::string name;
    std::uint32_t material = 0;
    std::uint32_t mask = kStopsSolid;  ///< what it stops while closed (masks.h)
    bool open = true;
};

/// A polygon of a portal: a face in the sense of casts.
struct PortalPolygon {
    PolygonShape shape;
    std::span<const GridPoint> corners;
    struct {
        double low[3], high[3];
    } box;  ///< metres
};

struct Portal {
    std::array<RoomId, 2> rooms;
    std::string name;
    std::uint32_t material = 0;
    std::uint32_t mask = 0;
    std::uint32_t first_polygon = 0, polygon_count = 0;
    GridBox box;  ///< of its polygons

    bool gone() const { return polygon_count == 0; }
    /// The room on the other side.
    RoomId beyond(RoomId room) const { return rooms[0] == room ? rooms[1] : rooms[0]; }
};

/// All portals of a world. Nothing in it changes.
class PortalSet {
public:
    /// @param parts  sound ones: assemble_world() looks at what it is given
    /// @param rooms  how many there are
    PortalSet(std::span<const PortalPart> parts, std::size_t rooms);
    PortalSet(const PortalSet&) = delete;
    PortalSet& operator=(const PortalSet&) = delete;

    std::span<const Portal> portals() const { return portals_; }
    std::span<const PortalPolygon> polygons_of(const Portal& portal) const {
        return {polygons_.data() + portal.first_polygon, portal.polygon_count};
    }
    /// Those of one room, ascending; without the ones that are gone.
    std::span<const std::uint32_t> portals_of(std::uint32_t room) const {
        if (room + 1 >= first_of_room_.size()) return {};
        return {of_rooms_.data() + first_of_room_[room], first_of_room_[room + 1] - first_of_room_[room]};
    }
    /// Around the portals that are not gone, and which they are: for rays and points.
    const BoxTree& boxes() const { return boxes_; }
    std::uint32_t portal_of_box(std::uint32_t number) const { return with_box_[number]; }
    /// As it was made, but that it says nothing of being open.
    PortalPart part(std::size_t portal) const;

    std::size_t bytes() const;

private:
    std::vector<Portal> portals_;
    std::vector<PortalPolygon> polygons_;
    std::vector<GridPoint> corners_;
    std::vector<Vec3> metres_;  ///< the same corners
    std::vector<std::uint32_t> first_of_room_, of_rooms_;
    BoxTree boxes_;
    std::vector<std::uint32_t> with_box_;
};

/// Which portals are closed.
struct ClosedPortals {
    std::vector<std::uint8_t> is_closed;  ///< by portal
    std::vector<std::uint32_t> all;       ///< those that are, ascending

    explicit ClosedPortals(std::vector<std::uint8_t> flags);
    std::size_t bytes() const { return sizeof *this + is_closed.capacity() + all.capacity() * sizeof(std::uint32_t); }
};

}  // namespace firma

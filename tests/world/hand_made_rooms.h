// SPDX-License-Identifier: MIT
// Rooms in rock made by hand: polygons with corners at whole metres, and portals between them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "world/assemble_world.h"

namespace firma::test {

inline GridPoint at_metres(int x, int y, int z) {
    const int step = int(kSurfaceSteps);
    return {x * step, y * step, z * step};
}

struct HandMadeRooms {
    WorldParts parts;

    explicit HandMadeRooms(std::size_t rooms) {
        parts.materials = {""};
        parts.rock_outside = true;
        parts.options.rules.merge_share = 0;
        parts.rooms.resize(rooms);
    }

    /// A wall, seen from the room with its corners in order.
    void add(std::size_t room, std::initializer_list<GridPoint> corners) {
        FaceSet& set = parts.rooms[room].faces;
        set.faces.push_back({.id = {next_id_++},
                             .first_corner = std::uint32_t(set.corners.size()),
                             .corner_count = std::uint32_t(corners.size()),
                             .solid = true});
        for (const GridPoint& corner : corners) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(corner);
        }
    }
    void add_portal(std::uint32_t front, std::uint32_t behind, std::vector<std::vector<GridPoint>> polygons) {
        PortalPart portal;
        portal.rooms = {RoomId{front}, RoomId{behind}};
        portal.polygons = std::move(polygons);
        parts.portals.push_back(std::move(portal));
    }

private:
    std::uint32_t next_id_ = 0;
};

}  // namespace firma::test

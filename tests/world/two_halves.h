// SPDX-License-Identifier: MIT
// Two cubes of air side by side along x, in rock; where they meet, a portal all over.
#pragma once

#include <array>

#include "world/assemble_world.h"

namespace firma {

/// Faces 0 to 4 are of room 0, 5 to 9 of room 1: floor, ceiling, the walls at y = 0 and 4, the far wall.
/// @param size  of each cube, metres
inline WorldParts two_halves_parts(int size = 4) {
    WorldParts parts;
    parts.materials = {"", "glass"};
    parts.rock_outside = true;
    parts.rooms.resize(2);
    std::uint32_t id = 0;
    const auto at = [&](int x, int y, int z) {  // in quarters of a cube
        const int step = size * int(kSurfaceSteps) / 4;
        return GridPoint{x * step, y * step, z * step};
    };
    const auto add = [&](int room, std::array<GridPoint, 4> corners) {
        FaceSet& set = parts.rooms[std::size_t(room)].faces;
        set.faces.push_back(
            {.id = {id++}, .first_corner = std::uint32_t(set.corners.size()), .corner_count = 4, .solid = true});
        for (const GridPoint& corner : corners) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(corner);
        }
    };
    for (int room = 0; room < 2; ++room) {
        const int a = 4 * room, b = a + 4;
        add(room, {at(a, 0, 0), at(b, 0, 0), at(b, 4, 0), at(a, 4, 0)});
        add(room, {at(a, 0, 4), at(a, 4, 4), at(b, 4, 4), at(b, 0, 4)});
        add(room, {at(a, 0, 0), at(a, 0, 4), at(b, 0, 4), at(b, 0, 0)});
        add(room, {at(a, 4, 0), at(b, 4, 0), at(b, 4, 4), at(a, 4, 4)});
        if (room == 0)
            add(0, {at(0, 0, 0), at(0, 4, 0), at(0, 4, 4), at(0, 0, 4)});
        else
            add(1, {at(8, 0, 0), at(8, 0, 4), at(8, 4, 4), at(8, 4, 0)});
    }
    PortalPart portal;
    portal.rooms = {RoomId{0}, RoomId{1}};
    portal.polygons = {{at(4, 0, 0), at(4, 0, 4), at(4, 4, 4), at(4, 4, 0)}};  // its normal looks to -x, into room 0
    portal.name = "door";
    portal.material = 1;
    parts.portals = {portal};
    return parts;
}

inline World two_halves(bool open = true) {
    WorldParts parts = two_halves_parts();
    parts.portals[0].open = open;
    return assemble_world(std::move(parts)).value();
}

}  // namespace firma

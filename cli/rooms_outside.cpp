// SPDX-License-Identifier: MIT
// From the exterior by portals, room by room.
#include "cli/rooms_outside.h"

#include <cstddef>
#include <cstdint>

#include "firma/rooms.h"

namespace firma::cli {

std::vector<bool> rooms_outside(const World& world) {
    std::vector<bool> outside(world.room_count(), false);
    std::vector<RoomId> reached;
    for (std::uint32_t room = 0; room < outside.size(); ++room) {
        if (!room_info(world, {room})->exterior) continue;
        outside[room] = true;
        reached.push_back({room});
    }
    while (!reached.empty()) {
        const RoomId room = reached.back();
        reached.pop_back();
        for (const RoomId next : neighbours(world, room)) {
            if (outside[next.value]) continue;
            outside[next.value] = true;
            reached.push_back(next);
        }
    }
    return outside;
}

bool opens_way_out(const World& before, const World& after) {
    const std::vector<bool> was = rooms_outside(before), is = rooms_outside(after);
    for (std::size_t room = 0; room < was.size(); ++room)
        if (is[room] && !was[room]) return true;
    return false;
}

}  // namespace firma::cli

// SPDX-License-Identifier: MIT
// Rooms that the exterior reaches, room by room.
#include "tests/reference/rooms_outside.h"

#include "firma/rooms.h"

namespace firma::reference {

std::vector<bool> rooms_outside(const World& world) {
    std::vector<bool> outside(world.room_count(), false);
    std::vector<RoomId> to_do;
    const auto reach = [&](RoomId room) {
        if (outside[room.value]) return;
        outside[room.value] = true;
        to_do.push_back(room);
    };
    for (std::uint32_t room = 0; room < outside.size(); ++room)
        if (room_info(world, {room})->exterior) reach({room});
    while (!to_do.empty()) {
        const RoomId room = to_do.back();
        to_do.pop_back();
        for (const RoomId next : neighbours(world, room)) reach(next);
    }
    return outside;
}

bool opens_way_out(const World& before, const World& after) {
    const std::vector<bool> was = rooms_outside(before), is = rooms_outside(after);
    for (std::size_t room = 0; room < was.size(); ++room)
        if (is[room] && !was[room]) return true;
    return false;
}

}  // namespace firma::reference

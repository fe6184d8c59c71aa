// SPDX-License-Identifier: MIT
// The rooms that something may meet, by their boxes.
#pragma once

#include "world/world_data.h"

namespace firma {

struct BoxD {
    double low[3], high[3];
};

inline BoxD in_metres(const GridBox& box) {
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

/// Calls `function(room, tree)` for each room with faces whose box meets, and perhaps for others. In an order that
/// depends on the world alone.
/// @param meets(box)  true of a box around another for which it is
template <class Meets, class Function>
void for_each_room_where(const WorldData& data, const Meets& meets, const Function& function) {
    const auto look_at = [&](std::uint32_t room) {
        if (const Block* tree = data.rooms[room]->tree.get()) function(room, *tree);
    };
    if (data.room_boxes) {
        data.room_boxes->for_each_where([&](const GridBox& box) { return meets(in_metres(box)); },
                                        [&](std::uint32_t room) {
                                            look_at(room);
                                            return false;
                                        });
        return;
    }
    // Walks begin by the box of the whole tree.
    for (std::uint32_t room = 0; room < data.rooms.size(); ++room) look_at(room);
}

}  // namespace firma

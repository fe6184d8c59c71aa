// SPDX-License-Identifier: MIT
// The rooms that something may meet, by their boxes.
#pragma once

#include <algorithm>
#include <array>

#include "world/world_data.h"

namespace firma {

struct BoxD {
    double low[3], high[3];
};

inline BoxD in_metres(const GridBox& box) {
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

/// Calls `function(room, tree)` for each room with faces whose box meets, and perhaps for others; in no order that
/// means anything.
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

/// The same for what comes to rooms one after another, nearest first; of rooms as near as each other the lowest.
/// @param enters(box, nearest)  whether to look into a box, and a lower bound for what it may find there
/// @param still(nearest)        whether such a box is worth it by now
/// @param function(room, tree)  true ends it
template <class Enters, class Still, class Function>
void for_each_room_nearest_first(const WorldData& data, const Enters& enters, const Still& still,
                                 const Function& function) {
    struct Near {
        double nearest;
        std::uint32_t room;
    };
    constexpr std::size_t kMost = 256;  // what finds no place here has its turn at once
    std::array<Near, kMost> near;
    std::size_t count = 0;
    double nearest = 0;
    bool ended = false;
    const auto note = [&](std::uint32_t room, const Block& tree) {
        if (count < kMost)
            near[count++] = {nearest, room};
        else
            ended = ended || function(room, tree);
    };
    if (data.room_boxes) {
        for_each_room_where(data, [&](const BoxD& box) { return enters(box, nearest); }, note);
    } else {
        for (std::uint32_t room = 0; room < data.rooms.size(); ++room)
            if (const Block* tree = data.rooms[room]->tree.get(); tree && enters(tree->bins[0].box, nearest))
                note(room, *tree);
    }
    std::sort(near.begin(), near.begin() + std::ptrdiff_t(count), [](const Near& a, const Near& b) {
        return a.nearest != b.nearest ? a.nearest < b.nearest : a.room < b.room;
    });
    for (std::size_t k = 0; k < count && !ended && still(near[k].nearest); ++k)
        ended = function(near[k].room, *data.rooms[near[k].room]->tree);
}

}  // namespace firma

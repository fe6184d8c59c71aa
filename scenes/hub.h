// SPDX-License-Identifier: MIT
// A hall with closets on both of its long sides, each behind a doorway with a portal, in rock: one room that has as
// many portals as there are others.
#pragma once

#include "world/assemble_world.h"

namespace firma::scenes {

/// The hall lies along x, from -closets / 2, 2 m wide from y = 0 and 2 m high. Closets are 1 x 2 x 2 m, and 1 m apart:
/// closet k is 2 (k / 2) + 1 m from the hall's near end, on the side of y < 0 when k is even.
struct Hub {
    int closets = 2;         ///< even
    bool hall_last = false;  ///< the number of the hall's room: 0, or that of the closets
};

WorldParts hub_parts(const Hub& hub);

/// The middle of a closet's floor, metres.
Vec3 floor_of_closet(const Hub& hub, int closet);

inline RoomId hall_of(const Hub& hub) {
    return {hub.hall_last ? std::uint32_t(hub.closets) : 0};
}
inline RoomId room_of_closet(const Hub& hub, int closet) {
    return {std::uint32_t(closet) + !hub.hall_last};
}

}  // namespace firma::scenes

// SPDX-License-Identifier: MIT
// Rooms in pictures: which room each face is of, a colour for each, and what of a world a picture from outside shows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firma/rooms.h"
#include "firma/world.h"

namespace firma::draw {

/// The room of each of some faces.
std::vector<RoomId> rooms_of_faces(std::span<const Face> faces);

/// Red, green and blue, 0 .. 1: the exterior is grey, others have hues in a fixed order, by their ids, so that a room
/// keeps its colour through edits. Hues come again after eleven rooms, lighter and darker.
Vec3 room_colour(RoomId room, bool exterior);

/// A colour on its way to another.
inline Vec3 mixed(const Vec3& from, const Vec3& to, double share) {
    return from + (to - from) * share;
}
inline constexpr Vec3 kWhite{1, 1, 1};

/// "#rrggbb"
std::string hex_colour(const Vec3& colour);

/// "3 hall", or "3" for one without a name.
std::string room_label(const World& world, RoomId room);

/// Rooms beside the exterior that hold anything: a world of two has something to tell apart.
std::size_t count_inner_rooms(const World& world);

/// What a plan is to show, in order of id: not the hull's outside, by which all else would be hidden, unless most of
/// the faces are the exterior's; and no clips, which nobody sees.
std::vector<Face> faces_to_show(const World& world);

}  // namespace firma::draw

// SPDX-License-Identifier: MIT
// Rooms in pictures: see the header.
#include "draw/room_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "firma/level.h"

namespace firma::draw {
namespace {

constexpr Vec3 kExterior{0.62, 0.64, 0.66};
// Neighbours in this list are far apart; none is grey, and none the brown of what edits make.
constexpr std::array<Vec3, 11> kHues = {{{0.31, 0.47, 0.66},
                                         {0.95, 0.56, 0.17},
                                         {0.35, 0.63, 0.31},
                                         {0.88, 0.34, 0.35},
                                         {0.46, 0.72, 0.70},
                                         {0.69, 0.48, 0.63},
                                         {0.93, 0.79, 0.28},
                                         {0.25, 0.65, 0.85},
                                         {0.98, 0.58, 0.66},
                                         {0.62, 0.80, 0.35},
                                         {0.48, 0.40, 0.80}}};

bool is_exterior(const World& world, RoomId room) {
    return room_info(world, room)->exterior;
}

/// Only who walks meets it.
bool is_clip(const Face& face) {
    return (face.mask & (kStopsSight | kStopsShots | kStopsLiquid)) == 0;
}

}  // namespace

std::vector<RoomId> rooms_of_faces(std::span<const Face> faces) {
    std::vector<RoomId> rooms;
    rooms.reserve(faces.size());
    for (const Face& face : faces) rooms.push_back(face.room);
    return rooms;
}

Vec3 room_colour(RoomId room, bool exterior) {
    if (exterior) return kExterior;
    const Vec3 hue = kHues[room.value % kHues.size()];
    switch (room.value / kHues.size() % 3) {
        case 1:
            return mixed(hue, kWhite, 0.35);
        case 2:
            return hue * 0.75;
        default:
            return hue;
    }
}

std::string hex_colour(const Vec3& colour) {
    constexpr char kHex[] = "0123456789abcdef";
    std::string text = "#";
    for (int part = 0; part < 3; ++part) {
        const int value = int(std::clamp(colour[part], 0.0, 1.0) * 255 + 0.5);
        text += kHex[value / 16];
        text += kHex[value % 16];
    }
    return text;
}

std::string room_label(const World& world, RoomId room) {
    std::string label = std::to_string(room.value);
    const std::string_view name = room_info(world, room)->name;
    if (!name.empty()) label.append(" ").append(name);
    return label;
}

std::size_t count_inner_rooms(const World& world) {
    std::size_t count = 0;
    for (std::uint32_t id = 0; id < world.room_count(); ++id) {
        const RoomInfo room = *room_info(world, {id});
        count += room.faces > 0 && !room.exterior;
    }
    return count;
}

std::vector<Face> faces_to_show(const World& world) {
    std::vector<Face> faces = world.faces();
    const auto outside = std::size_t(
        std::count_if(faces.begin(), faces.end(), [&](const Face& f) { return is_exterior(world, f.room); }));
    const bool whole = 2 * outside > faces.size();
    std::vector<Face> shown;
    for (std::size_t k = 0; k < faces.size(); ++k)
        if ((whole || !is_exterior(world, faces[k].room)) && !is_clip(faces[k])) shown.push_back(std::move(faces[k]));
    return shown;
}

}  // namespace firma::draw

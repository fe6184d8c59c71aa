// SPDX-License-Identifier: MIT
// Looks each of the entities up in the finished world.
#include "brush/name_rooms.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "firma/rooms.h"
#include "level/parse_number.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// Three numbers with blanks between them.
std::optional<Vec3> parse_place(std::string_view text) {
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        const std::string_view word = text.substr(0, text.find(' '));
        const std::optional<double> number = parse_number(word);
        if (!number) return std::nullopt;
        place[axis] = *number;
        text.remove_prefix(word.size());
    }
    if (text.find_first_not_of(' ') != std::string_view::npos) return std::nullopt;
    return place;
}

}  // namespace

World name_rooms(const World& world, const BrushLevel& level) {
    if (!world.data().room_records) return world;
    std::vector<RoomRecord> records = *world.data().room_records;
    bool named = false;
    for (const Entity& entity : level.entities) {
        const std::string_view name = entity.value("name");
        if (entity.value("classname") != "firma_room" || name.empty()) continue;
        const std::optional<Vec3> place = parse_place(entity.value("origin"));
        if (!place) continue;
        const Location found = locate(world, *place * level.metres_a_unit);
        if (found.kind != Location::Kind::kRoom || !records[found.room.value].name.empty()) continue;
        records[found.room.value].name = name;
        named = true;
    }
    if (!named) return world;
    auto data = std::make_shared<WorldData>(world.data());
    data->room_records = std::make_shared<const std::vector<RoomRecord>>(std::move(records));
    return World(std::move(data));
}

}  // namespace firma

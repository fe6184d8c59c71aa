// SPDX-License-Identifier: MIT
// Looks each of the entities up in the finished world.
#include "brush/name_rooms.h"

#include <optional>
#include <utility>

#include "brush/entity_origin.h"
#include "firma/rooms.h"
#include "world/world_data.h"

namespace firma {

World name_rooms(const World& world, const BrushLevel& level) {
    if (!world.data().room_records) return world;
    std::vector<RoomRecord> records = *world.data().room_records;
    bool named = false;
    for (const Entity& entity : level.entities) {
        const std::string_view name = entity.value("name");
        if (entity.value("classname") != "firma_room" || name.empty()) continue;
        const std::optional<Vec3> place = entity_origin(level, entity);
        if (!place) continue;
        const Location found = locate(world, *place);
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

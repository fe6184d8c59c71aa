// SPDX-License-Identifier: MIT
// Looks each of the entities up in the finished world.
#include "brush/name_rooms.h"

#include <optional>
#include <utility>

#include "firma/brush_level.h"
#include "firma/rooms.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// Names the room that an entity stands in.
/// @return why it does not; empty when it does
std::string name_room(const World& world, const BrushLevel& level, const Entity& entity, WorldData& named) {
    const std::string_view name = entity.value("name");
    if (name.empty()) return "it has no name";
    const std::optional<Vec3> place = entity_origin(level, entity);
    if (!place) return "it has no origin of three numbers";
    const Location found = locate(world, *place);
    if (found.where != Where::kAir)
        return found.where == Where::kSolid ? "it stands in the solid" : "it stands on a face";
    const std::uint32_t room = found.room.value;
    RoomRecord record = named.cells.room(room);
    if (!record.name.empty()) return "the room it stands in has the name '" + record.name + "' already";
    record.name = name;
    named.set_room(room, std::make_shared<const RoomRecord>(std::move(record)), named.room_faces[room]);
    return "";
}

}  // namespace

World name_rooms(const World& world, const BrushLevel& level, std::vector<EntityNote>* notes) {
    if (!world.data().cells.known()) return world;
    auto data = std::make_shared<WorldData>(world.data());
    bool named = false;
    for (std::uint32_t k = 0; k < level.entities.size(); ++k) {
        if (level.entities[k].value("classname") != "firma_room") continue;
        std::string why_not = name_room(world, level, level.entities[k], *data);
        named = named || why_not.empty();
        if (notes && !why_not.empty()) notes->push_back({k, std::move(why_not)});
    }
    return named ? World(std::move(data)) : world;
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// What rooms and portals are, what leads where, and doors.
#include "firma/rooms.h"

#include <algorithm>

#include "base/assert.h"
#include "world/world_data.h"

namespace firma {
namespace {

bool is_room(const WorldData& data, RoomId room) {
    const bool there = room.value < data.cells.room_count();
    FIRMA_ASSERT(there, "a RoomId must be below World::room_count()");
    return there;
}

bool is_portal(const WorldData& data, PortalId portal) {
    const bool there = portal.value < data.cells.portal_count();
    FIRMA_ASSERT(there, "a PortalId must be below portal_count()");
    return there;
}

bool is_open(const WorldData& data, std::uint32_t portal) {
    return !data.cells.is_closed(portal);
}

void add(Box& bounds, const GridBox& box) {
    bounds.add(to_metres(box.low));
    bounds.add(to_metres(box.high));
}

/// How many portals each room is from one, through what `leads_on`; ~0 where there is no way.
template <class LeadsOn>
std::vector<std::uint32_t> portals_away(const WorldData& data, std::uint32_t from, const LeadsOn& leads_on) {
    std::vector<std::uint32_t> away(data.cells.room_count(), ~0u);
    std::vector<std::uint32_t> reached{from};
    away[from] = 0;
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const std::uint32_t room = reached[next];
        for (const std::uint32_t portal : data.cells.portals_of(room)) {
            const std::uint32_t beyond = data.cells.beyond(data.cells.portal(portal), room);
            if (!leads_on(portal) || away[beyond] != ~0u) continue;
            away[beyond] = away[room] + 1;
            reached.push_back(beyond);
        }
    }
    return away;
}

}  // namespace

RoomInfo room_info(const World& world, RoomId room) {
    const WorldData& data = world.data();
    RoomInfo info;
    info.part_of = room;
    if (!is_room(data, room)) return info;
    const RoomRecord& record = data.cells.room(room.value);
    const RoomFaces& faces = data.faces_of(room.value);
    info.faces = faces.count;
    if (faces.tree)
        for_each_block(*faces.tree, [&](const Block& block) {
            for (const GridPoint& vertex : block.vertices) info.bounds.add(to_metres(vertex));
        });
    for (const std::uint32_t portal : record.portals) {
        info.portals.push_back({portal});
        add(info.bounds, data.cells.portal(portal).box);
    }
    info.name = record.name;
    info.exterior = record.exterior;
    info.part_of = {data.cells.current_room(room.value)};
    return info;
}

std::size_t portal_count(const World& world) {
    return world.data().cells.portal_count();
}

PortalInfo portal_info(const World& world, PortalId id) {
    const WorldData& data = world.data();
    PortalInfo info;
    if (!is_portal(data, id)) return info;
    const Portal& portal = data.cells.portal(id.value);
    info.rooms = data.cells.rooms_of(portal);
    info.name = portal.name;
    info.material = portal.material;
    info.mask = portal.mask;
    info.open = is_open(data, id.value);
    for (const PortalPolygon& polygon : portal.polygons())
        info.polygons.emplace_back(polygon.shape.corners.begin(), polygon.shape.corners.end());
    if (!portal.gone()) add(info.bounds, portal.box);
    return info;
}

std::vector<RoomId> neighbours(const World& world, RoomId room) {
    const WorldData& data = world.data();
    std::vector<RoomId> rooms;
    if (!is_room(data, room)) return rooms;
    const RoomId here{data.cells.current_room(room.value)};
    for (const std::uint32_t portal : data.cells.portals_of(here.value))
        rooms.push_back({data.cells.beyond(data.cells.portal(portal), here.value)});
    std::sort(rooms.begin(), rooms.end());
    rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
    return rooms;
}

std::optional<std::vector<PortalId>> find_path(const World& world, RoomId from, RoomId to, Doors doors) {
    const WorldData& data = world.data();
    if (!is_room(data, from) || !is_room(data, to)) return {};
    const auto leads_on = [&](std::uint32_t portal) { return doors == Doors::kAllOpen || is_open(data, portal); };
    std::uint32_t room = data.cells.current_room(from.value);
    const std::vector<std::uint32_t> away = portals_away(data, data.cells.current_room(to.value), leads_on);
    if (away[room] == ~0u) return {};
    std::vector<PortalId> path;
    while (away[room] > 0)
        for (const std::uint32_t portal : data.cells.portals_of(room)) {
            const std::uint32_t beyond = data.cells.beyond(data.cells.portal(portal), room);
            if (!leads_on(portal) || away[beyond] + 1 != away[room]) continue;
            path.push_back({portal});
            room = beyond;
            break;
        }
    return path;
}

World set_portal_open(const World& world, PortalId portal, bool open) {
    const WorldData& data = world.data();
    if (!is_portal(data, portal) || is_open(data, portal.value) == open) return world;
    auto next = next_version(data);
    next->cells.set_portal(portal.value, data.cells.portals()[portal.value].portal, !open);
    return World(std::move(next));
}

}  // namespace firma

// SPDX-License-Identifier: MIT
// What rooms and portals are, what leads where, and doors.
#include "firma/rooms.h"

#include <algorithm>

#include "world/world_data.h"

namespace firma {
namespace {

bool is_room(const WorldData& data, RoomId room) {
    return room.value < data.cells.room_count();
}

bool is_portal(const WorldData& data, PortalId portal) {
    return portal.value < data.cells.portal_count();
}

bool is_open(const WorldData& data, std::uint32_t portal) {
    return !data.cells.is_closed(portal);
}

void add(Box& bounds, const GridBox& box) {
    bounds.add(to_metres(box.low));
    bounds.add(to_metres(box.high));
}

/// How many portals rooms are from one, through what `leads_on`: of all that are no farther than `until`; ~0 where
/// there is no way.
template <class LeadsOn>
std::vector<std::uint32_t> portals_away(const WorldData& data, std::uint32_t from, std::uint32_t until,
                                        const LeadsOn& leads_on) {
    std::vector<std::uint32_t> away(data.cells.room_count(), ~0u);
    std::vector<std::uint32_t> reached{from};
    away[from] = 0;
    for (std::size_t next = 0; next < reached.size() && away[until] == ~0u; ++next) {
        const std::uint32_t room = reached[next];
        for (const PortalId portal : data.cells.portals_of(room)) {
            const std::uint32_t beyond = data.cells.beyond(data.cells.portal(portal.value), room);
            if (!leads_on(portal) || away[beyond] != ~0u) continue;
            away[beyond] = away[room] + 1;
            reached.push_back(beyond);
        }
    }
    return away;
}

}  // namespace

std::optional<RoomInfo> room_info(const World& world, RoomId room) {
    const WorldData& data = world.data();
    if (!is_room(data, room)) return {};
    const RoomRecord& record = data.cells.room(room.value);
    const RoomFaces& faces = data.faces_of(room.value);
    RoomInfo info;
    info.name = record.name;
    info.faces = faces.count;
    info.exterior = record.exterior;
    info.merged_into = {data.cells.current_room(room.value)};
    info.portals = record.portals;
    if (faces.tree) {
        const BoxF box = to_floats(faces.tree->box);
        info.bounds.add(Vec3{box.low[0], box.low[1], box.low[2]});
        info.bounds.add(Vec3{box.high[0], box.high[1], box.high[2]});
    }
    if (!record.portals.empty()) add(info.bounds, record.portal_box);
    return info;
}

std::optional<RoomId> find_room(const World& world, std::string_view name) {
    const Cells& cells = world.data().cells;
    for (std::uint32_t k = 0; !name.empty() && k < cells.room_count(); ++k)
        if (cells.room(k).name == name) return RoomId{k};
    return {};
}

std::optional<PortalId> find_portal(const World& world, std::string_view name) {
    const Cells& cells = world.data().cells;
    for (std::uint32_t k = 0; !name.empty() && k < cells.portal_count(); ++k)
        if (cells.portal(k).name == name) return PortalId{k};
    return {};
}

RoomId room_of(const World& world, const Hit& hit) {
    if (hit.portal.valid()) {
        const WorldData& data = world.data();
        if (!is_portal(data, hit.portal)) return {};
        const Portal& portal = data.cells.portal(hit.portal.value);
        return data.cells.rooms_of(portal)[dot(hit.normal, hit.face_normal) >= 0 ? 0 : 1];
    }
    const std::optional<FaceInfo> face = world.face_info(hit.face);
    return face ? face->room : RoomId{};
}

std::size_t portal_count(const World& world) {
    return world.data().cells.portal_count();
}

std::optional<PortalInfo> portal_info(const World& world, PortalId id) {
    const WorldData& data = world.data();
    if (!is_portal(data, id)) return {};
    const Portal& portal = data.cells.portal(id.value);
    PortalInfo info;
    info.rooms = data.cells.rooms_of(portal);
    info.name = portal.name;
    info.material = portal.material;
    info.mask = portal.mask;
    info.open = is_open(data, id.value);
    info.polygons = portal.polygons().size();
    if (!portal.gone()) add(info.bounds, portal.box);
    return info;
}

std::vector<std::vector<Vec3>> portal_polygons(const World& world, PortalId id) {
    const WorldData& data = world.data();
    std::vector<std::vector<Vec3>> polygons;
    if (!is_portal(data, id)) return polygons;
    for (const PortalPolygon& polygon : data.cells.portal(id.value).polygons())
        polygons.emplace_back(polygon.shape.corners.begin(), polygon.shape.corners.end());
    return polygons;
}

std::vector<RoomId> neighbours(const World& world, RoomId room) {
    const WorldData& data = world.data();
    std::vector<RoomId> rooms;
    if (!is_room(data, room)) return rooms;
    const RoomId here{data.cells.current_room(room.value)};
    for (const PortalId portal : data.cells.portals_of(here.value))
        rooms.push_back({data.cells.beyond(data.cells.portal(portal.value), here.value)});
    std::sort(rooms.begin(), rooms.end());
    rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
    return rooms;
}

std::optional<std::vector<PortalId>> find_path(const World& world, RoomId from, RoomId to, Doors doors) {
    const WorldData& data = world.data();
    if (!is_room(data, from) || !is_room(data, to)) return {};
    const auto leads_on = [&](PortalId portal) { return doors == Doors::kAllOpen || is_open(data, portal.value); };
    std::uint32_t room = data.cells.current_room(from.value);
    const std::vector<std::uint32_t> away = portals_away(data, data.cells.current_room(to.value), room, leads_on);
    if (away[room] == ~0u) return {};
    std::vector<PortalId> path;
    while (away[room] > 0)
        for (const PortalId portal : data.cells.portals_of(room)) {
            const std::uint32_t beyond = data.cells.beyond(data.cells.portal(portal.value), room);
            if (!leads_on(portal) || away[beyond] + 1 != away[room]) continue;
            path.push_back(portal);
            room = beyond;
            break;
        }
    return path;
}

std::optional<World> set_portal_open(const World& world, PortalId portal, bool open) {
    const WorldData& data = world.data();
    if (!is_portal(data, portal)) return {};
    if (is_open(data, portal.value) == open) return world;
    if (data.cells.portal(portal.value).polygons().empty()) return world;  // removed: it leads nowhere
    auto next = next_version(data);
    next->cells.set_portal(portal.value, data.cells.portals()[portal.value].portal, !open);
    return World(std::move(next));
}

}  // namespace firma

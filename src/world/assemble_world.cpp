// SPDX-License-Identifier: MIT
// From rooms, portals and options to a World.
#include "world/assemble_world.h"

#include <algorithm>

#include "tree/build_blocks.h"
#include "tree/rounded_box.h"
#include "tree/visit.h"
#include "world/world_data.h"

namespace firma {
namespace {

constexpr std::size_t kMost = std::size_t(1) << 31;

/// With fewer rooms, casts go through all of their boxes.
constexpr std::size_t kManyRooms = 16;

Error portal_error(const WorldParts& parts, std::size_t portal, const char* reason) {
    std::string which = "portal " + std::to_string(portal);
    if (!parts.portals[portal].name.empty()) which += " (" + parts.portals[portal].name + ")";
    return {ErrorCode::kInvalid, parts.name.empty() ? which : parts.name + ": " + which, reason};
}

/// Why a portal cannot enter a world, or null.
const char* refusal(const PortalPart& portal, std::size_t rooms) {
    for (const RoomId room : portal.rooms)
        if (room.value >= rooms) return "it leads to a room that is not there";
    if (portal.polygons.empty()) return nullptr;
    if (portal.rooms[0] == portal.rooms[1]) return "it leads from a room to itself";
    for (const std::vector<GridPoint>& polygon : portal.polygons)
        if (polygon.size() < 3 || polygon.size() > std::size_t(kMaxCorners)) return "a polygon has not 3 to 64 corners";
    return nullptr;
}

std::optional<Error> check(const WorldParts& parts) {
    std::size_t faces = 0, exteriors = 0;
    for (const RoomPart& room : parts.rooms) {
        faces += room.faces.faces.size();
        exteriors += room.exterior;
    }
    if (faces >= kMost || parts.rooms.size() >= kMost || parts.portals.size() >= kMost)
        return Error{ErrorCode::kTooLarge, parts.name, "a world holds fewer than 2^31 faces, rooms and portals"};
    if (parts.rooms.empty()) return Error{ErrorCode::kInvalid, parts.name, "a world has at least one room"};
    if (exteriors + parts.rock_outside > 1)
        return Error{ErrorCode::kInvalid, parts.name, "more than one room, or rock as well, reaches to infinity"};
    for (std::size_t k = 0; k < parts.portals.size(); ++k)
        if (const char* reason = refusal(parts.portals[k], parts.rooms.size())) return portal_error(parts, k, reason);
    return {};
}

/// Nothing to say of the one room of a level that knows no rooms.
bool is_plain(const WorldParts& parts) {
    return parts.rooms.size() == 1 && parts.rooms[0].name.empty() && !parts.rooms[0].exterior && parts.portals.empty();
}

void add_rooms(WorldParts& parts, WorldData& data) {
    std::uint32_t highest = 0;
    for (RoomPart& part : parts.rooms) {
        Ref<Room> room(new Room);
        room->tree = build_blocks(part.faces, parts.options.tree);
        data.rooms.emplace_back(room.get());
        data.face_count += part.faces.faces.size();
        for (const FaceSet::Entry& face : part.faces.faces) highest = std::max(highest, face.id.value + 1);
        part.faces = {};
    }
    data.next_face = highest;
}

void add_records(WorldParts& parts, WorldData& data) {
    std::vector<RoomRecord> records;
    for (std::uint32_t k = 0; k < parts.rooms.size(); ++k)
        records.push_back({std::move(parts.rooms[k].name), parts.rooms[k].exterior, k});
    data.room_records = std::make_shared<const std::vector<RoomRecord>>(std::move(records));
    if (parts.portals.empty()) return;
    data.portals = std::make_shared<const PortalSet>(parts.portals, parts.rooms.size());
    std::vector<std::uint8_t> closed;
    for (const PortalPart& portal : parts.portals) closed.push_back(!portal.open);
    if (std::count(closed.begin(), closed.end(), 1) > 0)
        data.closed = std::make_shared<const ClosedPortals>(std::move(closed));
}

bool contains(const GridBox& outer, const GridBox& inner) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
    return true;
}

/// Rooms without faces are where no cast comes: a box of one point, and nothing in it.
GridBox box_of(const Room& room) {
    if (room.tree) return to_grid(room.tree->bins[0].box);
    return {{0, 0, 0}, {0, 0, 0}};
}

}  // namespace

void fit_room_boxes(WorldData& data) {
    if (data.rooms.size() < kManyRooms) return data.room_boxes.reset();
    std::vector<GridBox> boxes;
    for (const Ref<const Room>& room : data.rooms) boxes.push_back(box_of(*room));
    if (data.room_boxes && data.room_boxes->size() == boxes.size()) {
        bool fits = true;
        for (const BoxTree::Item& item : data.room_boxes->items()) fits &= contains(item.box, boxes[item.number]);
        if (fits) return;
    }
    data.room_boxes = std::make_shared<const BoxTree>(boxes);
}

void finish_rooms(WorldData& data) {
    fit_room_boxes(data);
    if (!data.room_records) return;
    data.knows_walls = data.rooms.size() == 1;
    for (const Ref<const Room>& room : data.rooms)
        if (room->tree)
            for_each_face_block(*room->tree, [&](const Block& block) {
                for (const FaceRecord& face : block.faces) data.knows_walls |= face.solid;
            });
}

Result<World> assemble_world(WorldParts parts) {
    if (std::optional<Error> error = check(parts)) return *error;
    auto data = std::make_shared<WorldData>();
    const bool plain = is_plain(parts);
    add_rooms(parts, *data);
    if (!plain) add_records(parts, *data);
    finish_rooms(*data);
    data->materials = std::make_shared<std::vector<std::string>>(std::move(parts.materials));
    data->tolerance = parts.options.tolerance;
    data->tree_options = parts.options.tree;
    data->rock_outside = parts.rock_outside;
    data->rules = std::make_shared<const CarveRules>(std::move(parts.options.rules));
    return World(std::move(data));
}

}  // namespace firma

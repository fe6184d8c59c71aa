// SPDX-License-Identifier: MIT
// Rooms and portals: where a point is, what leads where, doors.
#include "firma/rooms.h"

#include <algorithm>
#include <string>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "geometry/rounding.h"
#include "world/world_data.h"

namespace firma::c {
namespace {

firma_code check_room(const World& world, std::uint32_t room, const char* function) {
    if (room < world.room_count()) return FIRMA_OK;
    return fail(FIRMA_ERROR_INVALID, function, "the world has no room " + std::to_string(room));
}

firma_code check_portal(const World& world, std::uint32_t portal, const char* function) {
    if (portal < portal_count(world)) return FIRMA_OK;
    return fail(FIRMA_ERROR_INVALID, function, "the world has no portal " + std::to_string(portal));
}

/// Ids of rooms or portals, as many as fit.
template <class Id>
void put_ids(const std::vector<Id>& ids, std::uint32_t* out, std::size_t capacity, std::size_t* count) {
    *count = ids.size();
    for (std::size_t k = 0; k < std::min(capacity, ids.size()); ++k) out[k] = ids[k].value;
}

void put_box(const Box& box, double (&low)[3], double (&high)[3]) {
    put(box.low, low);
    put(box.high, high);
}

/// A portal's polygon as a face that both sides meet.
FaceInfo as_face(const PortalInfo& portal, std::uint32_t id, const std::vector<Vec3>& corners) {
    FaceInfo face;
    face.source = id;
    face.material = portal.material;
    face.mask = portal.mask;
    face.two_sided = true;
    Vec3 twice;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        twice = twice + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    face.normal = twice * (1 / length(twice));
    return face;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_world_locate(firma_world world, const double point[3], uint32_t* where, uint32_t* room) {
    return guarded(__func__, [&, function = __func__] {
        if (!point || !where) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Vec3 at{point[0], point[1], point[2]};
        if (!is_finite(at) || max_abs(at) > kLargestNumber)
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a coordinate is not finite or too large");
        const Location found = locate(object->world, at);
        static_assert(int(Where::kAir) == FIRMA_AIR && int(Where::kSolid) == FIRMA_SOLID &&
                      int(Where::kSurface) == FIRMA_SURFACE && int(Where::kUnknown) == FIRMA_UNKNOWN);
        *where = std::uint32_t(found.where);
        if (room) *room = found.room.value;
        return FIRMA_OK;
    });
}

firma_code firma_world_room(firma_world world, uint32_t room, firma_room* to) {
    return guarded(__func__, [&, function = __func__] {
        if (!to) return bad_call(function, kNull);
        if (!sized(to)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = check_room(object->world, room, function)) return code;
        const RoomInfo info = *room_info(object->world, {room});
        const RoomRecord& record = object->world.data().cells.room(room);
        firma_room out{};
        put_box(info.bounds, out.low, out.high);
        out.face_count = info.faces;
        out.name = record.name.c_str();
        static_assert(sizeof(PortalId) == sizeof(std::uint32_t));
        out.portals = reinterpret_cast<const std::uint32_t*>(record.portals.data());
        out.portal_count = record.portals.size();
        out.exterior = info.exterior;
        out.merged_into = info.merged_into.value;
        put_sized(out, to);
        return FIRMA_OK;
    });
}

firma_code firma_world_find_room(firma_world world, const char* name, uint32_t* room) {
    return guarded(__func__, [&, function = __func__] {
        if (!name || !room) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *room = find_room(object->world, name).value_or(RoomId{}).value;
        return FIRMA_OK;
    });
}

firma_code firma_world_find_portal(firma_world world, const char* name, uint32_t* portal) {
    return guarded(__func__, [&, function = __func__] {
        if (!name || !portal) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *portal = find_portal(object->world, name).value_or(PortalId{}).value;
        return FIRMA_OK;
    });
}

firma_code firma_world_portal(firma_world world, uint32_t portal, firma_portal* to) {
    return guarded(__func__, [&, function = __func__] {
        if (!to) return bad_call(function, kNull);
        if (!sized(to)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = check_portal(object->world, portal, function)) return code;
        const PortalInfo info = *portal_info(object->world, {portal});
        firma_portal out{};
        put_box(info.bounds, out.low, out.high);
        out.name = object->world.data().cells.portal(portal).name.c_str();
        for (std::size_t k = 0; k < 2; ++k) out.rooms[k] = info.rooms[k].value;
        out.material = info.material;
        out.mask = info.mask;
        out.open = info.open;
        out.polygon_count = std::uint32_t(info.polygons);
        put_sized(out, to);
        return FIRMA_OK;
    });
}

firma_code firma_world_portal_polygons(firma_world world, uint32_t portal, firma_faces* polygons) {
    return guarded(__func__, [&, function = __func__] {
        if (!polygons) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = check_portal(object->world, portal, function)) return code;
        const PortalInfo info = *portal_info(object->world, {portal});
        auto list = std::make_unique<FacesObject>();
        for (const std::vector<Vec3>& corners : portal_polygons(object->world, {portal}))
            list->list.add(as_face(info, portal, corners), corners);
        return give(std::move(list), polygons, function);
    });
}

firma_code firma_world_set_portal_open(firma_world world, uint32_t portal, uint32_t open, firma_world* after) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (open > 1) return fail(FIRMA_ERROR_INVALID, function, "open must be 0 or 1");
        if (const firma_code code = check_portal(object->world, portal, function)) return code;
        return give(std::make_unique<WorldObject>(*set_portal_open(object->world, {portal}, open == 1)), after,
                    function);
    });
}

firma_code firma_world_neighbours(firma_world world, uint32_t room, uint32_t* rooms, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!rooms && capacity)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = check_room(object->world, room, function)) return code;
        put_ids(neighbours(object->world, {room}), rooms, capacity, count);
        return FIRMA_OK;
    });
}

firma_code firma_world_path(firma_world world, uint32_t from, uint32_t to, uint32_t all_open, uint32_t* portals,
                            size_t capacity, size_t* count, uint32_t* found) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || !found || (!portals && capacity)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (all_open > 1) return fail(FIRMA_ERROR_INVALID, function, "all_open must be 0 or 1");
        for (const std::uint32_t room : {from, to})
            if (const firma_code code = check_room(object->world, room, function)) return code;
        const auto way = find_path(object->world, {from}, {to}, all_open ? Doors::kAllOpen : Doors::kAsTheyAre);
        *found = way.has_value();
        put_ids(way.value_or(std::vector<PortalId>()), portals, capacity, count);
        return FIRMA_OK;
    });
}

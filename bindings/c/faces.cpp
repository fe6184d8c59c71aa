// SPDX-License-Identifier: MIT
// Faces of a world, and what changed between two.
#include "base/sort.h"
#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/solid.h"

namespace firma::c {

namespace {

firma_face plain(const FaceInfo& face, std::size_t first_corner, std::size_t corner_count) {
    firma_face out{};
    put(face.normal, out.normal);
    out.id = face.id.value;
    out.source = face.source;
    out.source_edit = face.source_edit;
    out.material = face.material;
    out.mask = face.mask;
    out.flags = face_flags(face);
    out.room = face.room.value;
    out.first_corner = std::uint32_t(first_corner);
    out.corner_count = std::uint32_t(corner_count);
    put_corner(face.ref(), out.corner);
    return out;
}

}  // namespace

void FaceList::add(const FaceInfo& face, std::span<const Vec3> outline) {
    faces.push_back(plain(face, corners.size() / 3, outline.size()));
    for (const Vec3& corner : outline) corners.insert(corners.end(), {corner.x, corner.y, corner.z});
}

namespace {

FaceList all_of(const World& world) {
    FaceList all;
    all.faces.reserve(world.face_count());
    each_face(world, [&](const FaceView& face) {
        all.add(face, face.corners);
        return true;
    });
    return all;
}

/// The same in order of id, their corners too.
FaceList by_id(FaceList given) {
    sort_range(given.faces, [](const firma_face& a, const firma_face& b) { return a.id < b.id; });
    FaceList ordered;
    ordered.corners.reserve(given.corners.size());
    for (firma_face& face : given.faces) {
        const auto first = given.corners.begin() + 3 * std::ptrdiff_t(face.first_corner);
        face.first_corner = std::uint32_t(ordered.corners.size() / 3);
        ordered.corners.insert(ordered.corners.end(), first, first + 3 * std::ptrdiff_t(face.corner_count));
    }
    ordered.faces = std::move(given.faces);
    return ordered;
}

/// Faces by a caller's filter, null for all. `completed` gets whether the visitor let it come to an end.
firma_code each_of(const World& world, const firma_face_filter* given, FaceVisitor visit, bool& completed,
                   const char* function) {
    firma_face_filter filter;
    firma_face_filter_defaults(&filter);
    if (given && !sized(given)) return bad_call(function, kWrongSize);
    if (given) take_sized(given, filter);
    const bool in_room = filter.room != FIRMA_ANY_ROOM;
    if (int(in_room) + (filter.box != nullptr) + (filter.region != nullptr) > 1)
        return fail(FIRMA_ERROR_INVALID, function, "at most one of room, box and region");
    if (in_room && filter.room >= world.room_count())
        return fail(FIRMA_ERROR_INVALID, function, "the world has no room " + std::to_string(filter.room));
    if (filter.box) {
        const double* b = filter.box;
        const Box box{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
        if (!is_finite(box.low) || !is_finite(box.high))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a corner of the box is not finite");
        completed = each_face(world, box, visit);
    } else if (filter.region) {
        completed = each_face(world, Region{filter.region[0], filter.region[1], filter.region[2]}, visit);
    } else {
        completed = each_face(world, RoomId{filter.room}, visit);
    }
    return FIRMA_OK;
}

/// Ids are plain numbers to C.
template <class Id>
void put_ids(const std::vector<Id>& ids, const std::uint32_t*& out, std::size_t& count) {
    static_assert(sizeof(Id) == sizeof(std::uint32_t));
    out = reinterpret_cast<const std::uint32_t*>(ids.data());
    count = ids.size();
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_world_faces(firma_world world, firma_faces* faces) {
    return guarded(__func__, [&, function = __func__] {
        if (!faces) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        auto list = std::make_unique<FacesObject>();
        list->list = by_id(all_of(object->world));
        return give(std::move(list), faces, function);
    });
}

firma_code firma_world_find_face(firma_world world, uint32_t id, firma_faces* faces) {
    return guarded(__func__, [&, function = __func__] {
        if (!faces) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        auto list = std::make_unique<FacesObject>();
        if (const std::optional<Face> face = object->world.find_face({id})) list->list.add(*face, face->corners);
        return give(std::move(list), faces, function);
    });
}

void firma_face_filter_defaults(firma_face_filter* filter) {
    if (filter) *filter = {sizeof(firma_face_filter), FIRMA_ANY_ROOM, nullptr, nullptr};
}

firma_code firma_world_faces_in(firma_world world, const firma_face_filter* filter, firma_faces* faces) {
    return guarded(__func__, [&, function = __func__] {
        if (!faces) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        auto list = std::make_unique<FacesObject>();
        const auto add = [&](const FaceView& face) {
            list->list.add(face, face.corners);
            return true;
        };
        bool completed = false;
        if (const firma_code code = each_of(object->world, filter, add, completed, function)) return code;
        return give(std::move(list), faces, function);
    });
}

firma_code firma_world_each_face(firma_world world, const firma_face_filter* filter, firma_face_visitor visit,
                                 void* user, uint32_t* completed) {
    return guarded(__func__, [&, function = __func__] {
        if (!visit) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const auto show = [&](const FaceView& face) {
            static_assert(sizeof(Vec3) == 3 * sizeof(double));
            const firma_face shown = plain(face, 0, face.corners.size());
            return visit(&shown, &face.corners[0].x, user) != 0;
        };
        const World held = object->world;  // which the visitor may release
        bool all = false;
        if (const firma_code code = each_of(held, filter, show, all, function)) return code;
        if (completed) *completed = all;
        return FIRMA_OK;
    });
}

firma_code firma_world_face(firma_world world, uint32_t id, const int32_t corner[3], firma_faces* faces) {
    return guarded(__func__, [&, function = __func__] {
        if (!corner || !faces) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        auto list = std::make_unique<FacesObject>();
        const std::optional<Face> face = object->world.face({{id}, {corner[0], corner[1], corner[2]}});
        if (!face)
            return fail(FIRMA_ERROR_INVALID, function, "the world has no such face: cut since, or of another world");
        list->list.add(*face, face->corners);
        return give(std::move(list), faces, function);
    });
}

firma_code firma_world_texture(firma_world world, uint32_t face, const int32_t corner[3], firma_texture* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const World& w = object->world;
        std::optional<FaceInfo> info;
        if (corner) {
            info = w.face_info({{face}, {corner[0], corner[1], corner[2]}});
        } else if (const std::optional<Face> found = w.find_face({face})) {
            info = *found;
        }
        if (!info) return fail(FIRMA_ERROR_INVALID, function, "the world has no such face");
        const TextureProjection lies = texture_of(w, info->ref()).value_or(box_projection(info->normal));
        firma_texture texture{};
        put(lies.u_axis, texture.u_axis);
        put(lies.v_axis, texture.v_axis);
        texture.u_offset = lies.u_offset;
        texture.v_offset = lies.v_offset;
        texture.unit = std::uint32_t(lies.unit);
        put_sized(texture, out);
        return FIRMA_OK;
    });
}

firma_code firma_faces_get_view(firma_faces faces, firma_faces_view* view) {
    return guarded(__func__, [&, function = __func__] {
        if (!view) return bad_call(function, kNull);
        if (!sized(view)) return bad_call(function, kWrongSize);
        const FacesObject* object = find<FacesObject>(faces.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const FaceList& list = object->list;
        put_sized({0, list.faces.data(), list.faces.size(), list.corners.data(), list.corners.size() / 3}, view);
        return FIRMA_OK;
    });
}

firma_code firma_faces_release(firma_faces faces) {
    return release<FacesObject>(faces.id, __func__);
}

firma_code firma_world_diff(firma_world before, firma_world after, double tile_size, firma_diff* diff) {
    return guarded(__func__, [&, function = __func__] {
        if (!diff) return bad_call(function, kNull);
        const WorldObject* first = find<WorldObject>(before.id, function);
        const WorldObject* second = first ? find<WorldObject>(after.id, function) : nullptr;
        if (!second) return FIRMA_ERROR_BAD_HANDLE;
        if (tile_size != 0 && (!(tile_size >= kMinTileSize) || !is_finite(tile_size)))
            return fail(FIRMA_ERROR_INVALID, function, "the size of a tile must be 0, or 1/16 m and more");
        auto made = std::make_unique<DiffObject>();
        made->diff = diff_worlds(first->world, second->world, tile_size);
        for (const FaceInfo& face : made->diff.removed) {
            made->removed.push_back(face.id.value);
            made->removed_faces.push_back(plain(face, 0, 0));
        }
        for (const FaceInfo& face : made->diff.added)
            if (const std::optional<Face> whole = second->world.face(face.ref()))
                made->added.add(*whole, whole->corners);
        return give(std::move(made), diff, function);
    });
}

firma_code firma_diff_get_view(firma_diff diff, firma_diff_view* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const DiffObject* object = find<DiffObject>(diff.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        static_assert(sizeof(Tile) == 3 * sizeof(std::int32_t));
        firma_diff_view view{};
        view.removed = object->removed.data();
        view.removed_faces = object->removed_faces.data();
        view.removed_count = object->removed.size();
        view.added = object->added.faces.data();
        view.added_count = object->added.faces.size();
        view.corners = object->added.corners.data();
        view.corner_count = object->added.corners.size() / 3;
        put_ids(object->diff.rooms, view.rooms, view.room_count);
        put_ids(object->diff.opened, view.opened, view.opened_count);
        put_ids(object->diff.closed, view.closed, view.closed_count);
        put_ids(object->diff.portals_added, view.portals_added, view.portals_added_count);
        put_ids(object->diff.portals_removed, view.portals_removed, view.portals_removed_count);
        put_ids(object->diff.portals_changed, view.portals_changed, view.portals_changed_count);
        view.tiles = object->diff.tiles.empty() ? nullptr : object->diff.tiles[0].data();
        view.tile_count = object->diff.tiles.size();
        put(object->diff.bounds.low, view.low);
        put(object->diff.bounds.high, view.high);
        view.too_many_tiles = object->diff.too_many_tiles;
        put_sized(view, out);
        return FIRMA_OK;
    });
}

firma_code firma_diff_release(firma_diff diff) {
    return release<DiffObject>(diff.id, __func__);
}

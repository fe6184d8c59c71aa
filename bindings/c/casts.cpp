// SPDX-License-Identifier: MIT
// Questions to a world. Those that answer one struct take no memory, no lock, and count no reference.
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/rooms.h"

using namespace firma;
using namespace firma::c;

void firma_cast_options_defaults(firma_cast_options* options) {
    if (!options) return;
    *options = {};
    options->size = sizeof(firma_cast_options);
    options->mask = ~0u;
    options->room = FIRMA_ANY_ROOM;
    options->contact_offset = -1;
}

firma_code firma_cast(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                      firma_hit* hit, firma_cast_counts* counts) {
    return guarded(__func__, [&, function = __func__] {
        if (!input || !hit) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        TrailOptions chosen;
        if (const firma_code code = chosen.read(options, function)) return code;
        CastCounts seen;
        if (counts) chosen.cast.counts = &seen;
        put_hit(cast(object->world, sphere_of(*input), vec(input->path), chosen.cast), *hit);
        chosen.put();
        if (counts) add(seen, *counts);
        return FIRMA_OK;
    });
}

firma_code firma_cast_any(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                          uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        if (!input || !status) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        CastOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        *status = std::uint32_t(cast_any(object->world, sphere_of(*input), vec(input->path), chosen));
        return FIRMA_OK;
    });
}

firma_code firma_cast_all(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                          firma_hit* hits, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!input || !count || (!hits && capacity)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        CastOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        std::vector<Hit> found;
        if (cast_all(object->world, sphere_of(*input), vec(input->path), found, chosen) == Status::kInvalid)
            return not_cast(object->world, chosen.room, function);
        put_some(found, hits, capacity, count, put_hit);
        return FIRMA_OK;
    });
}

firma_code firma_cast_each(firma_world world, const firma_cast_input* input, const firma_cast_options* options,
                           firma_hit_visitor visit, void* user, uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        if (!input || !visit) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        CastOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        const auto show = [&](const Hit& hit) {
            firma_hit shown;
            put_hit(hit, shown);
            return visit(&shown, user);
        };
        const World held = object->world;  // which the visitor may release
        const Status met = cast_each(held, sphere_of(*input), vec(input->path), show, chosen);
        if (status) *status = std::uint32_t(met);
        return FIRMA_OK;
    });
}

firma_code firma_world_hit_info(firma_world world, const firma_hit* hit, firma_hit_info* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!hit || !out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        firma_hit_info info{};
        info.other_face = FIRMA_NO_FACE;
        if (hit->portal != FIRMA_NO_PORTAL) {
            const std::optional<PortalInfo> portal = portal_info(object->world, {hit->portal});
            if (!portal) return fail(FIRMA_ERROR_INVALID, function, "the world has no such portal");
            info.mask = portal->mask;
            info.room = portal->rooms[dot(vec(hit->normal), vec(hit->face_normal)) >= 0 ? 0 : 1].value;
        } else {
            const std::optional<FaceInfo> face = object->world.face_info(face_of(*hit));
            if (!face)
                return fail(FIRMA_ERROR_INVALID, function,
                            hit->face == FIRMA_NO_FACE ? "the hit is of no face: it is a miss"
                                                       : "the world has no such face: cut since, or of another world");
            info.room = face->room.value;
            info.source = face->source;
            info.source_edit = face->source_edit;
            info.mask = face->mask;
            info.flags = face_flags(*face);
            if (hit->feature == FIRMA_EDGE)
                info.other_face = other_face(object->world, face->ref(), hit->feature_index).value;
        }
        put_sized(info, out);
        return FIRMA_OK;
    });
}

void firma_near_options_defaults(firma_near_options* options) {
    if (!options) return;
    *options = {sizeof(firma_near_options), ~0u, FIRMA_ANY_ROOM, 0};
}

firma_code firma_overlap(firma_world world, const double centre[3], double radius, const firma_near_options* options,
                         firma_near* found, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!centre || !count || (!found && capacity)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        NearOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        std::vector<Overlap> near;
        if (overlap(object->world, {{centre[0], centre[1], centre[2]}, radius}, near, chosen) == Status::kInvalid)
            return not_asked(object->world, chosen.room, kBadSphere, function);
        put_some(near, found, capacity, count, put_overlap);
        return FIRMA_OK;
    });
}

firma_code firma_overlap_each(firma_world world, const double centre[3], double radius,
                              const firma_near_options* options, firma_overlap_visitor visit, void* user,
                              uint32_t* found) {
    return guarded(__func__, [&, function = __func__] {
        if (!centre || !visit) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        NearOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        const auto show = [&](const Overlap& overlap) {
            firma_near shown;
            put_overlap(overlap, shown);
            return visit(&shown, user) != 0;
        };
        const World held = object->world;  // which the visitor may release
        const Status met = overlap_each(held, {{centre[0], centre[1], centre[2]}, radius}, show, chosen);
        if (met == Status::kInvalid) return not_asked(held, chosen.room, kBadSphere, function);
        if (found) *found = met != Status::kMiss;
        return FIRMA_OK;
    });
}

firma_code firma_closest(firma_world world, const double point[3], double reach, const firma_near_options* options,
                         firma_near* near, uint32_t* found) {
    return guarded(__func__, [&, function = __func__] {
        if (!point || !near || !found) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        NearOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        const NearFace nearest =
            reach >= 0 ? closest(object->world, {point[0], point[1], point[2]}, reach, chosen) : NearFace{};
        if (!(reach >= 0) || nearest.status == Status::kInvalid)
            return not_asked(object->world, chosen.room, "a number is not finite or too large, or the reach negative",
                             function);
        *found = nearest.found();
        if (nearest.found()) put_near(nearest, *near);
        return FIRMA_OK;
    });
}

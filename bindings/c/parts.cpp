// SPDX-License-Identifier: MIT
// Parts that move: lists of them, and what moving shapes meet and overlap of a level and its parts.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/mover_there.h"
#include "bindings/c/scenes.h"
#include "bindings/c/sphere_sets.h"
#include "firma/cast_set.h"
#include "moving/part_frame.h"

namespace firma::c {

static_assert(FIRMA_NO_PART == kNoPart);

firma_code SceneThere::read(const firma_scene* given, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_scene whole;
    firma_scene_defaults(&whole);
    take_sized(given, whole);
    if (whole.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    const WorldObject* level = find<WorldObject>(whole.world.id, function);
    if (!level) return FIRMA_ERROR_BAD_HANDLE;
    world = &level->world;
    from = whole.from;
    to = whole.to;
    if (whole.parts.id == 0) return FIRMA_OK;
    const PartsObject* object = find<PartsObject>(whole.parts.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    parts = object->parts;
    return FIRMA_OK;
}

RigidMotion motion_of(const firma_motion& from) {
    const double(&turned)[4] = from.rotation;
    return {vec(from.position), {turned[0], turned[1], turned[2], turned[3]}, vec(from.path), vec(from.turn)};
}

namespace {

/// Whether a part can be cast against.
bool takes_part(const MovingPart& part) {
    const Quaternion& turned = part.motion.rotation;
    return is_usable_part(part) && (turned[0] != 0 || turned[1] != 0 || turned[2] != 0 || turned[3] != 0);
}

constexpr const char* kBadMotion = "a motion has a number that is not finite, no rotation, or turns by more than 8";

firma_code read_part(const firma_part* from, MovingPart& part, const char* function) {
    if (!sized(from)) return bad_call(function, kWrongSize);
    firma_part given;
    firma_part_defaults(&given);
    take_sized(from, given);
    const WorldObject* object = find<WorldObject>(given.world.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    if (object->world.room_count() > 1)
        return fail(FIRMA_ERROR_INVALID, function, "a part's world has to be of one room");
    part = MovingPart(object->world, motion_of(given.motion));
    part.mask = given.mask;
    return takes_part(part) ? FIRMA_OK : fail(FIRMA_ERROR_OUT_OF_RANGE, function, kBadMotion);
}

void put_part_hit(const PartHit& hit, firma_part_hit& out) {
    out = {};
    put_hit(hit, out.hit);
    put(hit.surface_velocity, out.surface_velocity);
    out.part = hit.part;
}

void put_part_near(const PartOverlap& overlap, firma_part_near& out) {
    out = {};
    put_overlap(overlap, out.near);
    put(overlap.surface_velocity, out.surface_velocity);
    out.part = overlap.part;
}

void put_nearest(const PartNear& nearest, firma_part_near& out) {
    out = {};
    put_near(nearest, out.near);
    put(nearest.surface_velocity, out.surface_velocity);
    out.part = nearest.part;
}

/// Whether a scene can be asked at a fraction of its stretch.
firma_code judge_time(const SceneThere& asked, double fraction, const char* function) {
    if (asked.has_stretch() && fraction >= 0 && fraction <= 1) return FIRMA_OK;
    return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the fraction or the scene's stretch is not within 0..1");
}

/// What all questions of a shape that moves in a scene begin with.
template <class Work>
firma_code ask_of_scene(const firma_scene* scene, const firma_mover* mover, const char* function, const Work& work) {
    SceneThere asked;
    if (const firma_code code = asked.read(scene, function)) return code;
    MoverThere there;
    if (const firma_code code = there.read(mover, function)) return code;
    return work(asked, there);
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_part_defaults(firma_part* part) {
    if (!part) return;
    *part = {};
    part->size = sizeof *part;
    part->mask = ~0u;
    part->motion.rotation[3] = 1;
}

void firma_scene_defaults(firma_scene* scene) {
    if (!scene) return;
    *scene = {sizeof(firma_scene), 0, {0}, {0}, 0, 1};
}

firma_code firma_parts_create(firma_parts* parts) {
    return guarded(__func__, [&, function = __func__] {
        if (!parts) return bad_call(function, kNull);
        return give(std::make_unique<PartsObject>(), parts, function);
    });
}

firma_code firma_parts_add(firma_parts parts, const firma_part* part, uint32_t* index) {
    return guarded(__func__, [&, function = __func__] {
        if (!part) return bad_call(function, kNull);
        PartsObject* object = find<PartsObject>(parts.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        MovingPart made;
        if (const firma_code code = read_part(part, made, function)) return code;
        object->parts.push_back(std::move(made));
        if (index) *index = std::uint32_t(object->parts.size() - 1);
        return FIRMA_OK;
    });
}

firma_code firma_parts_set(firma_parts parts, uint32_t index, const firma_part* part) {
    return guarded(__func__, [&, function = __func__] {
        if (!part) return bad_call(function, kNull);
        PartsObject* object = find<PartsObject>(parts.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (index >= object->parts.size())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no part " + std::to_string(index));
        MovingPart made;
        if (const firma_code code = read_part(part, made, function)) return code;
        object->parts[index] = std::move(made);
        return FIRMA_OK;
    });
}

firma_code firma_parts_set_motions(firma_parts parts, const firma_motion* motions, size_t count) {
    return guarded(__func__, [&, function = __func__] {
        if (!motions && count) return bad_call(function, kNull);
        PartsObject* object = find<PartsObject>(parts.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (count != object->parts.size())
            return fail(FIRMA_ERROR_INVALID, function,
                        std::to_string(count) + " motions for " + std::to_string(object->parts.size()) + " parts");
        MovingPart tried;
        for (std::size_t k = 0; k < count; ++k) {
            tried.motion = motion_of(motions[k]);
            if (!takes_part(tried))
                return fail(FIRMA_ERROR_OUT_OF_RANGE, function, kBadMotion + (": part " + std::to_string(k)));
        }
        for (std::size_t k = 0; k < count; ++k) object->parts[k].motion = motion_of(motions[k]);
        return FIRMA_OK;
    });
}

firma_code firma_parts_get_count(firma_parts parts, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        const PartsObject* object = find<PartsObject>(parts.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *count = object->parts.size();
        return FIRMA_OK;
    });
}

firma_code firma_parts_release(firma_parts parts) {
    return release<PartsObject>(parts.id, __func__);
}

firma_code firma_cast_scene(const firma_scene* scene, const firma_mover* mover, const double path[3],
                            const firma_cast_options* options, firma_part_hit* hit) {
    return guarded(__func__, [&, function = __func__] {
        if (!scene || !mover || !path || !hit) return bad_call(function, kNull);
        return ask_of_scene(scene, mover, function, [&](const SceneThere& asked, const MoverThere& there) {
            TrailOptions chosen;
            if (const firma_code code = chosen.read(options, function)) return code;
            const Vec3 way{path[0], path[1], path[2]};
            put_part_hit(
                there.with([&](const auto&... shape) { return cast(asked.scene(), shape..., way, chosen.cast); }),
                *hit);
            chosen.put();
            return FIRMA_OK;
        });
    });
}

firma_code firma_cast_set_scene(const firma_scene* scene, const double* spheres, size_t count,
                                const firma_motion* motion, const firma_cast_options* options,
                                firma_set_part_hit* hit) {
    return guarded(__func__, [&, function = __func__] {
        if (!hit) return bad_call(function, kNull);
        SceneThere asked;
        if (const firma_code code = asked.read(scene, function)) return code;
        MovingSetThere set;
        if (const firma_code code = set.read(spheres, count, motion, function)) return code;
        CastOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        const SetPartHit met = cast(asked.scene(), set.spheres, set.motion, chosen);
        *hit = {};
        put_part_hit(met, hit->hit);
        hit->sphere = met.sphere;
        return FIRMA_OK;
    });
}

firma_code firma_cast_scene_any(const firma_scene* scene, const firma_mover* mover, const double path[3],
                                const firma_cast_options* options, uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        if (!scene || !mover || !path || !status) return bad_call(function, kNull);
        return ask_of_scene(scene, mover, function, [&](const SceneThere& asked, const MoverThere& there) {
            CastOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            const Vec3 way{path[0], path[1], path[2]};
            *status = std::uint32_t(
                there.with([&](const auto&... shape) { return cast_any(asked.scene(), shape..., way, chosen); }));
            return FIRMA_OK;
        });
    });
}

firma_code firma_overlap_scene(const firma_scene* scene, const firma_mover* mover, double fraction,
                               const firma_near_options* options, firma_part_near* found, size_t capacity,
                               size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!scene || !mover || !count || (!found && capacity)) return bad_call(function, kNull);
        return ask_of_scene(scene, mover, function, [&](const SceneThere& asked, const MoverThere& there) {
            NearOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            if (const firma_code code = judge_time(asked, fraction, function)) return code;
            std::vector<PartOverlap> all;
            const auto keep = [&](const PartOverlap& overlap) {
                all.push_back(overlap);
                return true;
            };
            const Status status = there.with(
                [&](const auto&... shape) { return overlap_each(asked.scene(), shape..., keep, fraction, chosen); });
            if (status == Status::kInvalid) return not_asked(*asked.world, chosen.room, kBadSphere, function);
            put_some(all, found, capacity, count, put_part_near);
            return FIRMA_OK;
        });
    });
}

firma_code firma_closest_scene(const firma_scene* scene, const double point[3], double reach, double fraction,
                               const firma_near_options* options, firma_part_near* near, uint32_t* found) {
    return guarded(__func__, [&, function = __func__] {
        if (!scene || !point || !near || !found) return bad_call(function, kNull);
        SceneThere asked;
        if (const firma_code code = asked.read(scene, function)) return code;
        NearOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        if (const firma_code code = judge_time(asked, fraction, function)) return code;
        PartNear nearest;
        nearest.status = Status::kInvalid;
        if (reach >= 0) nearest = closest(asked.scene(), {point[0], point[1], point[2]}, reach, fraction, chosen);
        if (nearest.status == Status::kInvalid)
            return not_asked(*asked.world, chosen.room, "a number is not finite or too large, or the reach negative",
                             function);
        *found = nearest.found();
        if (nearest.found()) put_nearest(nearest, *near);
        return FIRMA_OK;
    });
}

// SPDX-License-Identifier: MIT
// Parts that a level makes, and what is asked of one part.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/level_object.h"
#include "bindings/c/numbers.h"
#include "bindings/c/scenes.h"
#include "firma/part_edits.h"

namespace firma::c {
namespace {

static_assert(FIRMA_BLOCKED_STOPS == int(WhenBlocked::kStops) && FIRMA_BLOCKED_RETURNS == int(WhenBlocked::kReturns) &&
              FIRMA_BLOCKED_CRUSHES == int(WhenBlocked::kCrushes));

/// Where a part stands at time 0.
RigidMotion stands_at_start(const PartPath& path) {
    const Pose pose = part_pose(path, 0);
    return {pose.position, pose.rotation, {}, {}};
}

std::unique_ptr<PartsObject> parts_object(BrushParts made) {
    auto object = std::make_unique<PartsObject>();
    for (BrushPart& brush : made.parts) {
        MovingPart part(brush.world, stands_at_start(brush.path));
        part.entity = brush.entity;
        LevelPart given;
        given.breakable = breakable_of(brush);
        given.stops = stops_told(brush.path);
        given.brush = std::move(brush);
        given.brush.world = {};
        object->parts.push_back(std::move(part));
        object->given.push_back(std::move(given));
    }
    object->notes = std::move(made.notes);
    return object;
}

firma_part_info info_told(const MovingPart& part, const LevelPart* given) {
    firma_part_info out{};
    out.entity = part.entity;
    if (given) {
        out.when_blocked = std::uint32_t(given->brush.when_blocked);
        out.waits_for_trigger = given->brush.waits_for_trigger;
        out.breaks = given->brush.breaks;
    }
    out.mask = part.mask;
    put(part.bounds().low, out.low);
    put(part.bounds().high, out.high);
    out.face_count = part.world().face_count();
    out.motion = motion_told(part.motion);
    return out;
}

}  // namespace

firma_code PartThere::find_part(firma_parts parts, std::uint32_t index, const char* function) {
    object = find<PartsObject>(parts.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    if (index >= object->parts.size())
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no part " + std::to_string(index));
    part = &object->parts[index];
    given = index < object->given.size() ? &object->given[index] : nullptr;
    return FIRMA_OK;
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_parts_from_level(firma_level level, const firma_world_options* options, firma_parts* parts) {
    return guarded(__func__, [&, function = __func__] {
        if (!parts) return bad_call(function, kNull);
        const LevelObject* const object = find<LevelObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        WorldOptions chosen;
        ReadOptions unused;
        if (const firma_code code = read_options(options, chosen, unused, function)) return code;
        Result<BrushParts> made = make_brush_parts(object->level, chosen);
        if (!made) return fail(made.error());
        return give(parts_object(std::move(made).value()), parts, function);
    });
}

firma_code firma_parts_get(firma_parts parts, uint32_t index, firma_part_info* info) {
    return guarded(__func__, [&, function = __func__] {
        if (!info) return bad_call(function, kNull);
        if (!sized(info)) return bad_call(function, kWrongSize);
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        put_sized(info_told(*there.part, there.given), info);
        return FIRMA_OK;
    });
}

firma_code firma_parts_path(firma_parts parts, uint32_t index, firma_part_path* path) {
    return guarded(__func__, [&, function = __func__] {
        if (!path) return bad_call(function, kNull);
        if (!sized(path)) return bad_call(function, kWrongSize);
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        static const std::vector<firma_part_stop> none;
        put_sized(there.given ? path_told(there.given->brush.path, there.given->stops) : path_told({}, none), path);
        return FIRMA_OK;
    });
}

firma_code firma_parts_world(firma_parts parts, uint32_t index, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        return give(std::make_unique<WorldObject>(there.part->world()), world, function);
    });
}

firma_code firma_parts_notes(firma_parts parts, uint32_t* entities, const char** notes, size_t capacity,
                             size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        const PartsObject* const object = find<PartsObject>(parts.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        for (std::size_t k = 0; k < std::min(capacity, object->notes.size()); ++k) {
            if (entities) entities[k] = object->notes[k].entity;
            if (notes) notes[k] = object->notes[k].reason.c_str();
        }
        *count = object->notes.size();
        return FIRMA_OK;
    });
}

firma_code firma_parts_portals(firma_parts parts, uint32_t index, firma_world level, uint32_t* portals, size_t capacity,
                               size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!portals && capacity)) return bad_call(function, kNull);
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        const WorldObject* const object = find<WorldObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::vector<PortalId> found = portals_closed_by(object->world, *there.part);
        for (std::size_t k = 0; k < std::min(capacity, found.size()); ++k) portals[k] = found[k].value;
        *count = found.size();
        return FIRMA_OK;
    });
}

firma_code firma_parts_pose_in(firma_parts parts, uint32_t index, double fraction, const firma_pose* pose,
                               firma_pose* seen) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose || !seen) return bad_call(function, kNull);
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        if (!(fraction >= 0 && fraction <= 1) || !is_finite(vec(pose->position)) || !is_rotation(pose->rotation))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the fraction or the pose is not finite or out of range");
        put_pose(pose_in_part(*there.part, fraction, firma::c::pose_of(*pose)), *seen);
        return FIRMA_OK;
    });
}

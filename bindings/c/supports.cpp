// SPDX-License-Identifier: MIT
// What faces hold, and what an edit took from them.
#include "firma/support.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/level_object.h"
#include "bindings/c/scenes.h"

namespace firma::c {
namespace {

static_assert(FIRMA_SUPPORT_TOUCHES == int(SupportKind::kTouches) &&
              FIRMA_SUPPORT_STANDS == int(SupportKind::kStands) && FIRMA_SUPPORT_HANGS == int(SupportKind::kHangs));
static_assert(FIRMA_SUPPORT_KEPT == int(SupportLoss::kNone) && FIRMA_SUPPORT_LESS == int(SupportLoss::kSome) &&
              FIRMA_SUPPORT_LOST == int(SupportLoss::kAll));

struct SupportsObject final : Object {
    static constexpr Kind kKind = Kind::kSupports;
    static constexpr const char* kNoun = "supports";
    explicit SupportsObject(Supports of) : supports(std::move(of)) {}
    const Supports supports;
};

firma_code read_things(const firma_supported* given, std::size_t count, std::vector<SupportedThing>& things,
                       const char* function) {
    if (!given && count) return bad_call(function, kNull);
    if (count > std::numeric_limits<std::uint32_t>::max())
        return fail(FIRMA_ERROR_TOO_LARGE, function, "more than 2^32 - 1 things");
    things.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const firma_supported& from = given[k];
        if (from.kind > FIRMA_SUPPORT_HANGS || from.reserved != 0)
            return fail(FIRMA_ERROR_INVALID, function,
                        "thing " + std::to_string(k) + ": its kind is none, or reserved is not 0");
        SupportedThing thing;
        thing.entity = from.entity;
        thing.kind = SupportKind(from.kind);
        thing.box = {vec(from.low), vec(from.high)};
        thing.reach = from.reach;
        if (from.mask) thing.mask = from.mask;
        things.push_back(std::move(thing));
    }
    return FIRMA_OK;
}

firma_code give_supports(const World& world, const std::vector<SupportedThing>& things, firma_supports* out,
                         const char* function) {
    Result<Supports> found = find_supports(world, things);
    if (!found) return fail(found.error());
    return give(std::make_unique<SupportsObject>(std::move(found).value()), out, function);
}

/// The parts of a list that a level made, as it made them.
BrushParts parts_as_made(const PartsObject& object) {
    BrushParts made;
    for (std::size_t k = 0; k < object.given.size(); ++k) {
        BrushPart part = object.given[k].brush;
        part.world = object.parts[k].world();
        made.parts.push_back(std::move(part));
    }
    return made;
}

const Support* find_support(firma_supports supports, std::size_t thing, firma_code& code, const char* function) {
    const SupportsObject* const object = find<SupportsObject>(supports.id, function);
    code = FIRMA_ERROR_BAD_HANDLE;
    if (!object) return nullptr;
    if (thing < object->supports.things.size()) return &object->supports.things[thing];
    code = fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such thing");
    return nullptr;
}

firma_support_change change_told(const SupportChange& from) {
    firma_support_change out{};
    out.thing = std::uint32_t(from.thing);
    out.entity = from.entity;
    out.loss = std::uint32_t(from.loss);
    out.buried = from.buried;
    out.lost = from.lost.size();
    out.before = from.before;
    out.after = from.after;
    return out;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_supports_find(firma_world world, const firma_supported* things, size_t count,
                               firma_supports* supports) {
    return guarded(__func__, [&, function = __func__] {
        if (!supports) return bad_call(function, kNull);
        const WorldObject* const object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        std::vector<SupportedThing> all;
        if (const firma_code code = read_things(things, count, all, function)) return code;
        return give_supports(object->world, all, supports, function);
    });
}

firma_code firma_supports_from_level(firma_world world, firma_level level, firma_parts parts,
                                     firma_supports* supports) {
    return guarded(__func__, [&, function = __func__] {
        if (!supports) return bad_call(function, kNull);
        const WorldObject* const object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const LevelObject* const of = find<LevelObject>(level.id, function);
        if (!of) return FIRMA_ERROR_BAD_HANDLE;
        BrushParts made;
        if (parts.id != 0) {
            const PartsObject* const list = find<PartsObject>(parts.id, function);
            if (!list) return FIRMA_ERROR_BAD_HANDLE;
            made = parts_as_made(*list);
        }
        return give_supports(object->world, supported_entities(of->level, made), supports, function);
    });
}

firma_code firma_supports_get_count(firma_supports supports, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        const SupportsObject* const object = find<SupportsObject>(supports.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *count = object->supports.things.size();
        return FIRMA_OK;
    });
}

firma_code firma_supports_get(firma_supports supports, size_t thing, firma_support* support) {
    return guarded(__func__, [&, function = __func__] {
        if (!support) return bad_call(function, kNull);
        if (!sized(support)) return bad_call(function, kWrongSize);
        firma_code code = FIRMA_OK;
        const Support* const found = find_support(supports, thing, code, function);
        if (!found) return code;
        put_sized({0, found->thing.entity, std::uint32_t(found->thing.kind), 0, found->faces.size(), found->area,
                   found->lowered},
                  support);
        return FIRMA_OK;
    });
}

firma_code firma_supports_faces(firma_supports supports, size_t thing, uint32_t* faces, double* areas, size_t capacity,
                                size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const Support* const found = find_support(supports, thing, code, function);
        if (!found) return code;
        for (std::size_t k = 0; k < std::min(capacity, found->faces.size()); ++k) {
            if (faces) faces[k] = found->faces[k].face.id.value;
            if (areas) areas[k] = found->faces[k].area;
        }
        *count = found->faces.size();
        return FIRMA_OK;
    });
}

firma_code firma_supports_release(firma_supports supports) {
    return release<SupportsObject>(supports.id, __func__);
}

firma_code firma_supports_diff(firma_supports before, firma_world was, firma_world world, firma_support_change* changes,
                               size_t capacity, size_t* count, firma_supports* after) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!changes && capacity)) return bad_call(function, kNull);
        const SupportsObject* const object = find<SupportsObject>(before.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const WorldObject* const now = find<WorldObject>(world.id, function);
        if (!now) return FIRMA_ERROR_BAD_HANDLE;
        const WorldObject* old = nullptr;
        if (was.id != 0 && !(old = find<WorldObject>(was.id, function))) return FIRMA_ERROR_BAD_HANDLE;
        if (old && hash_world(old->world) != object->supports.world_hash)
            return fail(FIRMA_ERROR_INVALID, function, "`was` is not the world that the supports are of");
        SupportDiff diff = old ? diff_supports(object->supports, diff_worlds(old->world, now->world), now->world)
                               : diff_supports(object->supports, now->world);
        if (after) {
            auto made = std::make_unique<SupportsObject>(std::move(diff.after));
            if (const firma_code code = give(std::move(made), after, function)) return code;
        }
        for (std::size_t k = 0; k < std::min(capacity, diff.changes.size()); ++k)
            changes[k] = change_told(diff.changes[k]);
        *count = diff.changes.size();
        return FIRMA_OK;
    });
}

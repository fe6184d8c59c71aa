// SPDX-License-Identifier: MIT
// Debris: bodies that know their solids, put in, asked, aged, become ground.
#include "firma/debris.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/debris_object.h"
#include "bindings/c/numbers.h"

namespace firma::c {

DebrisObject* find_debris(firma_debris debris, firma_code& code, const char* function) {
    DebrisObject* const object = find<DebrisObject>(debris.id, function);
    code = FIRMA_ERROR_BAD_HANDLE;
    if (!object || !object->broken) return object;
    code = fail(FIRMA_ERROR_NO_MEMORY, function, "memory ran out in an earlier call with this debris: it is lost");
    return nullptr;
}

firma_code DebrisThere::find_both(firma_debris of, firma_bodies with, const char* function) {
    firma_code code = FIRMA_OK;
    if (!(debris = find_debris(of, code, function))) return code;
    if (!(bodies = find_bodies(with, code, function))) return code;
    return FIRMA_OK;
}

firma_code DebrisThere::find_piece(firma_debris of, firma_bodies with, firma_body_id id, const char* function) {
    if (const firma_code code = find_both(of, with, function)) return code;
    if (!bodies->bodies.find(id_of(id))) return fail(FIRMA_ERROR_INVALID, function, kNoSuchBody);
    if (debris->debris.find(bodies->bodies, id_of(id))) return FIRMA_OK;
    return fail(FIRMA_ERROR_INVALID, function, "the body is no debris: it has no solid");
}

namespace {

/// Above zero but for NaN: infinity is no limit.
bool is_limit(double number) {
    return number >= 0;
}

firma_code read_spheres(const double* numbers, std::size_t count, std::vector<Sphere>& spheres, const char* function) {
    if (count && !numbers) return bad_call(function, "a count without its array");
    for (std::size_t k = 0; k < count; ++k) {
        spheres.push_back({{numbers[4 * k], numbers[4 * k + 1], numbers[4 * k + 2]}, numbers[4 * k + 3]});
        if (!is_finite(spheres[k].centre) || !is_not_below_zero(spheres[k].radius))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a sphere to keep clear is not finite or out of range");
    }
    return FIRMA_OK;
}

}  // namespace

firma_code DebrisRulesThere::read(const firma_debris_rules* given, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_debris_rules whole;
    firma_debris_rules_defaults(&whole);
    take_sized(given, whole);
    if (whole.to_ground > 1) return fail(FIRMA_ERROR_INVALID, function, "to_ground must be 0 or 1");
    if (!is_limit(whole.max_age) || !is_limit(whole.max_asleep) || !is_limit(whole.min_to_ground) ||
        !is_limit(whole.max_overlap))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a rule is not a number, or negative");
    rules.max_bodies = std::size_t(whole.max_bodies);
    rules.max_spheres = std::size_t(whole.max_spheres);
    rules.max_age = whole.max_age;
    rules.max_asleep = whole.max_asleep;
    rules.to_ground = whole.to_ground != 0;
    rules.max_to_ground = std::size_t(whole.max_to_ground);
    rules.min_to_ground = whole.min_to_ground;
    rules.max_overlap = whole.max_overlap;
    if (const firma_code code = read_spheres(whole.keep_clear, whole.keep_clear_count, clear, function)) return code;
    rules.keep_clear = clear;
    return FIRMA_OK;
}

firma_debris_rules debris_rules_told(const DebrisRules& from) {
    firma_debris_rules out{};
    out.size = sizeof out;
    out.to_ground = from.to_ground;
    out.max_bodies = from.max_bodies;
    out.max_spheres = from.max_spheres;
    out.max_age = from.max_age;
    out.max_asleep = from.max_asleep;
    out.max_to_ground = from.max_to_ground;
    out.min_to_ground = from.min_to_ground;
    out.max_overlap = from.max_overlap;
    return out;
}

namespace {

/// The edits that a call made: what became ground is of the inside of its matter.
std::vector<DebrisFill> fills_of(const DebrisReport& report, const std::vector<std::uint32_t>& matters) {
    std::vector<DebrisFill> fills;
    for (std::size_t k = 0; k < report.fills.size(); ++k)
        fills.push_back(
            {report.fills[k].cutter, report.fills[k].pose, matter(report.world, matters[k]).inside.c_str()});
    return fills;
}

/// What each slot is of, before any of it goes.
std::vector<std::uint32_t> matters_by_slot(const Debris& debris) {
    std::vector<std::uint32_t> matters;
    for (const DebrisPiece& piece : debris.slots) matters.push_back(piece.matter);
    return matters;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_debris_create(firma_debris* debris) {
    return guarded(__func__, [&, function = __func__] {
        if (!debris) return bad_call(function, kNull);
        return give(std::make_unique<DebrisObject>(), debris, function);
    });
}

firma_code firma_debris_copy(firma_debris debris, firma_debris* copy) {
    return guarded(__func__, [&, function = __func__] {
        if (!copy) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const DebrisObject* const object = find_debris(debris, code, function);
        return object ? give(std::make_unique<DebrisObject>(object->debris), copy, function) : code;
    });
}

firma_code firma_debris_release(firma_debris debris) {
    return release<DebrisObject>(debris.id, __func__);
}

firma_code firma_debris_hash(firma_debris debris, uint64_t* hash) {
    return guarded(__func__, [&, function = __func__] {
        if (!hash) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const DebrisObject* const object = find_debris(debris, code, function);
        if (!object) return code;
        *hash = hash_debris(object->debris);
        return FIRMA_OK;
    });
}

firma_code firma_debris_add_chunk(firma_debris debris, firma_bodies bodies, firma_chunks chunks, size_t chunk,
                                  const firma_fit_options* fit, firma_body_id* id) {
    return guarded(__func__, [&, function = __func__] {
        if (!id) return bad_call(function, kNull);
        FitOptions chosen;
        if (const firma_code code = read_fit(fit, chosen, function)) return code;
        DebrisThere there;
        if (const firma_code code = there.find_both(debris, bodies, function)) return code;
        const ChunksObject* const object = find<ChunksObject>(chunks.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (chunk >= object->chunks.size()) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such chunk");
        const Result<BodyId> added =
            there.change([&](Bodies& all, Debris& of) { return add_debris(all, of, object->chunks[chunk], chosen); });
        if (!added) return fail(added.error());
        *id = {added.value().slot, added.value().use};
        return FIRMA_OK;
    });
}

firma_code firma_debris_get(firma_debris debris, firma_bodies bodies, firma_body_id id, firma_debris_piece* piece) {
    return guarded(__func__, [&, function = __func__] {
        if (!piece) return bad_call(function, kNull);
        if (!sized(piece)) return bad_call(function, kWrongSize);
        DebrisThere there;
        if (const firma_code code = there.find_piece(debris, bodies, id, function)) return code;
        const DebrisPiece& found = *there.debris->debris.find(there.bodies->bodies, id_of(id));
        firma_debris_piece out{};
        out.matter = found.matter;
        put(found.origin, out.origin);
        out.age = found.age;
        out.asleep_for = found.asleep_for;
        out.face_count = found.solid.face_count();
        out.broken = found.broken;
        out.never_ground = found.never_ground;
        out.of_part = found.of_part;
        put_sized(out, piece);
        return FIRMA_OK;
    });
}

firma_code firma_debris_world(firma_debris debris, firma_bodies bodies, firma_body_id id, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        DebrisThere there;
        if (const firma_code code = there.find_piece(debris, bodies, id, function)) return code;
        Result<World> made = make_world(there.debris->debris.find(there.bodies->bodies, id_of(id))->solid);
        if (!made) return fail(made.error());
        return give(std::make_unique<WorldObject>(std::move(made).value()), world, function);
    });
}

firma_code firma_debris_remove(firma_debris debris, firma_bodies bodies, firma_body_id id) {
    return guarded(__func__, [&, function = __func__] {
        DebrisThere there;
        if (const firma_code code = there.find_piece(debris, bodies, id, function)) return code;
        return there.change([&](Bodies& all, Debris& of) {
            remove_debris(all, of, id_of(id));
            return FIRMA_OK;
        });
    });
}

firma_code firma_debris_named(firma_debris debris, uint32_t list, firma_body_id* ids, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!ids && capacity)) return bad_call(function, kNull);
        if (list >= kDebrisLists) return fail(FIRMA_ERROR_INVALID, function, "there is no such list");
        firma_code code = FIRMA_OK;
        const DebrisObject* const object = find_debris(debris, code, function);
        if (!object) return code;
        const std::vector<BodyId>& all = object->named[list];
        for (std::size_t k = 0; k < std::min(capacity, all.size()); ++k) ids[k] = {all[k].slot, all[k].use};
        *count = all.size();
        return FIRMA_OK;
    });
}

void firma_debris_rules_defaults(firma_debris_rules* rules) {
    if (rules) *rules = debris_rules_told({});
}

firma_code firma_debris_tend(firma_debris debris, firma_bodies bodies, firma_world world, double seconds,
                             const firma_debris_rules* rules, firma_world* after, firma_debris_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        if (!is_not_below_zero(seconds))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the seconds are not finite, or negative");
        DebrisRulesThere chosen;
        if (const firma_code code = chosen.read(rules, function)) return code;
        const WorldObject* const level = find<WorldObject>(world.id, function);
        if (!level) return FIRMA_ERROR_BAD_HANDLE;
        DebrisThere there;
        if (const firma_code code = there.find_both(debris, bodies, function)) return code;
        const std::vector<std::uint32_t> by_slot = matters_by_slot(there.debris->debris);
        auto object = std::make_unique<WorldObject>(World{});
        firma_debris_report told{};
        there.change([&](Bodies& all, Debris& of) {
            DebrisReport made = tend_debris(level->world, all, of, seconds, chosen.rules);
            std::vector<std::uint32_t> matters;
            for (const BodyId id : made.to_ground) matters.push_back(by_slot[id.slot]);
            std::vector<DebrisFill> fills = fills_of(made, matters);
            told = {0, 0, made.removed.size(), made.to_ground.size(), made.refused, made.waiting};
            there.debris->forget();
            there.debris->fills.swap(fills);
            there.debris->filled = made.world;
            there.debris->named[FIRMA_DEBRIS_REMOVED].swap(made.removed);
            there.debris->named[FIRMA_DEBRIS_TO_GROUND].swap(made.to_ground);
            object->world = std::move(made.world);
            return 0;
        });
        if (const firma_code code = give(std::move(object), after, function)) {
            there.debris->broken = there.bodies->broken = true;  // its world is lost
            return code;
        }
        if (report) put_sized(told, report);
        return FIRMA_OK;
    });
}

firma_code firma_debris_fill(firma_debris debris, size_t fill, firma_cutter* cutter, firma_pose* pose,
                             const char** material) {
    return guarded(__func__, [&, function = __func__] {
        if (!cutter || !pose || !material) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const DebrisObject* const object = find_debris(debris, code, function);
        if (!object) return code;
        if (fill >= object->fills.size()) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such fill");
        const DebrisFill& found = object->fills[fill];
        if (const firma_code given = give(std::make_unique<CutterObject>(found.cutter), cutter, function)) return given;
        put_pose(found.pose, *pose);
        *material = found.material;
        return FIRMA_OK;
    });
}

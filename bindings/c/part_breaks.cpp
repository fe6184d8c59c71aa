// SPDX-License-Identifier: MIT
// Parts that break: what they bear, broken at once, or carved until they do.
#include "firma/break_parts.h"

#include <memory>
#include <utility>

#include "bindings/c/debris_object.h"
#include "bindings/c/numbers.h"
#include "bindings/c/scenes.h"

namespace firma::c {
namespace {

firma_breakable breakable_told(const Breakable& from) {
    firma_breakable out{};
    out.matter = from.matter.value_or(FIRMA_NO_MATTER);
    out.health = from.health;
    out.whole = from.whole;
    out.max_taken = from.max_taken;
    out.damage = from.damage;
    out.broken = from.broken;
    return out;
}

firma_code read_breakable(const firma_breakable* given, Breakable& breakable, const char* function) {
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_breakable whole = breakable_told({});
    take_sized(given, whole);
    if (whole.broken > 1 || whole.reserved != 0)
        return fail(FIRMA_ERROR_INVALID, function, "broken must be 0 or 1, reserved 0");
    if (!is_finite(whole.health) || !is_not_below_zero(whole.whole) ||
        !(whole.max_taken >= 0 && whole.max_taken <= 1) || !is_not_below_zero(whole.damage))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a number of the breakable is not finite or out of its range");
    breakable.health = whole.health;
    breakable.whole = whole.whole;
    breakable.max_taken = whole.max_taken;
    breakable.damage = whole.damage;
    breakable.broken = whole.broken != 0;
    if (whole.matter != FIRMA_NO_MATTER) breakable.matter = whole.matter;
    return FIRMA_OK;
}

firma_code read_break(const firma_break_options* given, BreakOptions& options, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_break_options whole;
    firma_break_options_defaults(&whole);
    take_sized(given, whole);
    if (whole.unbroken > 1 || whole.has_impact > 1 || whole.reserved != 0)
        return fail(FIRMA_ERROR_INVALID, function, "a flag is not 0 or 1, or reserved not 0");
    if (whole.max_pieces < 1 || whole.max_pieces > kMaxPieces || whole.max_spheres < 1 ||
        whole.max_spheres > kMaxSpheres || !(whole.fraction >= 0 && whole.fraction <= 1) ||
        !is_not_below_zero(whole.seconds) || !is_not_below_zero(whole.min_volume) || !is_finite(vec(whole.impact)))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "an option is not finite or out of its range");
    options.max_pieces = whole.max_pieces;
    options.max_spheres = whole.max_spheres;
    options.unbroken = whole.unbroken != 0;
    if (whole.has_impact) options.impact = vec(whole.impact);
    options.fraction = whole.fraction;
    options.seconds = whole.seconds;
    options.min_volume = whole.min_volume;
    options.seed = whole.seed;
    if (whole.portal_count && !whole.portals) return bad_call(function, "a count without its array");
    for (std::size_t k = 0; k < whole.portal_count; ++k) options.portals.push_back({whole.portals[k]});
    return FIRMA_OK;
}

firma_code read_part_cut(const firma_part_cut_options* given, PartCutOptions& options, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_part_cut_options whole;
    firma_part_cut_options_defaults(&whole);
    take_sized(given, whole);
    if (whole.hold_largest > 1) return fail(FIRMA_ERROR_INVALID, function, "hold_largest must be 0 or 1");
    if (!is_not_below_zero(whole.touch))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "touch is not finite, or negative");
    options.hold = whole.hold_largest ? PartHold::kLargest : PartHold::kLevel;
    options.touch = whole.touch;
    if (whole.carve)
        if (const firma_code code = read_cut(whole.carve, options.carve, function)) return code;
    return read_break(&whole.pieces, options.pieces, function);
}

firma_break_report break_told(const BrokenPart& from) {
    return {0, 0, from.pieces.size(), from.unfit, from.dust, from.dust_mass, from.opened.size()};
}

/// What both calls are given: a part, its level, debris, and what it bears.
struct PartToBreak {
    PartThere there;
    DebrisThere debris;
    const World* level = nullptr;
    Breakable breakable;
    bool has_breakable = false;

    firma_code read(firma_parts parts, std::uint32_t index, firma_world of, const firma_breakable* bears,
                    firma_debris into, firma_bodies bodies, const char* function) {
        if (bears) {
            if (const firma_code code = read_breakable(bears, breakable, function)) return code;
            has_breakable = true;
        }
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        const WorldObject* const object = find<WorldObject>(of.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        level = &object->world;
        if (has_breakable && breakable.matter && *breakable.matter >= matters_of(there.part->world()).matters.size())
            return fail(FIRMA_ERROR_INVALID, function, "the part's world has no such matter");
        return debris.find_both(into, bodies, function);
    }
    Breakable* bears() { return has_breakable ? &breakable : nullptr; }
    void give_back(firma_breakable* out) const {
        if (out) put_sized(breakable_told(breakable), out);
    }
};

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_parts_breakable(firma_parts parts, uint32_t index, firma_breakable* breakable) {
    return guarded(__func__, [&, function = __func__] {
        if (!breakable) return bad_call(function, kNull);
        if (!sized(breakable)) return bad_call(function, kWrongSize);
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        Breakable made;
        if (there.given && there.given->bears)
            made = there.given->breakable;
        else
            made.whole = mass_properties(there.part->world().solid(), 1).volume;
        put_sized(breakable_told(made), breakable);
        return FIRMA_OK;
    });
}

firma_code firma_breakable_hurt(firma_breakable* breakable, double damage, uint32_t* breaks) {
    return guarded(__func__, [&, function = __func__] {
        if (!breakable || !breaks) return bad_call(function, kNull);
        Breakable hurt;
        if (const firma_code code = read_breakable(breakable, hurt, function)) return code;
        if (!is_not_below_zero(damage))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the damage is not finite, or negative");
        *breaks = hurt_part(hurt, damage);
        put_sized(breakable_told(hurt), breakable);
        return FIRMA_OK;
    });
}

firma_code firma_parts_blast_felt(firma_parts parts, uint32_t index, firma_world level, const firma_blast* blast,
                                  double fraction, double* share) {
    return guarded(__func__, [&, function = __func__] {
        if (!share) return bad_call(function, kNull);
        Blast asked;
        if (const firma_code code = read_blast(blast, asked, function)) return code;
        PartThere there;
        if (const firma_code code = there.find_part(parts, index, function)) return code;
        const WorldObject* const object = find<WorldObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (!(fraction >= 0 && fraction <= 1))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the fraction is not within 0 and 1");
        *share = blast_felt(object->world, *there.part, asked, fraction);
        return FIRMA_OK;
    });
}

void firma_break_options_defaults(firma_break_options* options) {
    if (!options) return;
    const BreakOptions usual;
    *options = {};
    options->size = sizeof *options;
    options->max_pieces = std::uint32_t(usual.max_pieces);
    options->max_spheres = std::uint32_t(usual.max_spheres);
    options->min_volume = usual.min_volume;
    options->seed = usual.seed;
}

firma_code firma_parts_break(firma_parts parts, uint32_t index, firma_world level, firma_breakable* breakable,
                             firma_debris debris, firma_bodies bodies, const firma_break_options* options,
                             firma_world* after, firma_break_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        BreakOptions chosen;
        if (const firma_code code = read_break(options, chosen, function)) return code;
        PartToBreak it;
        if (const firma_code code = it.read(parts, index, level, breakable, debris, bodies, function)) return code;
        auto object = std::make_unique<WorldObject>(World{});
        BrokenPart made = it.debris.change([&](Bodies& all, Debris& of) {
            return break_part(*it.level, *it.there.part, it.bears(), all, of, chosen);
        });
        object->world = made.level;
        if (const firma_code code = give(std::move(object), after, function)) {
            it.debris.debris->broken = it.debris.bodies->broken = true;  // its world is lost
            return code;
        }
        it.give_back(breakable);
        if (report) put_sized(break_told(made), report);
        it.debris.debris->forget();
        it.debris.debris->named[FIRMA_DEBRIS_PIECES].swap(made.pieces);
        return FIRMA_OK;
    });
}

void firma_part_cut_options_defaults(firma_part_cut_options* options) {
    if (!options) return;
    *options = {};
    options->size = sizeof *options;
    options->touch = PartCutOptions{}.touch;
    firma_break_options_defaults(&options->pieces);
}

firma_code firma_parts_carve(firma_parts parts, uint32_t index, firma_world level, firma_breakable* breakable,
                             firma_cutter cutter, const firma_pose* pose, firma_debris debris, firma_bodies bodies,
                             const firma_part_cut_options* options, firma_world* after, firma_part_cut* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose || !after) return bad_call(function, kNull);
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        firma_part_cut whole{};
        if (report) take_sized(report, whole);
        if (whole.rest.size != 0 && !sized(&whole.rest)) return bad_call(function, kWrongSize);
        PartCutOptions chosen;
        if (const firma_code code = read_part_cut(options, chosen, function)) return code;
        const CutterObject* const taken = find<CutterObject>(cutter.id, function);
        if (!taken) return FIRMA_ERROR_BAD_HANDLE;
        PartToBreak it;
        if (const firma_code code = it.read(parts, index, level, breakable, debris, bodies, function)) return code;
        auto object = std::make_unique<WorldObject>(World{});
        PartCut made = it.debris.change([&](Bodies& all, Debris& of) {
            return carve_part(*it.level, *it.there.part, it.bears(), taken->cutter, firma::c::pose_of(*pose), all, of,
                              chosen);
        });
        object->world = made.level;
        if (const firma_code code = give(std::move(object), after, function)) {
            it.debris.debris->broken = it.debris.bodies->broken = true;  // its world is lost
            return code;
        }
        it.give_back(breakable);
        if (report) {
            firma_part_cut out{};
            out.status = std::uint32_t(made.status);
            out.loose = made.loose.size();
            out.unfit = made.unfit;
            out.broke = made.broken.has_value();
            out.volume = made.report.volume;
            out.opened = made.opened.size();
            if (whole.rest.size != 0) {
                put_sized(made.broken ? break_told(*made.broken) : firma_break_report{}, &whole.rest);
                out.rest = whole.rest;
            }
            put_sized(out, report);
        }
        it.debris.debris->forget();
        it.debris.debris->named[FIRMA_DEBRIS_LOOSE].swap(made.loose);
        if (made.broken) it.debris.debris->named[FIRMA_DEBRIS_PIECES].swap(made.broken->pieces);
        if (made.status == CarveStatus::kRefused) fail(made.error);
        return FIRMA_OK;
    });
}

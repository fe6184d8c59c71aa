// SPDX-License-Identifier: MIT
// Projectiles: arrays of the caller's that fly, and what happened to them.
#include "firma/projectiles.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bindings/c/bodies_object.h"
#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "bindings/c/scenes.h"
#include "bindings/c/shots_told.h"

namespace firma::c {
namespace {

static_assert(FIRMA_PROJECTILE_FLYING == int(ProjectileState::kFlying) &&
              FIRMA_PROJECTILE_STOPPED == int(ProjectileState::kStopped) &&
              FIRMA_PROJECTILE_EXPIRED == int(ProjectileState::kExpired));
static_assert(FIRMA_SHOT_RICOCHET == int(ShotEventKind::kRicochet) &&
              FIRMA_SHOT_ENTERED == int(ShotEventKind::kEntered) && FIRMA_SHOT_LEFT == int(ShotEventKind::kLeft) &&
              FIRMA_SHOT_PASSED == int(ShotEventKind::kPassed) && FIRMA_SHOT_STOPPED == int(ShotEventKind::kStopped) &&
              FIRMA_SHOT_EXPIRED == int(ShotEventKind::kExpired));

struct ShotEventsObject final : Object {
    static constexpr Kind kKind = Kind::kShotEvents;
    static constexpr const char* kNoun = "list of shot events";
    std::vector<firma_shot_event> events;
    std::vector<firma_shot_length> lengths;
};

Projectile projectile_of(const firma_projectile& from) {
    return {vec(from.position), vec(from.velocity), from.mass,       from.age,
            from.mask,          from.user,          from.world_hash, ProjectileState(from.state)};
}

}  // namespace

firma_projectile projectile_told(const Projectile& from) {
    firma_projectile out{};
    put(from.position, out.position);
    put(from.velocity, out.velocity);
    out.mass = from.mass;
    out.age = from.age;
    out.world_hash = from.world_hash;
    out.mask = from.mask;
    out.user = from.user;
    out.state = std::uint32_t(from.state);
    return out;
}

namespace {

firma_code read_projectiles(const firma_projectile* given, std::size_t count, std::vector<Projectile>& all,
                            const char* function) {
    if (!given && count) return bad_call(function, kNull);
    if (count > std::numeric_limits<std::uint32_t>::max())
        return fail(FIRMA_ERROR_TOO_LARGE, function, "more than 2^32 - 1 projectiles");
    all.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        if (given[k].state > FIRMA_PROJECTILE_EXPIRED || given[k].reserved != 0)
            return fail(FIRMA_ERROR_INVALID, function,
                        "projectile " + std::to_string(k) + ": its state is none, or reserved is not 0");
        all.push_back(projectile_of(given[k]));
    }
    return FIRMA_OK;
}

}  // namespace

ShotTerms terms_of(const firma_shot_terms& from) {
    return {from.ricochet_below, from.restitution, from.friction, from.resistance};
}

firma_shot_terms terms_told(const ShotTerms& from) {
    return {from.ricochet_below, from.restitution, from.friction, from.resistance};
}

namespace {

firma_shot_impact impact_told(const ShotImpact& from) {
    firma_shot_impact out{};
    put(from.point, out.point);
    put(from.normal, out.normal);
    put(from.velocity, out.velocity);
    put(from.surface, out.surface);
    out.mass = from.mass;
    out.projectile = from.projectile;
    out.face = from.face.id.value;
    put_corner(from.face, out.corner);
    out.portal = from.portal.value;
    out.body = {from.body.slot, from.body.use};
    out.material = from.material;
    out.pane = from.pane;
    out.part = from.part;
    return out;
}

/// Options, and the terms that they point to. It stays where it is, as the options point into it.
struct FlyThere {
    FlyOptions options;
    std::vector<ShotTerms> matters;
    firma_fly_options whole{};

    /// FlyOptions::rule of a caller's.
    static ShotTerms ask_rule(const ShotImpact& impact, std::uint32_t matter, void* user) {
        const firma_fly_options& given = static_cast<const FlyThere*>(user)->whole;
        firma_shot_terms terms = impact.body.slot == FIRMA_NO_BODY ? given.other : given.bodies;
        const firma_shot_impact told = impact_told(impact);
        given.rule(&told, matter, &terms, given.user);
        return terms_of(terms);
    }

    firma_code read(const firma_fly_options* given, const char* function) {
        firma_fly_options_defaults(&whole);
        if (given && !sized(given)) return bad_call(function, kWrongSize);
        if (given) take_sized(given, whole);
        if (whole.matter_count && !whole.matters) return bad_call(function, "a count without its array");
        if (whole.matter_count > kMaxMatters)
            return fail(FIRMA_ERROR_TOO_LARGE, function, "more terms than there may be matters");
        for (std::size_t k = 0; k < whole.matter_count; ++k) matters.push_back(terms_of(whole.matters[k]));
        options.gravity = vec(whole.gravity);
        options.max_bow = whole.max_bow;
        options.max_age = whole.max_age;
        options.stop_speed = whole.stop_speed;
        options.max_impacts = int(std::min(whole.max_impacts, std::uint32_t(std::numeric_limits<int>::max())));
        options.max_thickness = whole.max_thickness;
        options.pane_energy = whole.pane_energy;
        options.other = terms_of(whole.other);
        options.bodies = terms_of(whole.bodies);
        options.matters = matters;
        if (whole.rule) {
            options.rule = ask_rule;
            options.user = this;
        }
        return FIRMA_OK;
    }
};

}  // namespace

firma_shot_event event_told(const ShotEvent& from) {
    firma_shot_event out{};
    out.time = from.time;
    put(from.point, out.point);
    put(from.normal, out.normal);
    put(from.velocity, out.velocity);
    put(from.impulse, out.impulse);
    out.energy = from.energy;
    out.thickness = from.thickness;
    out.kind = std::uint32_t(from.kind);
    out.projectile = from.projectile;
    out.number = from.number;
    out.face = from.face.id.value;
    put_corner(from.face, out.corner);
    out.portal = from.portal.value;
    out.body = {from.body.slot, from.body.use};
    out.material = from.material;
    out.matter = from.matter;
    out.first_length = from.first_matter;
    out.length_count = from.matter_count;
    put(from.in_part, out.in_part);
    out.part = from.part;
    return out;
}

namespace {

void put_events(const ShotEvents& from, ShotEventsObject& out) {
    std::vector<firma_shot_event> events;
    std::vector<firma_shot_length> lengths;
    events.reserve(from.events.size());
    lengths.reserve(from.matters.size());
    for (const ShotEvent& it : from.events) events.push_back(event_told(it));
    for (const MatterLength& it : from.matters) lengths.push_back({it.from, it.to, it.matter, 0});
    out.events.swap(events);
    out.lengths.swap(lengths);
}

/// What projectiles fly among: looked up and good.
struct FlightThere {
    BodiesObject* bodies = nullptr;
    ShotEventsObject* events = nullptr;

    firma_code find_all(firma_bodies of, firma_shot_events into, const char* function) {
        firma_code code = FIRMA_OK;
        if (of.id != 0 && !(bodies = find_bodies(of, code, function))) return code;
        if (into.id != 0 && !(events = find<ShotEventsObject>(into.id, function))) return FIRMA_ERROR_BAD_HANDLE;
        return FIRMA_OK;
    }
};

/// The projectiles of one call.
struct ShotsThere {
    firma_projectile* projectiles = nullptr;
    std::size_t count = 0;
};

/// @param read_scene  fills the scene
template <class ReadScene>
firma_code fly_among(const ShotsThere& shots, const ReadScene& read_scene, firma_bodies bodies, double seconds,
                     const firma_fly_options* options, firma_shot_events events, firma_fly_report* report,
                     const char* function) {
    if (report && !sized(report)) return bad_call(function, kWrongSize);
    FlyThere chosen;
    if (const firma_code code = chosen.read(options, function)) return code;
    if (!(seconds > 0 && seconds <= kMaxFlightSeconds))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the seconds are not above zero and at most 1");
    SceneThere scene;
    if (const firma_code code = read_scene(scene)) return code;
    FlightThere there;
    if (const firma_code code = there.find_all(bodies, events, function)) return code;
    std::vector<Projectile> all;
    if (const firma_code code = read_projectiles(shots.projectiles, shots.count, all, function)) return code;
    const Tasks tasks = batch_tasks();
    if (tasks.run) chosen.options.tasks = &tasks;
    ShotEvents happened;
    if (there.bodies) there.bodies->broken = true;  // unless it comes back
    const Result<FlyReport> flown =
        fly(all, scene.scene(), seconds, happened, chosen.options, there.bodies ? &there.bodies->bodies : nullptr);
    if (flown && there.events) put_events(happened, *there.events);
    if (there.bodies) there.bodies->broken = false;
    if (!flown) return fail(flown.error());
    for (std::size_t k = 0; k < shots.count; ++k) shots.projectiles[k] = projectile_told(all[k]);
    if (report) put_sized({0, 0, flown.value().flying, flown.value().chords, flown.value().impacts}, report);
    return FIRMA_OK;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_projectile_defaults(firma_projectile* projectile) {
    if (projectile) *projectile = projectile_told({});
}

void firma_shot_terms_defaults(firma_shot_terms* terms) {
    if (terms) *terms = terms_told({});
}

void firma_fly_options_defaults(firma_fly_options* options) {
    if (!options) return;
    const FlyOptions usual;
    *options = {};
    options->size = sizeof *options;
    options->max_impacts = std::uint32_t(usual.max_impacts);
    put(usual.gravity, options->gravity);
    options->max_bow = usual.max_bow;
    options->max_age = usual.max_age;
    options->stop_speed = usual.stop_speed;
    options->max_thickness = usual.max_thickness;
    options->pane_energy = usual.pane_energy;
    options->other = terms_told(usual.other);
    options->bodies = terms_told(usual.bodies);
}

firma_code firma_shot_events_create(firma_shot_events* events) {
    return guarded(__func__, [&, function = __func__] {
        if (!events) return bad_call(function, kNull);
        return give(std::make_unique<ShotEventsObject>(), events, function);
    });
}

firma_code firma_shot_events_get_view(firma_shot_events events, firma_shot_view* view) {
    return guarded(__func__, [&, function = __func__] {
        if (!view) return bad_call(function, kNull);
        if (!sized(view)) return bad_call(function, kWrongSize);
        const ShotEventsObject* const object = find<ShotEventsObject>(events.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        put_sized({0, 0, object->events.data(), object->events.size(), object->lengths.data(), object->lengths.size()},
                  view);
        return FIRMA_OK;
    });
}

firma_code firma_shot_events_release(firma_shot_events events) {
    return release<ShotEventsObject>(events.id, __func__);
}

firma_code firma_fly(firma_projectile* projectiles, size_t count, firma_world world, firma_bodies bodies,
                     double seconds, const firma_fly_options* options, firma_shot_events events,
                     firma_fly_report* report) {
    return guarded(__func__, [&, function = __func__] {
        const auto read_scene = [&](SceneThere& there) {
            const WorldObject* const object = find<WorldObject>(world.id, function);
            if (!object) return FIRMA_ERROR_BAD_HANDLE;
            there.world = &object->world;
            return FIRMA_OK;
        };
        return fly_among({projectiles, count}, read_scene, bodies, seconds, options, events, report, function);
    });
}

firma_code firma_fly_scene(firma_projectile* projectiles, size_t count, const firma_scene* scene, firma_bodies bodies,
                           double seconds, const firma_fly_options* options, firma_shot_events events,
                           firma_fly_report* report) {
    return guarded(__func__, [&, function = __func__] {
        const auto read_scene = [&](SceneThere& there) {
            if (const firma_code code = there.read(scene, function)) return code;
            if (there.has_stretch()) return FIRMA_OK;
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the scene's stretch is not within 0..1");
        };
        return fly_among({projectiles, count}, read_scene, bodies, seconds, options, events, report, function);
    });
}

firma_code firma_projectiles_hash(const firma_projectile* projectiles, size_t count, uint64_t* hash) {
    return guarded(__func__, [&, function = __func__] {
        if (!hash) return bad_call(function, kNull);
        std::vector<Projectile> all;
        if (const firma_code code = read_projectiles(projectiles, count, all, function)) return code;
        *hash = hash_projectiles(all);
        return FIRMA_OK;
    });
}
